#include "ecs/checksum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace rambla::ecs {
namespace {

std::vector<std::byte> ramp(std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<std::byte>(i * 7 + 1);
    return bytes;
}

TEST(Checksum, SeesEveryBitAtEveryLength) {
    for (std::size_t size = 0; size <= 100; ++size) {
        std::vector<std::byte> bytes = ramp(size);
        std::set<std::uint64_t> seen{checksum(bytes)};
        for (std::size_t bit = 0; bit < size * 8; ++bit) {
            bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
            EXPECT_TRUE(seen.insert(checksum(bytes)).second) << "size " << size << ", bit " << bit;
            bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
        }
    }
}

TEST(Checksum, SeesZerosAppendedAndWordsSwapped) {
    std::set<std::uint64_t> seen;
    for (std::size_t size = 0; size <= 200; ++size)
        EXPECT_TRUE(seen.insert(checksum(std::vector<std::byte>(size))).second) << size;
    std::vector<std::byte> bytes = ramp(96);
    const std::uint64_t before = checksum(bytes);
    std::swap_ranges(bytes.begin(), bytes.begin() + 8, bytes.begin() + 8);
    EXPECT_NE(checksum(bytes), before);
    bytes = ramp(96);
    std::swap_ranges(bytes.begin(), bytes.begin() + 32, bytes.begin() + 32);
    EXPECT_NE(checksum(bytes), before);
}

TEST(Checksum, StaysWhatItWas) {
    // Written into files: it may never change.
    EXPECT_EQ(checksum(ramp(0)), 2001806664288472497u);
    EXPECT_EQ(checksum(ramp(77)), 13096874391674457976u);
}

}  // namespace
}  // namespace rambla::ecs
