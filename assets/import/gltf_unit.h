#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace rambla::assets::gltf {

/// The bits of the largest |value − 1|, which compare as the numbers do; those of NaN are larger than all.
template <std::size_t N>
std::uint32_t largest_bits_from_one(const std::array<float, N>& values) {
    std::uint32_t largest = 0;
    for (const float value : values)
        largest = std::max(largest, std::bit_cast<std::uint32_t>(std::abs(value - 1.0f)));
    return largest;
}

/// Scales the directions (x, y, z) of vectors to unit length. Those that are so to storage accuracy keep
/// their bits; those without a direction, and what overflows, go to `fallback(index)`.
template <class Vector, class Fallback>
void make_unit(std::span<Vector> vectors, const Fallback& fallback) {
    constexpr float k_storage_error = 1e-4f;
    constexpr float k_no_length = 1e-12f;
    // In blocks of short loops without branches, so that the compiler takes several square roots at once.
    constexpr std::size_t k_block = 64;
    std::array<float, k_block> squared;
    squared.fill(1.0f);
    std::array<float, k_block> scales{};
    for (std::size_t first = 0; first < vectors.size(); first += k_block) {
        const std::span<Vector> block = vectors.subspan(first, std::min(k_block, vectors.size() - first));
        for (std::size_t i = 0; i < block.size(); ++i)
            squared[i] = block[i].x * block[i].x + block[i].y * block[i].y + block[i].z * block[i].z;
        if (largest_bits_from_one(squared) < std::bit_cast<std::uint32_t>(k_storage_error)) continue;
        for (std::size_t i = 0; i < k_block; ++i)
            scales[i] = 1.0f / std::sqrt(squared[i]);
        for (std::size_t i = 0; i < k_block; ++i)
            scales[i] = std::abs(squared[i] - 1.0f) < k_storage_error ? 1.0f : scales[i];
        for (std::size_t i = 0; i < block.size(); ++i) {
            block[i].x *= scales[i];
            block[i].y *= scales[i];
            block[i].z *= scales[i];
            if (!(squared[i] > k_no_length && squared[i] <= std::numeric_limits<float>::max()))
                fallback(first + i);
        }
    }
}

}  // namespace rambla::assets::gltf
