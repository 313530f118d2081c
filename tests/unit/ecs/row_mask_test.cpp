#include "ecs/row_mask.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace rambla::ecs {
namespace {

TEST(RowMask, HoldsTheFirstRows) {
    for (std::size_t count : {0u, 1u, 63u, 64u, 65u, 1000u, 1023u, 1024u}) {
        const RowMask mask = RowMask::first(count);
        EXPECT_EQ(mask.count(), count);
        EXPECT_EQ(mask.any(), count != 0);
        for (std::size_t row = 0; row < RowMask::k_rows; ++row)
            ASSERT_EQ(mask.test(row), row < count) << count;
    }
}

TEST(RowMask, OfZerosAgreesWithLookingAtEachByte) {
    std::mt19937 random{1};
    std::vector<std::uint8_t> bytes(RowMask::k_rows);
    for (std::uint8_t& byte : bytes)
        byte = random() % 3 == 0 ? 1 : 0;
    for (std::size_t count : {0u, 1u, 7u, 8u, 9u, 64u, 777u, 1024u}) {
        const RowMask mask = RowMask::of_zeros(bytes.data(), count);
        for (std::size_t row = 0; row < RowMask::k_rows; ++row)
            ASSERT_EQ(mask.test(row), row < count && bytes[row] == 0) << row << " of " << count;
    }
}

TEST(RowMask, OfZerosIsNotMovedByWhatStandsBehindTheLastByte) {
    std::array<std::uint8_t, 8> bytes{0, 1, 0, 0xff, 0xff, 0xff, 0xff, 0xff};
    EXPECT_EQ(RowMask::of_zeros(bytes.data(), 3).words()[0], 0b101u);
}

TEST(RowMask, GoesThroughItsRowsInOrder) {
    RowMask mask = RowMask::first(130);
    mask.reset(5);
    mask.reset(127);
    mask.set(1023);
    std::vector<std::size_t> rows;
    mask.for_each([&](std::size_t row) { rows.push_back(row); });
    std::vector<std::size_t> expected;
    for (std::size_t row = 0; row < RowMask::k_rows; ++row) {
        if (mask.test(row)) expected.push_back(row);
    }
    EXPECT_EQ(rows, expected);
    EXPECT_EQ(rows.size(), 129u);
    rows.clear();
    for (std::size_t row : mask)
        rows.push_back(row);
    EXPECT_EQ(rows, expected);
    for (std::size_t row : RowMask{})
        FAIL() << row << " of an empty set";
}

TEST(RowMask, CombinesAsSets) {
    RowMask even;
    even.set(0);
    even.set(2);
    RowMask mask = RowMask::first(3);
    mask &= even;
    EXPECT_EQ(mask, even);
    mask |= RowMask::first(2);
    EXPECT_EQ(mask, RowMask::first(3));
    mask -= even;
    EXPECT_TRUE(mask.test(1));
    EXPECT_EQ(mask.count(), 1u);
    mask = RowMask::first(1024);
    mask.keep_if([](std::size_t row) { return row % 10 == 0; });
    EXPECT_EQ(mask.count(), 103u);
}

}  // namespace
}  // namespace rambla::ecs
