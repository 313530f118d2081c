#include "ecs/block_pool.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace rambla::ecs {
namespace {

TEST(BlockPool, GivesAlignedBlocksThatDoNotOverlap) {
    BlockPool pool;
    std::mt19937 random{1};
    std::uniform_int_distribution<std::size_t> size{1, 20'000};  // above 16 KiB from the heap
    struct Block {
        std::byte* bytes;
        std::size_t size;
        std::byte mark;
    };
    std::vector<Block> blocks;
    for (int step = 0; step < 20'000; ++step) {
        if (blocks.empty() || random() % 5 < 3) {
            const Block block{nullptr, size(random), static_cast<std::byte>(random())};
            blocks.push_back({pool.take(block.size), block.size, block.mark});
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(blocks.back().bytes) % 64, 0u);
            std::memset(blocks.back().bytes, static_cast<int>(block.mark), block.size);
        } else {
            std::swap(blocks[random() % blocks.size()], blocks.back());
            const Block block = blocks.back();
            blocks.pop_back();
            // A neighbour that overlapped would have left its own mark at one end.
            ASSERT_EQ(block.bytes[0], block.mark);
            ASSERT_EQ(block.bytes[block.size - 1], block.mark);
            pool.give_back(block.bytes, block.size);
        }
    }
    for (const Block& block : blocks)
        pool.give_back(block.bytes, block.size);
}

TEST(BlockPool, ReusesWhatCameBack) {
    BlockPool pool;
    std::byte* block = pool.take(1000);
    const std::size_t held = pool.memory_bytes();
    for (int i = 0; i < 1000; ++i) {
        pool.give_back(block, 1000);
        block = pool.take(1000);
    }
    EXPECT_EQ(pool.memory_bytes(), held);
    pool.give_back(block, 1000);
}

TEST(BlockPool, SmallBlocksShareSlabs) {
    BlockPool pool;
    for (int i = 0; i < 10'000; ++i)
        (void)pool.take(600);  // class of 640
    EXPECT_LT(pool.memory_bytes(), std::size_t{10'000} * 640 * 102 / 100 + BlockPool::k_slab_bytes);
}

TEST(BlockPool, LargeBlocksGoBackToTheSystem) {
    BlockPool pool;
    std::byte* block = pool.take(1 << 20);
    EXPECT_EQ(pool.memory_bytes(), std::size_t{1} << 20u);
    pool.give_back(block, 1 << 20);
    EXPECT_EQ(pool.memory_bytes(), 0u);
}

}  // namespace
}  // namespace rambla::ecs
