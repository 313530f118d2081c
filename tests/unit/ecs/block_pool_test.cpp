#include "ecs/block_pool.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include "ecs/misuse.h"
#include "unit/ecs/lender.h"

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

TEST(BlockPool, CompactingGivesBackSlabsWithoutUsedBlocks) {
    BlockPool pool;
    std::vector<std::byte*> blocks;
    for (int i = 0; i < 2000; ++i) {
        blocks.push_back(pool.take(600));
        std::memset(blocks.back(), i % 251, 600);
    }
    const std::size_t full = pool.memory_bytes();
    for (int i = 0; i < 2000; ++i) {
        if (i != 1000) pool.give_back(blocks[static_cast<std::size_t>(i)], 600);
    }
    pool.compact();
    EXPECT_EQ(pool.memory_bytes(), BlockPool::k_slab_bytes) << "of " << full;
    EXPECT_EQ(blocks[1000][599], static_cast<std::byte>(1000 % 251));
    for (int i = 0; i < 2000; ++i) {  // and goes on
        std::byte* block = pool.take(600);
        ASSERT_NE(block, blocks[1000]);
        std::memset(block, 0, 600);
    }
    EXPECT_EQ(blocks[1000][0], static_cast<std::byte>(1000 % 251));
    pool.compact();
    EXPECT_EQ(pool.memory_bytes(), full);
}

TEST(BlockPool, LivesFromTheMemoryThatItIsGiven) {
    test::Lender lender;
    lender.limit = 200'000;
    {
        BlockPool pool{&lender};
        (void)pool.take(600);
        std::byte* large = pool.take(100'000);
        EXPECT_EQ(lender.lent, pool.memory_bytes());
        EXPECT_EQ(lender.lent, 100'000 + BlockPool::k_slab_bytes);
        EXPECT_THROW((void)pool.take(100'000), CapacityExceeded) << "the lender has no more";
        pool.give_back(large, 100'000);
    }
    EXPECT_EQ(lender.lent, 0u);
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
