#include "ecs/command_arena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace rambla::ecs {
namespace {

TEST(CommandArena, GivesAlignedMemoryThatDoesNotOverlapAndKeepsItsBlocks) {
    CommandArena arena;
    std::size_t held = 0;
    for (int round = 0; round < 3; ++round) {
        std::mt19937 random{1};
        struct Piece {
            std::byte* bytes;
            std::size_t size;
            std::byte mark;
        };
        std::vector<Piece> pieces;
        for (int i = 0; i < 2000; ++i) {
            const std::size_t alignment = std::size_t{1} << (random() % 7u);
            const std::size_t size = i % 500 == 7 ? 3 * CommandArena::k_block_bytes : 1 + random() % 300;
            const Piece piece{static_cast<std::byte*>(arena.take(size, alignment)), size,
                              static_cast<std::byte>(i)};
            ASSERT_EQ(reinterpret_cast<std::uintptr_t>(piece.bytes) % alignment, 0u);
            std::memset(piece.bytes, static_cast<int>(piece.mark), size);
            pieces.push_back(piece);
        }
        for (const Piece& piece : pieces) {
            // A neighbour that overlapped would have left its own mark at one end.
            ASSERT_EQ(piece.bytes[0], piece.mark);
            ASSERT_EQ(piece.bytes[piece.size - 1], piece.mark);
        }
        if (round == 0) held = arena.memory_bytes();
        EXPECT_EQ(arena.memory_bytes(), held);
        arena.clear();
    }
}

}  // namespace
}  // namespace rambla::ecs
