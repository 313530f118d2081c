#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ecs/bulk_rows.h"
#include "ecs/command_plan.h"
#include "ecs/commands.h"
#include "ecs/world.h"

namespace rambla::ecs::detail {

/// Plays recordings into a world. Belongs to the world and keeps its memory for the next time.
class CommandPlayer {
public:
    explicit CommandPlayer(World& world) : world_{world} {}

    /// The world's own; made by its first playback.
    static CommandPlayer& of(World& world);

    /// Plays recordings one behind the other, as Commands::apply does with one, and empties them.
    Playback play(std::span<Commands* const> recordings, std::string_view operation);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void merge(std::span<Commands* const> recordings);
    /// What may fail.
    void prepare();
    void reserve_handles();
    /// What cannot.
    void commit(std::span<Commands* const> recordings) noexcept;
    void create_handles() noexcept;
    void resolve_placeholders(std::span<Commands* const> recordings) noexcept;
    [[nodiscard]] CreatedEntities created_of(std::size_t recording) const;
    void append_created(const PlannedGroup& group, const BulkRows& bulk) noexcept;
    void write(const PlannedGroup& group, std::uint32_t first_row) noexcept;
    void replace(const PlannedGroup& group) noexcept;
    void write_sparse();
    void give_created_to(std::span<Commands* const> recordings);

    World& world_;
    CommandPlan plan_;
    std::span<const Command> commands_;        ///< of all recordings
    std::vector<Command> merged_;              ///< where commands_ are if there are several recordings
    std::vector<std::uint32_t> placeholders_;  ///< before each recording, and after the last
    std::vector<Entity> created_;              ///< by placeholder, of all recordings
    std::vector<std::uint64_t> incoming_;      ///< rows, by archetype
    std::vector<std::uint32_t> fillers_;
    std::vector<Entity> fresh_;
};

}  // namespace rambla::ecs::detail
