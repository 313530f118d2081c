#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ecs/alike_moves.h"
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

    /// The same without what observers have recorded meanwhile.
    Playback play_once(std::span<Commands* const> recordings);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Lists all that was recorded in runs_ if AlikeMoves may take it, and returns its type; else null.
    const CommandType* list_alike(std::span<Commands* const> recordings);
    /// The same with a part of commands_. Returns whether it did.
    bool list_alike(std::span<const Command> commands);
    /// Makes commands_ of all recordings.
    void merge(std::span<Commands* const> recordings);
    void number_placeholders(std::span<Commands* const> recordings);
    /// Plays commands about single entities. Says how many were dropped.
    std::size_t play_single(std::span<Commands* const> recordings, std::size_t first, std::size_t end);
    /// Where the commands about single entities end that begin at `first`.
    [[nodiscard]] std::size_t end_of_singles(std::size_t first) const;
    /// Whether nobody wants to know which commands change what.
    [[nodiscard]] bool unobserved() const;
    void play_whole(const Command& command, std::size_t recording);
    void add_to_whole(const Command& command, const CommandPart& part);
    void replace_whole(const Command& command, const ComponentInfo& info, Archetype& archetype,
                       ColumnIndex column, std::uint32_t first_row, bool ends_old) noexcept;
    void remove_from_whole(const CommandPart& part);
    [[nodiscard]] BulkRows bulk() { return {world_.entities_, world_.graph_.sparse(), world_.version_}; }
    /// What may fail.
    void prepare();
    void reserve_handles();
    /// What cannot.
    void commit(std::span<Commands* const> recordings, std::size_t first) noexcept;
    void create_handles() noexcept;
    void resolve_placeholders(std::span<Commands* const> recordings, std::size_t first) noexcept;
    static void resolve_parts(const Command& command, CreatedEntities created) noexcept;
    [[nodiscard]] std::size_t recording_of(std::size_t command) const;
    [[nodiscard]] CreatedEntities created_of(std::size_t recording) const;
    void append_created(const PlannedGroup& group, const BulkRows& bulk) noexcept;
    void write(const PlannedGroup& group, std::uint32_t first_row) noexcept;
    void write_alike(const PlannedGroup& group, std::uint32_t first_row) noexcept;
    void replace(const PlannedGroup& group) noexcept;
    void replace_row(const PlannedGroup& group, std::uint32_t row, ComponentId component,
                     const ComponentInfo& info, std::byte* value) noexcept;
    void write_sparse();
    /// What the placeholders of the plan stand for.
    [[nodiscard]] CreatedEntities created_by_plan() const {
        return CreatedEntities{created_}.last(plan_.creations());
    }
    void give_created_to(std::span<Commands* const> recordings);

    World& world_;
    AlikeMoves alike_;
    std::vector<CommandRun> runs_;  ///< for it
    CommandPlan plan_;
    std::span<const Command> commands_;         ///< of all recordings
    std::vector<Command> merged_;               ///< where commands_ are if there are several recordings
    std::vector<std::uint32_t> placeholders_;   ///< before each recording, and after the last
    std::vector<std::size_t> commands_before_;  ///< each recording, and all
    std::vector<Archetype*> whole_;             ///< that a command is about
    std::vector<Entity> created_;               ///< by placeholder, of all recordings
    std::vector<std::uint64_t> incoming_;       ///< rows, by archetype
    std::vector<std::uint32_t> fillers_;
    std::vector<Entity> fresh_;
};

}  // namespace rambla::ecs::detail
