#include "ecs/hierarchy.h"

#include <algorithm>
#include <string>

#include "ecs/access_scope.h"
#include "ecs/iteration.h"
#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

/// Names in a message about a ring; more would not tell more.
constexpr std::size_t k_names = 8;

/// Steps up from a new parent before it is worth asking whether the child has children at all.
constexpr std::size_t k_short_walk = 64;

Entity living_parent(const World& world, Entity entity) {
    const Parent* parent = world.try_get<Parent>(entity);
    return parent != nullptr && world.alive(parent->entity) ? parent->entity : Entity{};
}

void make_unique(std::vector<Entity>& entities) {
    std::ranges::sort(entities, {}, &Entity::index);
    entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
}

/// @param first, last  a ring is closed by making `last`, an ancestor of itself or to become one, hang from
///                     where the walk up from `first` began
[[noreturn]] void throw_ring(const World& world, std::string_view operation, Entity first, Entity last) {
    std::string text{"ecs: "};
    text.append(operation).append(": a ring of parents: ").append(to_string(last)).append(" hangs from ");
    std::size_t names = 0;
    Entity entity = first;
    for (; entity != last && names < k_names; ++names) {
        text.append(to_string(entity)).append(", that from ");
        entity = living_parent(world, entity);
    }
    if (entity != last) text.append("others, one of them from ");
    throw Misuse{text + to_string(last)};
}

}  // namespace

/// Brent 1980, "An improved Monte Carlo factorization algorithm": marks 1, 2, 4, 8 … steps apart meet any
/// ring after at most three times its length and what leads to it.
Ancestors::Iterator& Ancestors::Iterator::operator++() {
    now_ = living_parent(*world_, now_);
    if (now_ == Entity{}) return *this;
    if (now_ == mark_) throw_ring(*world_, "Ancestors", living_parent(*world_, now_), now_);
    if (++steps_ == next_mark_) {
        mark_ = now_;
        next_mark_ *= 2;
    }
    return *this;
}

void Hierarchy::update() {
    if (nodes_.update(world_, since_)) note_lost();
    if (!detail::AccessScope::shares(world_)) world_.advance_version();
    since_ = world_.version();
}

void Hierarchy::note_lost() {
    try {
        for (const std::uint32_t node : nodes_.changes().relinked) {
            if (nodes_[node].kind == HierarchyNodes::Kind::lost) orphans_.push_back(nodes_[node].entity);
        }
    } catch (...) {  // those left out have to be found again
        nodes_.forget();
        throw;
    }
}

Hierarchy::Children Hierarchy::children(Entity entity) const {
    const std::uint32_t node = nodes_.find(entity);
    return {nodes_, node == HierarchyNodes::k_none ? node : nodes_[node].first};
}

std::size_t Hierarchy::depth(Entity entity) const {
    std::size_t depth = 0;
    for ([[maybe_unused]] const Entity ancestor : ancestors(entity))
        ++depth;
    return depth;
}

void Hierarchy::set_parent(Entity child, Entity parent, OnParentEnd on_end) {
    constexpr std::string_view k_operation = "Hierarchy::set_parent";
    if (!world_.alive(child)) detail::throw_not_alive(k_operation, {}, child);
    if (parent == Entity{}) {
        if (world_.has<Parent>(child)) world_.remove<Parent>(child);
        return;
    }
    if (!world_.alive(parent)) detail::throw_not_alive(k_operation, {}, parent);
    if (parent == child) throw_ring(world_, k_operation, parent, child);
    std::size_t steps = 0;
    for (const Entity ancestor : ancestors(parent)) {
        if (ancestor == child) throw_ring(world_, k_operation, parent, child);
        if (++steps != k_short_walk) continue;
        update();
        if (children(child).empty()) break;
    }
    world_.add(child, Parent{parent, on_end});
}

std::size_t Hierarchy::destroy(Entity entity) {
    constexpr std::string_view k_operation = "Hierarchy::destroy";
    detail::IterationMark::forbid(world_, k_operation);  // before the recording that is played is touched
    if (!world_.alive(entity)) detail::throw_not_alive(k_operation, {}, entity);
    begin_collecting();
    ending_.push_back(entity);
    if (const std::uint32_t node = nodes_.find(entity); node != HierarchyNodes::k_none) {
        stack_.push_back(node);
        collect_below(node);
    }
    return carry_out();
}

std::size_t Hierarchy::end_orphans() {
    detail::IterationMark::forbid(world_, "Hierarchy::end_orphans");
    collect_orphans();
    return carry_out();
}

Playback Hierarchy::apply(Commands& commands) {
    const Playback playback = commands.apply(world_);
    end_orphans();
    return playback;
}

void Hierarchy::follow_ends() {
    if (followed_ != nullptr) throw Misuse{"ecs: Hierarchy::follow_ends: it does already"};
    Observers& observers = world_.observers();
    observers.add_follower(*this);
    followed_ = &observers;
}

Hierarchy::~Hierarchy() {
    if (followed_ != nullptr) followed_->remove_follower(*this);
}

void Hierarchy::record_orphans(Commands& commands) {
    collect_orphans();
    record(commands);
}

std::size_t Hierarchy::memory_bytes() const {
    return nodes_.memory_bytes() + commands_.memory_bytes() +
           (orphans_.capacity() + ending_.capacity() + freed_.capacity()) * sizeof(Entity) +
           stack_.capacity() * sizeof(std::uint32_t);
}

void Hierarchy::begin_collecting() {
    update();
    stack_.clear();
    ending_.clear();
    freed_.clear();
}

/// Finds what ends with the nodes on the stack. In a ring only the first can be met again: each node has one
/// parent.
void Hierarchy::collect_below(std::uint32_t first) {
    while (!stack_.empty()) {
        const std::uint32_t node = stack_.back();
        stack_.pop_back();
        for (std::uint32_t child = nodes_[node].first; child != HierarchyNodes::k_none;
             child = nodes_[child].next) {
            if (child != first) collect(child);
        }
    }
}

void Hierarchy::collect(std::uint32_t node) {
    if (world_.get<Parent>(nodes_[node].entity).on_end == OnParentEnd::freed) {
        freed_.push_back(nodes_[node].entity);
    } else {
        ending_.push_back(nodes_[node].entity);
        stack_.push_back(node);
    }
}

/// They stay in the list until an update finds that they are none: what is recorded may not be played.
void Hierarchy::collect_orphans() {
    begin_collecting();
    std::erase_if(orphans_, [&](Entity entity) { return !is_orphan(entity); });
    make_unique(orphans_);
    for (const Entity orphan : orphans_)
        collect(nodes_.find(orphan));
    collect_below(HierarchyNodes::k_none);
}

/// Of an entity that hung from itself, or from what was never alive, no parent has ended.
bool Hierarchy::is_orphan(Entity entity) const {
    const std::uint32_t node = nodes_.find(entity);
    if (node == HierarchyNodes::k_none || nodes_[node].kind != HierarchyNodes::Kind::lost) return false;
    const Entity parent = nodes_[node].parent;
    return parent.generation != 0 && !world_.alive(parent);
}

/// In the order of indices, which does not depend on when updates met whom.
void Hierarchy::record(Commands& commands) {
    make_unique(freed_);
    make_unique(ending_);
    for (const Entity entity : freed_)
        commands.remove<Parent>(entity);
    commands.destroy_many(ending_);
}

std::size_t Hierarchy::carry_out() {
    commands_.clear();
    record(commands_);
    const std::size_t ended = ending_.size();
    commands_.apply(world_);  // whoever follows ends collects anew
    return ended;
}

}  // namespace rambla::ecs
