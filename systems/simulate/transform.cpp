#include "systems/simulate/transform.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "systems/position.h"

namespace rambla::systems {
namespace {

/// Rows per job: about 20 µs, well above the cost of handing work to another thread.
constexpr std::size_t k_rows_per_job = 1024;

template <class Job>
void for_rows(std::size_t begin, std::size_t end, const Job& job) {
    if (end - begin < 2 * k_rows_per_job) {
        for (std::size_t i = begin; i < end; ++i)
            job(i);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>{begin, end, k_rows_per_job}, [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            job(i);
    });
}

glm::mat3 linear_of(const LocalTransform& local) {
    const glm::mat3 rotation = glm::mat3_cast(local.rotation);
    return {rotation[0] * local.scale.x, rotation[1] * local.scale.y, rotation[2] * local.scale.z};
}

}  // namespace

glm::quat renormalised(const glm::quat& rotation) {
    const float norm = glm::dot(rotation, rotation);
    // Within 1/16 of unit, the step leaves at most 3/8 · (1/16)² of the error, and far less from one step to
    // the next.
    if (std::fabs(norm - 1.0f) < 0.0625f) return rotation * (1.5f - 0.5f * norm);
    const float largest = std::max(std::max(std::fabs(rotation.x), std::fabs(rotation.y)),
                                   std::max(std::fabs(rotation.z), std::fabs(rotation.w)));
    if (!(largest > 0.0f) || !std::isfinite(largest)) return {1.0f, 0.0f, 0.0f, 0.0f};
    const glm::quat scaled{rotation.w / largest, rotation.x / largest, rotation.y / largest,
                           rotation.z / largest};
    return scaled * (1.0f / std::sqrt(glm::dot(scaled, scaled)));
}

WorldTransform root_transform(const Cell& cell, const LocalTransform& local) {
    return {cell.value, linear_of(local), local.translation_m};
}

WorldTransform child_transform(const WorldTransform& parent, const LocalTransform& local) {
    return {parent.cell, parent.linear * linear_of(local),
            parent.linear * local.translation_m + parent.translation_m};
}

void TransformPropagation::operator()(ecs::World& world) {
    gather(world);
    if (!order_is_current()) rebuild_order(world);
    for_rows(0, roots_.size(), [&](std::size_t i) { move_root(roots_[i]); });
    std::size_t begin = 0;
    for (const std::size_t end : level_ends_) {
        for_rows(begin, end, [&](std::size_t i) { move_child(world, children_[i]); });
        begin = end;
    }
}

void TransformPropagation::gather(ecs::World& world) {
    chunks_.clear();
    for (auto [entities, local, now, previous, parents, cells] : moving_.chunks(world)) {
        chunks_.push_back({entities, local, now, previous, parents, cells});
    }
}

/// One look at every member costs far less than moving it, and sees every structural change there can be.
bool TransformPropagation::order_is_current() const {
    std::size_t known = 0;
    for (const Chunk& chunk : chunks_) {
        if (members_.size() - known < chunk.entities.size()) return false;
        for (std::size_t i = 0; i < chunk.entities.size(); ++i) {
            const ecs::Entity parent = chunk.parents.empty() ? ecs::Entity{} : chunk.parents[i].entity;
            if (members_[known++] != Member{chunk.entities[i], parent}) return false;
        }
    }
    return known == members_.size();
}

void TransformPropagation::rebuild_order(const ecs::World& world) {
    members_.clear();
    roots_.clear();
    children_.clear();
    level_ends_.clear();

    std::vector<Row> rows;
    std::unordered_map<ecs::Entity, std::size_t> member_of;
    for (std::uint32_t c = 0; c < chunks_.size(); ++c) {
        const Chunk& chunk = chunks_[c];
        for (std::uint32_t i = 0; i < chunk.entities.size(); ++i) {
            member_of.emplace(chunk.entities[i], members_.size());
            members_.push_back(
                {chunk.entities[i], chunk.parents.empty() ? ecs::Entity{} : chunk.parents[i].entity});
            rows.push_back({c, i});
        }
    }

    // Breadth first from the roots and from children of fixed parents, stable within a level. What a dead
    // parent or a ring of parents holds is never reached: it rests where it is from now on.
    for (const Chunk& chunk : chunks_) {
        for (std::size_t i = 0; i < chunk.entities.size(); ++i)
            chunk.previous[i].value = chunk.world[i];
    }
    std::vector<std::vector<std::size_t>> children_of(members_.size());
    std::vector<std::size_t> level;
    std::vector<std::size_t> below_roots;
    for (std::size_t m = 0; m < members_.size(); ++m) {
        const ecs::Entity parent = members_[m].parent;
        if (parent == ecs::Entity{}) {
            roots_.push_back(rows[m]);
            level.push_back(m);
        } else if (const auto found = member_of.find(parent); found != member_of.end()) {
            children_of[found->second].push_back(m);
        } else if (world.alive(parent) && world.has<WorldTransform>(parent)) {
            children_.push_back({rows[m], {}, parent});
            below_roots.push_back(m);
        }
    }
    while (!level.empty() || !below_roots.empty()) {
        std::vector<std::size_t> next = std::move(below_roots);
        below_roots.clear();
        for (const std::size_t m : level) {
            for (const std::size_t child : children_of[m]) {
                children_.push_back({rows[child], rows[m], {}});
                next.push_back(child);
            }
        }
        level = std::move(next);
        if (!level.empty()) level_ends_.push_back(children_.size());
    }
}

void TransformPropagation::move_root(Row row) const {
    const Chunk& chunk = chunks_[row.chunk];
    LocalTransform& local = chunk.local[row.place];
    local.rotation = renormalised(local.rotation);
    Cell cell;
    if (!chunk.cells.empty()) {
        const WorldPosition place = normalised({chunk.cells[row.place].value, local.translation_m});
        chunk.cells[row.place].value = place.cell;
        local.translation_m = place.local_m;
        cell.value = place.cell;
    }
    chunk.previous[row.place].value = chunk.world[row.place];
    chunk.world[row.place] = root_transform(cell, local);
}

void TransformPropagation::move_child(const ecs::World& world, const Link& link) const {
    const WorldTransform* parent = nullptr;
    if (link.fixed_parent == ecs::Entity{}) {
        parent = &chunks_[link.parent.chunk].world[link.parent.place];
    } else if (world.alive(link.fixed_parent)) {
        parent = world.try_get<WorldTransform>(link.fixed_parent);
    }
    const Chunk& chunk = chunks_[link.row.chunk];
    LocalTransform& local = chunk.local[link.row.place];
    local.rotation = renormalised(local.rotation);
    chunk.previous[link.row.place].value = chunk.world[link.row.place];
    if (parent != nullptr) chunk.world[link.row.place] = child_transform(*parent, local);
}

void settle(ecs::World& world) {
    TransformPropagation propagate;
    propagate(world);
    propagate(world);
}

}  // namespace rambla::systems
