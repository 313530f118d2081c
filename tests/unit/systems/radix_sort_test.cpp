#include "systems/pack/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/allocation_counter.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

struct Pairs {
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> values;
};

/// Keys that differ only in the bits of `mask`, with many ties when it has few; values tell equal keys apart.
Pairs random_pairs(std::size_t size, std::uint64_t mask) {
    test::Random random{static_cast<std::uint32_t>(size)};
    Pairs pairs{std::vector<std::uint64_t>(size), std::vector<std::uint32_t>(size)};
    for (std::uint64_t& key : pairs.keys)
        key = (random.bits() & mask) | (0x5a5a5a5a5a5a5a5aull & ~mask);
    std::iota(pairs.values.begin(), pairs.values.end(), 0u);
    return pairs;
}

Pairs stable_sorted(const Pairs& pairs) {
    std::vector<std::uint32_t> order(pairs.values);
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return pairs.keys[a] < pairs.keys[b]; });
    Pairs sorted;
    for (const std::uint32_t i : order) {
        sorted.keys.push_back(pairs.keys[i]);
        sorted.values.push_back(pairs.values[i]);
    }
    return sorted;
}

TEST(RadixSort, EqualsAStableSort) {
    RadixSort sort;
    for (const std::size_t size : {0u, 1u, 2u, 3u, 100u, 2047u, 32768u, 32769u, 200000u}) {
        for (const std::uint64_t mask :
             {~std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{0xff}, std::uint64_t{0x8000000000000001},
              std::uint64_t{0x0030000000700000}}) {
            Pairs pairs = random_pairs(size, mask);
            const Pairs expected = stable_sorted(pairs);
            sort(pairs.keys, pairs.values);
            ASSERT_EQ(pairs.keys, expected.keys) << size << ' ' << mask;
            ASSERT_EQ(pairs.values, expected.values) << "ties keep their order: " << size << ' ' << mask;
        }
    }
}

TEST(RadixSort, SortsAgainWithoutAllocating) {
    RadixSort sort;
    Pairs warm = random_pairs(20000, ~std::uint64_t{0});
    sort(warm.keys, warm.values);
    Pairs pairs = random_pairs(20000, ~std::uint64_t{0});
    const std::size_t before = test::allocation_count();
    sort(pairs.keys, pairs.values);
    EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::systems
