#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace rambla::ecs::property {

/// One step of a random run: what to do, and numbers that choose the details. Plain data, so that a run can
/// be repeated, shortened and printed.
struct Operation {
    std::uint32_t kind = 0;
    std::uint32_t a = 0, b = 0, c = 0;
};

using Sequence = std::vector<Operation>;

/// @param weights  how often each kind comes, relative to the others
[[nodiscard]] Sequence random_sequence(std::uint64_t seed, std::size_t length,
                                       std::span<const std::uint32_t> weights);

/// A short sequence that still fails, made by leaving out ever smaller parts of one that does.
/// @param fails  plays a sequence from the beginning
/// @param tries  how often it may be called
[[nodiscard]] Sequence shrink(Sequence failing, const std::function<bool(const Sequence&)>& fails,
                              std::size_t tries);

}  // namespace rambla::ecs::property
