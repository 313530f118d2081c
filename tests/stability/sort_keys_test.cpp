#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "systems/pack/radix_sort.h"
#include "systems/pack/sort_key.h"

namespace rambla::systems {
namespace {

/// Positive floats of all magnitudes, ascending, with the borders between denormal, normal and infinite.
std::vector<float> positive_floats() {
    std::vector<float> values{0.0f,
                              std::numeric_limits<float>::denorm_min(),
                              std::numeric_limits<float>::min(),
                              std::nextafter(std::numeric_limits<float>::min(), 0.0f),
                              std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::infinity()};
    std::mt19937 engine{1};
    std::uniform_int_distribution<std::uint32_t> bits{0, 0x7f7fffffu};
    for (int i = 0; i < 200000; ++i)
        values.push_back(std::bit_cast<float>(bits(engine)));
    std::sort(values.begin(), values.end());
    return values;
}

TEST(SortKeyStability, OrderIsMonotoneOverAllPositiveFloats) {
    const std::vector<float> depths = positive_floats();
    constexpr auto k_surfaces = DrawPass::surfaces;
    for (std::size_t i = 1; i < depths.size(); ++i) {
        ASSERT_LE(opaque_key(k_surfaces, 0, 1, 2, 3, depths[i - 1]),
                  opaque_key(k_surfaces, 0, 1, 2, 3, depths[i]));
        if (depths[i - 1] == depths[i]) continue;
        ASSERT_GT(blended_key(k_surfaces, 0, depths[i - 1], 1, 2),
                  blended_key(k_surfaces, 0, depths[i], 1, 2));
    }
}

TEST(SortKeyStability, DepthNeverSpillsIntoOtherFields) {
    for (const float depth :
         {-1.0f, -0.0f, 0.0f, 1e-45f, 3e38f, std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
          -std::numeric_limits<float>::quiet_NaN()}) {
        const SortKey opaque = opaque_key(DrawPass::surfaces, 5, 9, 77, 1234, depth);
        EXPECT_EQ(opaque >> 15u, opaque_key(DrawPass::surfaces, 5, 9, 77, 1234, 1.0f) >> 15u) << depth;
        const SortKey blended = blended_key(DrawPass::surfaces, 5, depth, 9, 77);
        EXPECT_EQ(blended >> 56u, blended_key(DrawPass::surfaces, 5, 1.0f, 9, 77) >> 56u) << depth;
        EXPECT_EQ(blended & 0x1ffffffu, blended_key(DrawPass::surfaces, 5, 1.0f, 9, 77) & 0x1ffffffu)
            << depth;
    }
}

TEST(SortKeyStability, DepthsTellAHundredthApartInOpaqueQueues) {
    // Seven bits of mantissa: steps of 1/128 at most, at any distance.
    for (const float depth : {1e-30f, 0.07f, 1.0f, 333.0f, 1e9f}) {
        EXPECT_LT(opaque_key(DrawPass::surfaces, 0, 0, 0, 0, depth),
                  opaque_key(DrawPass::surfaces, 0, 0, 0, 0, depth * 1.0079f));
    }
}

TEST(SortKeyStability, TiesKeepTheirOrder) {
    std::vector<SortKey> keys(100000, opaque_key(DrawPass::surfaces, 0, 1, 2, 3, 4.0f));
    for (std::size_t i = 0; i < keys.size(); i += 3)
        keys[i] = blended_key(DrawPass::surfaces, 0, 7.0f, 1, 2);
    std::vector<std::uint32_t> rows(keys.size());
    for (std::uint32_t i = 0; i < rows.size(); ++i)
        rows[i] = i;
    RadixSort{}(keys, rows);
    for (std::size_t i = 1; i < keys.size(); ++i) {
        if (keys[i] == keys[i - 1]) {
            ASSERT_LT(rows[i - 1], rows[i]);
        }
        ASSERT_LE(keys[i - 1], keys[i]);
    }
}

}  // namespace
}  // namespace rambla::systems
