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

/// One number per part that tells which entities have which values of it: a sum over them in any order.
class PartSums {
public:
    void plus(std::size_t part, Entity entity, std::uint64_t value) { sums_[part] += mix(entity, value); }
    void minus(std::size_t part, Entity entity, std::uint64_t value) { sums_[part] -= mix(entity, value); }
    [[nodiscard]] std::uint64_t operator[](std::size_t part) const { return sums_[part]; }

private:
    /// Ends as MurmurHash3 does (Appleby 2011), so that sums of different sets are different.
    static std::uint64_t mix(Entity entity, std::uint64_t value) {
        std::uint64_t hash = key_of(entity) * 0x9e3779b97f4a7c15u + value;
        hash = (hash ^ (hash >> 33u)) * 0xff51afd7ed558ccdu;
        hash = (hash ^ (hash >> 33u)) * 0xc4ceb9fe1a85ec53u;
        return hash ^ (hash >> 33u);
    }

    std::array<std::uint64_t, k_part_count> sums_{};
};

/// What an entity should have, and when that was last touched.
struct ModelEntity {
    Entity handle;
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
        state.handle = entity;
        state.place = alive_.size();
        for (std::size_t part = 0; part < k_part_count; ++part) {
            if (state.has(part)) sums_.plus(part, entity, *state.parts[part]);
        }
        expect(entities_.emplace(key_of(entity), state).second, "a handle was given out twice");
        alive_.push_back(entity);
    }
    void died(Entity entity) {
        ModelEntity& state = at(entity);
        for (std::size_t part = 0; part < k_part_count; ++part)
            take(state, part);
        const std::size_t place = state.place;
        entities_.erase(key_of(entity));
        alive_[place] = alive_.back();
        if (alive_[place] != entity) at(alive_[place]).place = place;
        alive_.pop_back();
        dead_.push_back(entity);
    }

    void give(ModelEntity& state, std::size_t part, std::uint64_t value) {
        take(state, part);
        state.parts[part] = value;
        sums_.plus(part, state.handle, value);
    }
    void take(ModelEntity& state, std::size_t part) {
        if (state.has(part)) sums_.minus(part, state.handle, *state.parts[part]);
        state.parts[part].reset();
    }

    /// Null if it is not alive.
    [[nodiscard]] ModelEntity* find(Entity entity) {
        return const_cast<ModelEntity*>(static_cast<const Model&>(*this).find(entity));
    }
    [[nodiscard]] const ModelEntity* find(Entity entity) const {
        const auto found = entities_.find(key_of(entity));
        return found == entities_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] ModelEntity& at(Entity entity) {
        ModelEntity* found = find(entity);
        expect(found != nullptr, "the world has an entity that should not be");
        return *found;
    }

    [[nodiscard]] const PartSums& sums() const { return sums_; }
    [[nodiscard]] const std::vector<Entity>& alive() const { return alive_; }
    [[nodiscard]] const std::vector<Entity>& dead() const { return dead_; }
    [[nodiscard]] const std::unordered_map<std::uint64_t, ModelEntity>& entities() const { return entities_; }
    [[nodiscard]] std::unordered_map<std::uint64_t, ModelEntity>& entities() { return entities_; }

private:
    std::unordered_map<std::uint64_t, ModelEntity> entities_;
    std::vector<Entity> alive_;  ///< in an order that depends on the operations alone
    std::vector<Entity> dead_;
    PartSums sums_;
};

}  // namespace rambla::ecs::property
