#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rambla::ecs {

/// 64-bit checksum of our own against accidents (not against malice): four lanes of multiply and shift,
/// folded at the end. Every step is a bijection of its lane, so two inputs of equal length that differ in one
/// 8-byte word at a multiple of 8, hence in any one bit or byte, never share a checksum; other accidents go
/// unseen about once in 2⁶⁴. The same on every machine.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace rambla::ecs
