#include "ecs/memory.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

constexpr std::size_t k_gibibyte = std::size_t{1} << 30u;

TEST(ReservedMemory, CommitsNothingUntilAsked) {
    const ReservedMemory memory{16 * k_gibibyte};
    EXPECT_EQ(memory.committed_bytes(), 0u);
    EXPECT_GE(memory.reserved_bytes(), 16 * k_gibibyte);
}

TEST(ReservedMemory, KeepsItsAddressAndContentsWhenItGrows) {
    ReservedMemory memory{k_gibibyte};
    memory.commit(100);
    const std::byte* before = memory.data();
    std::memset(memory.data(), 7, 100);
    memory.commit(10'000'000);
    if (ReservedMemory::grows_in_place) {
        EXPECT_EQ(memory.data(), before);
    }
    EXPECT_TRUE(
        std::all_of(memory.data(), memory.data() + 100, [](std::byte b) { return b == std::byte{7}; }));
    EXPECT_EQ(memory.data()[9'999'999], std::byte{0});
    EXPECT_GE(memory.committed_bytes(), 10'000'000u);
    EXPECT_LE(memory.committed_bytes(), 10'000'000u + 65'536u) << "at most one page more, whatever its size";
}

TEST(ReservedMemory, IsAlignedForColumns) {
    ReservedMemory memory{k_gibibyte};
    memory.commit(1);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory.data()) % 64, 0u);
}

const std::size_t k_page_bytes = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));

std::size_t page_in_table(const ReservedMemory& memory) {
    return reinterpret_cast<std::uintptr_t>(memory.data()) / k_page_bytes % ReservedMemory::k_pages_per_table;
}

/// Of address space, by this process.
std::size_t mapped_bytes() {
    std::ifstream maps{"/proc/self/maps"};
    std::size_t bytes = 0, first = 0, last = 0;
    char dash = 0;
    for (std::string line; std::getline(maps, line);) {
        std::istringstream{line} >> std::hex >> first >> dash >> last;
        bytes += last - first;
    }
    return bytes;
}

TEST(ReservedMemory, BeginsAtThePageThatWasChosen) {
    if (!ReservedMemory::grows_in_place) GTEST_SKIP() << "nothing is reserved on this system";
    for (const std::size_t page : {0u, 1u, 37u, 511u}) {
        ReservedMemory memory{k_gibibyte, page};
        EXPECT_EQ(page_in_table(memory), page);
        EXPECT_EQ(memory.reserved_bytes(), k_gibibyte);
        memory.commit(memory.reserved_bytes() - 1);  // the last page is its own
        memory.data()[k_gibibyte - 1] = std::byte{1};
        EXPECT_THROW(memory.commit(k_gibibyte + 1), CapacityExceeded);
        memory.decommit(k_page_bytes + 1);
        EXPECT_EQ(memory.committed_bytes(), 2 * k_page_bytes);
        memory.commit(k_gibibyte);
        EXPECT_EQ(memory.data()[k_gibibyte - 1], std::byte{0});
    }
    EXPECT_EQ(ReservedMemory(0, 7).data(), nullptr);
}

TEST(ReservedMemory, GivesBackAllThatItReservedAlsoAfterMoves) {
    if (!ReservedMemory::grows_in_place) GTEST_SKIP() << "nothing is reserved on this system";
    const std::size_t before = mapped_bytes();
    for (std::size_t i = 0; i < 64; ++i) {
        ReservedMemory one{k_gibibyte, 256 + i};
        ReservedMemory other{k_gibibyte, 255 - i};
        EXPECT_GE(mapped_bytes(), before + 2 * k_gibibyte);
        ReservedMemory moved{std::move(one)};
        moved.commit(100);
        other = std::move(moved);
        EXPECT_GE(other.committed_bytes(), 100u);
    }
    // Were only 192 of the 512 spare pages forgotten each time, 48 MiB would be left. The heap may have
    // grown.
    EXPECT_LT(mapped_bytes(), before + (16u << 20u));
}

TEST(ReservedMemory, RefusesMoreThanWasReservedAndStaysAsItIs) {
    ReservedMemory memory{1 << 20};
    memory.commit(4096);
    memory.data()[0] = std::byte{1};
    EXPECT_THROW(memory.commit(memory.reserved_bytes() + 1), CapacityExceeded);
    EXPECT_EQ(memory.data()[0], std::byte{1});
}

TEST(ReservedMemory, RefusesAnImpossibleReservation) {
    if (!ReservedMemory::grows_in_place) GTEST_SKIP() << "nothing is reserved on this system";
    EXPECT_THROW(ReservedMemory{std::size_t{1} << 60u}, CapacityExceeded);
}

TEST(ReservedMemory, GivesItsTailBackAndGrowsAgainFromZero) {
    if (!ReservedMemory::grows_in_place) GTEST_SKIP() << "nothing goes back on this system";
    ReservedMemory memory{k_gibibyte};
    memory.commit(10'000'000);
    std::memset(memory.data(), 7, 10'000'000);
    const std::byte* before = memory.data();
    memory.decommit(100'000);
    EXPECT_EQ(memory.data(), before);
    EXPECT_LE(memory.committed_bytes(), 100'000u + 65'536u);
    EXPECT_EQ(memory.data()[99'999], std::byte{7});
    memory.decommit(5'000'000);
    EXPECT_LE(memory.committed_bytes(), 100'000u + 65'536u) << "never more than there was";
    memory.commit(10'000'000);
    EXPECT_EQ(memory.data()[99'999], std::byte{7});
    EXPECT_EQ(memory.data()[9'000'000], std::byte{0});
}

TEST(ReservedMemory, MovingHandsTheRangeOver) {
    ReservedMemory first{k_gibibyte};
    first.commit(1);
    first.data()[0] = std::byte{9};
    ReservedMemory second{k_gibibyte};
    second = std::move(first);
    EXPECT_EQ(second.data()[0], std::byte{9});
    ReservedMemory third{std::move(second)};
    EXPECT_EQ(third.data()[0], std::byte{9});
}

}  // namespace
}  // namespace rambla::ecs
