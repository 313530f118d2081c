#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>

namespace rambla::assets::gltf {

/// The bits of |value − 1|, which compare as the numbers do; those of NaN are larger than all.
inline std::uint32_t bits_from_one(float value) {
    return std::bit_cast<std::uint32_t>(std::abs(value - 1.0f));
}

template <std::size_t N>
std::uint32_t largest_bits_from_one(const std::array<float, N>& values) {
    std::uint32_t largest = 0;
    for (const float value : values)
        largest = std::max(largest, bits_from_one(value));
    return largest;
}

/// Lengths are squared, and within this of 1: as close as what stores directions comes.
inline constexpr float k_storage_error = 1e-4f;

template <class Vector>
float squared_length(const Vector& vector) {
    return vector.x * vector.x + vector.y * vector.y + vector.z * vector.z;
}

/// Whether make_unit leaves all directions as they are. If so, they are finite.
template <class Vector>
bool are_unit(std::span<const Vector> vectors) {
    std::uint32_t largest = 0;
    for (const Vector& vector : vectors)
        largest = std::max(largest, bits_from_one(squared_length(vector)));
    return largest < std::bit_cast<std::uint32_t>(k_storage_error);
}

/// Scales the directions (x, y, z) of vectors to unit length. Those that are so to storage accuracy keep
/// their bits; those without a direction, and what overflows, go to `fallback(index)`.
template <class Vector, class Fallback>
void make_unit(std::span<Vector> vectors, const Fallback& fallback) {
    constexpr float k_no_length = 1e-12f;
    // In blocks of short loops without branches, so that the compiler takes several square roots at once.
    constexpr std::size_t k_block = 64;
    std::array<float, k_block> squared;
    squared.fill(1.0f);
    std::array<float, k_block> scales{};
    for (std::size_t first = 0; first < vectors.size(); first += k_block) {
        const std::span<Vector> block = vectors.subspan(first, std::min(k_block, vectors.size() - first));
        for (std::size_t i = 0; i < block.size(); ++i)
            squared[i] = squared_length(block[i]);
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

/// Whether the last components are all −1 or 1.
inline bool are_signs(std::span<const glm::vec4> tangents) {
    constexpr std::uint32_t k_magnitude = 0x7fffffffu;  // all bits but the sign
    constexpr auto k_one = std::bit_cast<std::uint32_t>(1.0f);
    std::uint32_t differing = 0;
    for (const glm::vec4& tangent : tangents)
        differing |= (std::bit_cast<std::uint32_t>(tangent.w) & k_magnitude) ^ k_one;
    return differing == 0;
}

/// Makes the last components −1 where they are below 0, else 1.
inline void make_signs(std::span<glm::vec4> tangents) {
    for (glm::vec4& tangent : tangents)
        tangent.w = tangent.w < 0.0f ? -1.0f : 1.0f;
}

}  // namespace rambla::assets::gltf
