#include <bit>
#include <cstdint>
#include <type_traits>

#include "ecs/query.h"
#include "systems/pipeline.h"
#include "systems/simulate/paths.h"
#include "systems/simulate/random.h"

namespace rambla::systems {
namespace {

/// Field by field, because the bytes between fields are anybody's.
class Hash {
public:
    void add(std::uint64_t bits) { value_ = mixed(value_ + 0x9e3779b97f4a7c15ull) ^ bits; }
    void add(float value) { add(std::uint64_t{std::bit_cast<std::uint32_t>(value)}); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(const glm::vec2& v) { add(v.x), add(v.y); }
    void add(const glm::vec3& v) { add(v.x), add(v.y), add(v.z); }
    void add(const glm::quat& q) { add(q.w), add(q.x), add(q.y), add(q.z); }
    void add(const glm::mat3& m) { add(m[0]), add(m[1]), add(m[2]); }
    void add(const glm::ivec3& v) {
        for (int axis = 0; axis < 3; ++axis)
            add(std::uint64_t{static_cast<std::uint32_t>(v[axis])});
    }
    void add(ecs::Entity e) { add((std::uint64_t{e.generation} << 32u) | e.index); }
    void add(const WorldTransform& t) { add(t.cell), add(t.linear), add(t.translation_m); }
    void add(const PathLeg& leg) {
        add((std::uint64_t{leg.link} << 1u) | (leg.backwards ? 1u : 0u));
        add(leg.aside_m);
    }

    void add(const LocalTransform& t) { add(t.translation_m), add(t.rotation), add(t.scale); }
    void add(const Cell& cell) { add(cell.value); }
    void add(const Parent& parent) { add(parent.entity); }
    void add(const PreviousWorldTransform& t) { add(t.value); }
    void add(const PathFollower& f) {
        add((std::uint64_t{f.turns} << 2u) | (f.turning ? 2u : 0u) | static_cast<std::uint64_t>(f.kind));
        add(f.leg), add(f.next), add(f.progress), add(f.speed_m_s), add(f.heading), add(f.travelled_m);
    }
    void add(const ClipCursor& c) {
        add((std::uint64_t{c.clip} << 1u) | (c.looping ? 1u : 0u));
        add(c.time_s), add(c.speed);
    }
    void add(const AnimationPlayer& p) { add(p.playing), add(p.fading), add(p.fade_s), add(p.fade_left_s); }
    void add(const MorphWeight& w) { add(w.value), add(w.previous); }
    void add(const Mover& m) { add(m.heading_rad), add(m.speed_m_s), add(m.reach_m); }
    void add(const Gait& g) { add(g.leg_length_m), add(g.phase), add(g.reach); }

    [[nodiscard]] std::uint64_t value() const { return mixed(value_); }

private:
    std::uint64_t value_ = 0;
};

template <class C>
void add_column(const ecs::World& world, Hash& hash) {
    ecs::Query<ecs::Entity, const C> query;
    std::uint64_t rows = 0;
    for (auto [entities, column] : query.chunks(world)) {
        for (std::size_t i = 0; i < column.size(); ++i) {
            hash.add(entities[i]);
            hash.add(column[i]);
        }
        rows += column.size();
    }
    hash.add(rows);
}

}  // namespace

std::uint64_t state_hash(const ecs::World& world) {
    Hash hash;
    hash.add(world.has_resource<Clock>() ? world.resource<Clock>().steps : std::uint64_t{0});
    hash.add(world.has_resource<Paths>() ? world.resource<Paths>().seed : std::uint64_t{0});
    add_column<LocalTransform>(world, hash);
    add_column<Cell>(world, hash);
    add_column<Parent>(world, hash);
    add_column<WorldTransform>(world, hash);
    add_column<PreviousWorldTransform>(world, hash);
    add_column<PathFollower>(world, hash);
    add_column<Mover>(world, hash);
    add_column<Gait>(world, hash);
    add_column<AnimationPlayer>(world, hash);
    add_column<MorphWeight>(world, hash);
    return hash.value();
}

}  // namespace rambla::systems
