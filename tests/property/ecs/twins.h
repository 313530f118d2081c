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
#include "ecs/world.h"
#include "property/ecs/model.h"
#include "property/ecs/sequence.h"

namespace rambla::ecs::property {

class Queries;
class Replica;

/// A world and its model, changed by the same operations. What an operation does depends on it and on what
/// came before; every operation is possible at any time, so that any part of a sequence is a sequence.
class Twins {
public:
    /// @param shares  whether parts that entities share are among those that come and go; snapshots cannot
    /// hold
    ///                them and are left out then
    Twins(const WorldOptions& options, bool shares);
    ~Twins();

    /// Relative frequency of each kind of operation.
    [[nodiscard]] static std::span<const std::uint32_t> weights();
    /// Throws Disagreement.
    void play(const Operation& operation);
    /// Compares everything. Throws Disagreement.
    void check_all();

    /// What the operations do, in words, from now on.
    void trace_into(std::string& trace) { trace_ = &trace; }
    /// Entities and their order in memory: the same for the same operations, whatever the options.
    [[nodiscard]] std::uint64_t digest();
    [[nodiscard]] const Model& model() const { return model_; }

private:
    /// Commands beside what they should do to the model, each of which tells whether it was dropped.
    struct Recording {
        Commands* commands = nullptr;
        std::vector<std::function<bool(const Commands&)>> effects;
        std::vector<Entity> placeholders;
    };
    static constexpr std::size_t k_recordings = 3;

    // twins.cpp
    template <class C>
    [[nodiscard]] bool uses() const {
        return shares_ || storage_of<C> != Storage::shared;
    }
    void say(const std::string& text);
    std::optional<Entity> target(const Operation& operation) const;
    ModelEntity newborn() const;
    /// Gives the model's entity a part, or replaces the value it has.
    void set(ModelEntity& entity, std::size_t part, std::uint64_t value) const;
    void unset(ModelEntity& entity, std::size_t part) const;
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

    // twins_commands.cpp
    void record(const Operation& operation);
    void apply(const Operation& operation);
    void apply_all();
    void record_create(Recording& recording, const Operation& operation);
    template <class... Cs>
    void record_create_with(Recording& recording, std::uint32_t n);
    void record_add(Recording& recording, Entity entity, const Operation& operation);
    void record_remove(Recording& recording, Entity entity, const Operation& operation);
    void record_destroy(Recording& recording, Entity entity);

    // twins_queries.cpp
    void check_query(const Operation& operation);
    void write_through_query(const Operation& operation);
    void check_versions(const Operation& operation);
    void check_replica(const Operation& operation);
    void check_changed(const Operation& operation);
    void check_versions_of_rows(const Operation& operation);
    void change_while_iterating(const Operation& operation);

    bool shares_;
    World world_;
    Model model_;
    CommandQueue queue_;
    std::vector<Recording> recordings_;
    std::unique_ptr<Queries> queries_;
    std::unique_ptr<Replica> replica_;
    std::string* trace_ = nullptr;
};

}  // namespace rambla::ecs::property
