#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assets/processed.h"

namespace rambla::assets {

/// What Cache keeps of a processed mesh or texture: one sequence of bytes for each content, so that what is
/// read again is equal bit by bit.
[[nodiscard]] std::vector<std::byte> to_payload(const ProcessedMesh& mesh);
/// @param texture  levels from the finest down to 1×1, each half of the one before, without gaps between
/// them; all of
///                 them stored
[[nodiscard]] std::vector<std::byte> to_payload(const TextureData& texture);

/// What a payload holds, or nothing unless all of it is sound: counts and sizes that agree, indices and
/// ranges that lie inside of what they refer to, enums that exist, finite positions and bounds, errors that
/// do not decrease. Any bytes may be given; no more is allocated than five times their number.
[[nodiscard]] std::optional<ProcessedMesh> mesh_from_payload(std::span<const std::byte> payload);
[[nodiscard]] std::optional<TextureData> texture_from_payload(std::span<const std::byte> payload);

}  // namespace rambla::assets
