#include "game/heap_meter.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace rambla::game {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

TEST(HeapMeter, LeavesTheHeapToASanitizer) {
    EXPECT_EQ(heap_bytes(), 0u);
}

#else

constexpr std::size_t k_bytes = 1u << 20u;
constexpr double k_rounding_bytes = 8192.0;  // allocators round up to pages

double heap() {
    return static_cast<double>(heap_bytes());
}

TEST(HeapMeter, CountsWhatIsInUse) {
    const double before = heap();
    auto block = std::make_unique<char[]>(k_bytes);
    EXPECT_NEAR(heap() - before, static_cast<double>(k_bytes), k_rounding_bytes);
    block.reset();
    EXPECT_NEAR(heap() - before, 0.0, k_rounding_bytes);
}

TEST(HeapMeter, CountsOverAlignedBlocks) {
    struct alignas(256) Wide {
        char bytes[k_bytes];
    };
    const double before = heap();
    auto block = std::make_unique<Wide>();
    EXPECT_NEAR(heap() - before, static_cast<double>(k_bytes), k_rounding_bytes);
    block.reset();
    EXPECT_NEAR(heap() - before, 0.0, k_rounding_bytes);
}

TEST(HeapMeter, AnotherThreadMayFree) {
    const double before = heap();
    auto block = std::make_unique<char[]>(k_bytes);
    std::thread{[block = std::move(block)]() mutable {
        block.reset();
    }}.join();
    EXPECT_NEAR(heap() - before, 0.0, k_rounding_bytes);
}

#endif

}  // namespace
}  // namespace rambla::game
