#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "ecs/entity.h"
#include "ecs/misuse.h"
#include "property/ecs/parts.h"

namespace rambla::ecs::property {

/// A world that is not what its model says.
class Disagreement : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

inline void expect(bool agreed, const char* what) {
    if (!agreed) throw Disagreement{what};
}

template <class F>
void expect_misuse(F&& call, const char* what) {
    try {
        call();
    } catch (const Misuse&) {
        return;
    }
    throw Disagreement{what};
}

/// What an entity should have, and when that was last touched.
struct ModelEntity {
    std::array<std::optional<std::uint64_t>, k_part_count> parts{};
    std::array<std::uint32_t, k_part_count> written{};  ///< world versions
    std::array<bool, k_part_count> disabled{};
    std::uint64_t home = 0;     ///< tells its archetype from others
    std::uint32_t moved = 0;    ///< version of the last structural change
    std::uint32_t visited = 0;  ///< mark of the walk that saw it last
    std::size_t place = 0;      ///< in Model::alive()

    [[nodiscard]] bool has(std::size_t part) const { return parts[part].has_value(); }
};

/// All entities of a world, kept the naive way.
class Model {
public:
    void born(Entity entity, ModelEntity state) {
        state.place = alive_.size();
        expect(entities_.emplace(key_of(entity), state).second, "a handle was given out twice");
        alive_.push_back(entity);
    }
    void died(Entity entity) {
        const std::size_t place = at(entity).place;
        entities_.erase(key_of(entity));
        alive_[place] = alive_.back();
        if (alive_[place] != entity) at(alive_[place]).place = place;
        alive_.pop_back();
        dead_.push_back(entity);
    }

    /// Null if it is not alive.
    [[nodiscard]] ModelEntity* find(Entity entity) {
        const auto found = entities_.find(key_of(entity));
        return found == entities_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] ModelEntity& at(Entity entity) {
        ModelEntity* found = find(entity);
        expect(found != nullptr, "the world has an entity that should not be");
        return *found;
    }

    [[nodiscard]] const std::vector<Entity>& alive() const { return alive_; }
    [[nodiscard]] const std::vector<Entity>& dead() const { return dead_; }
    [[nodiscard]] const std::unordered_map<std::uint64_t, ModelEntity>& entities() const { return entities_; }
    [[nodiscard]] std::unordered_map<std::uint64_t, ModelEntity>& entities() { return entities_; }

private:
    std::unordered_map<std::uint64_t, ModelEntity> entities_;
    std::vector<Entity> alive_;  ///< in an order that depends on the operations alone
    std::vector<Entity> dead_;
};

}  // namespace rambla::ecs::property
