#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecs/command_queue.h"
#include "ecs/commands.h"
#include "ecs/hierarchy.h"
#include "ecs/world.h"
#include "property/ecs/mirror.h"
#include "property/ecs/model.h"
#include "property/ecs/sequence.h"

namespace rambla::ecs::property {

class Queries;
class Replica;

/// A world and its model, changed by the same operations. What an operation does depends on it and on what
/// came before; every operation is possible at any time, so that any part of a sequence is a sequence.
class Twins {
public:
    /// @param observed  what observers keep a mirror of, which must then always be right; nothing: nobody
    ///                  observes
    /// @param follows   whether orphans end by themselves
    Twins(const WorldOptions& options, std::optional<Mirror::Watches> observed, bool follows);
    ~Twins();

    /// Relative frequency of each kind of operation.
    [[nodiscard]] static std::span<const std::uint32_t> weights();
    [[nodiscard]] static std::string_view name_of(const Operation& operation);
    /// Throws Disagreement.
    void play(const Operation& operation);
    /// Compares everything. Throws Disagreement.
    void check_all();

    /// What the operations do, in words, from now on.
    void trace_into(std::string& trace) { trace_ = &trace; }
    /// Entities and their order in memory, and what observers were told: the same for the same operations,
    /// whatever the options.
    [[nodiscard]] std::uint64_t digest() const;
    [[nodiscard]] const Model& model() const { return model_; }

private:
    /// Commands beside what they should do to the model, each of which tells whether it was dropped.
    struct Recording {
        Commands* commands = nullptr;
        std::vector<std::function<bool(const Commands&)>> effects;
        std::vector<Entity> placeholders;
        bool divided = false;  ///< by commands for all entities
    };
    static constexpr std::size_t k_recordings = 3;

    struct Kind;
    /// Above this, waves of creation end waves of entities instead.
    static constexpr std::size_t k_most_entities = 6000;

    // twins.cpp
    [[nodiscard]] static std::span<const Kind> kinds();
    void check_mirror();
    void say(const std::string& text);
    std::optional<Entity> target(const Operation& operation) const;
    ModelEntity newborn() const;
    /// Gives the model's entity a part, or replaces the value it has.
    void set(ModelEntity& entity, std::size_t part, std::uint64_t value);
    /// The same for a value written through a reference, of which observers are not told.
    void overwrite(ModelEntity& entity, std::size_t part, std::uint64_t value);
    void unset(ModelEntity& entity, std::size_t part);
    /// What is written and moved now counts as written in.
    [[nodiscard]] std::uint32_t version_now() const { return stamp_.value_or(world_.version()); }
    [[nodiscard]] std::uint64_t order_of_rows() const;
    /// Notes whether the changes made to it moved it, at the end of an operation.
    void settle(ModelEntity& entity) const;

    // twins_structure.cpp
    void create(const Operation& operation);
    void create_wave(const Operation& operation);
    void destroy(const Operation& operation);
    void destroy_kind(const Operation& operation);
    void add(const Operation& operation);
    void remove(const Operation& operation);
    void write(const Operation& operation);
    void toggle(const Operation& operation);
    void check_one(const Operation& operation);
    void check_dead(const Operation& operation);
    void create_bundle(std::uint32_t bundle, std::uint32_t n);
    template <class... Cs>
    void create_with(std::uint32_t n);

    // twins_bulk.cpp
    void create_many(const Operation& operation);
    void get_many(const Operation& operation);
    void compact(const Operation& operation);
    template <class... Cs>
    void create_copies(std::uint32_t count, std::uint32_t n);
    template <class... Cs>
    void create_filled(std::uint32_t count, const Operation& operation);
    template <class C>
    void get_many_of(const std::vector<Entity>& entities, const Operation& operation);

    // twins_hierarchy.cpp
    void hang(const Operation& operation);
    void hang_chain(const Operation& operation);
    void destroy_tree(const Operation& operation);
    void end_orphans(const Operation& operation);
    void check_children(const Operation& operation);
    void check_hierarchy();
    [[nodiscard]] std::vector<Entity> children_of(Entity parent) const;
    /// What ends and is freed with the given entities, as Parent says. Returns how many end.
    std::size_t end_below(std::vector<Entity> ending);
    std::size_t end_model_orphans();
    void set_free(Entity entity);
    /// After each call or playback that may have ended entities.
    void follow_ends();

    // twins_commands.cpp
    Recording& recording(const Operation& operation);
    void record(const Operation& operation);
    void apply(const Operation& operation);
    void apply_all();
    void apply_alike(const Operation& operation);
    /// @param version  the world's, of the playback: observers may have ended it since
    void play_effects(std::span<const Recording> recordings, const Playback& playback, std::uint32_t version);
    void observe_more(const Operation& operation);
    void record_create(Recording& recording, const Operation& operation);
    template <class... Cs>
    void record_create_with(Recording& recording, std::uint32_t n);
    void record_add(Recording& recording, Entity entity, const Operation& operation);
    void record_remove(Recording& recording, Entity entity, const Operation& operation);
    void record_destroy(Recording& recording, Entity entity);

    // twins_whole.cpp
    void record_whole(const Operation& operation);
    template <class C, class... Terms>
    void record_add_to_all(Recording& recording, std::uint32_t n);
    template <class... Terms>
    void record_parent_for_all(Recording& recording, std::uint32_t n);
    template <class C, class... Terms>
    void record_remove_from_all(Recording& recording);
    template <class... Terms>
    void record_destroy_all(Recording& recording);

    // twins_queries.cpp
    void check_query(const Operation& operation);
    void write_through_query(const Operation& operation);
    void check_versions(const Operation& operation);
    void check_replica(const Operation& operation);
    void check_changed(const Operation& operation);
    void check_versions_of_rows(const Operation& operation);
    void change_while_iterating(const Operation& operation);
    template <class C>
    void check_single_write(Entity writing, std::uint32_t n);

    World world_;
    Model model_;
    std::unique_ptr<Mirror> mirror_;  ///< null: nobody observes
    Hierarchy hierarchy_{world_};
    bool follows_;
    std::uint32_t begun_ = 0;             ///< version in which the operation began: hierarchies end versions
    std::optional<std::uint32_t> stamp_;  ///< see version_now()
    std::size_t dead_before_ = 0;         ///< when orphans were last looked for
    CommandQueue queue_;
    std::vector<Recording> recordings_;
    std::unique_ptr<Queries> queries_;
    std::unique_ptr<Replica> replica_;
    std::string* trace_ = nullptr;
};

}  // namespace rambla::ecs::property
