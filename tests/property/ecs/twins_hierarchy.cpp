#include <algorithm>
#include <string>

#include "property/ecs/twins.h"

namespace rambla::ecs::property {
namespace {

std::optional<Parent> parent_in(const Model& model, Entity entity) {
    const ModelEntity* state = model.find(entity);
    if (state == nullptr || !state->has(part_number<Parent>())) return {};
    return parent_of(*state->parts[part_number<Parent>()]);
}

/// Parents of an entity, as far as they live; none comes twice, so that a ring ends too.
struct WayUp {
    std::vector<Entity> met;
    bool ring = false;
};

WayUp way_up(const Model& model, Entity from) {
    WayUp way;
    for (std::optional<Parent> parent = parent_in(model, from);
         parent && model.find(parent->entity) != nullptr; parent = parent_in(model, parent->entity)) {
        way.ring = parent->entity == from || std::ranges::find(way.met, parent->entity) != way.met.end();
        if (way.ring) break;
        way.met.push_back(parent->entity);
    }
    return way;
}

/// Rings that are found after few steps are refused by set_parent() before it asks for children.
constexpr std::size_t k_short_way = 16;

bool by_handle(Entity a, Entity b) {
    return key_of(a) < key_of(b);
}

}  // namespace

void Twins::hang(const Operation& operation) {
    const std::optional<Entity> child = target(operation);
    if (!child) return;
    const OnParentEnd policy = policy_of(operation.b >> 8u);
    const std::vector<Entity>& from = operation.c % 32 == 1 ? model_.dead() : model_.alive();
    if (from.empty()) return;
    const Entity parent = from[operation.c / 32 % std::min<std::size_t>(from.size(), 300)];
    if (operation.c % 32 < 4) {  // as it comes, dead parents and rings included
        say("add Parent " + to_string(parent) + " to " + to_string(*child));
        world_.add(*child, Parent{parent, policy});
    } else if (operation.c % 32 == 4) {
        say("make a root of " + to_string(*child));
        hierarchy_.set_parent(*child, {});
        unset(model_.at(*child), part_number<Parent>());
        return settle(model_.at(*child));
    } else {
        const WayUp way = way_up(model_, parent);
        if (way.ring && way.met.size() > k_short_way) return;
        say("set parent of " + to_string(*child) + " to " + to_string(parent));
        if (parent == *child || way.ring || std::ranges::find(way.met, *child) != way.met.end()) {
            return expect_misuse([&] { hierarchy_.set_parent(*child, parent, policy); },
                                 "a ring of parents was made");
        }
        hierarchy_.set_parent(*child, parent, policy);
    }
    set(model_.at(*child), part_number<Parent>(), parent_key({parent, policy}));
    settle(model_.at(*child));
}

void Twins::hang_chain(const Operation& operation) {
    const std::vector<Entity>& alive = model_.alive();
    const std::size_t links = std::min<std::size_t>(alive.size(), 20 + operation.b % 120);
    say("hang " + std::to_string(links) + " below each other");
    for (std::size_t i = 1; i < links; ++i) {
        const Parent parent{alive[i - 1], policy_of(operation.c + (i % 8 == 0 ? 1u : 0u))};
        world_.add(alive[i], parent);
        set(model_.at(alive[i]), part_number<Parent>(), parent_key(parent));
        settle(model_.at(alive[i]));
    }
}

std::vector<Entity> Twins::children_of(Entity parent) const {
    std::vector<Entity> children;
    for (const Entity entity : model_.alive()) {
        if (entity == parent) continue;
        const std::optional<Parent> of = parent_in(model_, entity);
        if (of && of->entity == parent) children.push_back(entity);
    }
    return children;
}

void Twins::set_free(Entity entity) {
    stamp_ = begun_;
    unset(model_.at(entity), part_number<Parent>());
    settle(model_.at(entity));
    stamp_.reset();
}

std::size_t Twins::end_below(std::vector<Entity> ending) {
    std::vector<Entity> freed;
    for (std::size_t i = 0; i < ending.size(); ++i) {
        for (const Entity child : children_of(ending[i])) {
            if (std::ranges::find(ending, child) != ending.end()) continue;
            const bool survives = parent_in(model_, child)->on_end == OnParentEnd::freed;
            (survives ? freed : ending).push_back(child);
        }
    }
    std::ranges::for_each(freed, [&](Entity entity) { set_free(entity); });
    for (const Entity entity : ending)
        model_.died(entity);
    return ending.size();
}

void Twins::destroy_tree(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    say("destroy the tree of " + to_string(*entity));
    const std::size_t ended = hierarchy_.destroy(*entity);
    expect(end_below({*entity}) == ended, "the number of those that end with a parent");
    follow_ends();
}

std::size_t Twins::end_model_orphans() {
    std::vector<Entity> orphans;
    for (const Entity entity : model_.alive()) {
        const std::optional<Parent> of = parent_in(model_, entity);
        if (!of || of->entity.generation == 0 || model_.find(of->entity) != nullptr) continue;
        if (of->on_end == OnParentEnd::destroyed) {
            orphans.push_back(entity);
        } else {
            set_free(entity);
        }
    }
    return end_below(std::move(orphans));
}

void Twins::follow_ends() {
    if (follows_ && model_.dead().size() != dead_before_) {
        end_model_orphans();
        if (mirror_ != nullptr) mirror_->watch_order(world_, false);  // a second playback begins anew
    }
    dead_before_ = model_.dead().size();
}

void Twins::end_orphans(const Operation& operation) {
    if (operation.c % 2 == 0) {
        say("end orphans");
        const std::size_t ended = hierarchy_.end_orphans();
        expect(end_model_orphans() == ended, "the number of orphans that end");
        return;
    }
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    say("destroy " + to_string(*entity) + " by a command of the hierarchy");
    Commands commands;
    commands.destroy(*entity);
    hierarchy_.apply(commands);
    model_.died(*entity);
    end_model_orphans();
}

void Twins::check_children(const Operation& operation) {
    const std::optional<Entity> entity = target(operation);
    if (!entity) return;
    hierarchy_.update();
    std::vector<Entity> found;
    for (const Entity child : hierarchy_.children(*entity))
        found.push_back(child);
    std::vector<Entity> expected = children_of(*entity);
    std::ranges::sort(found, by_handle);
    std::ranges::sort(expected, by_handle);
    expect(found == expected, "the children of an entity");
    const WayUp way = way_up(model_, *entity);
    if (!way.ring) expect(hierarchy_.depth(*entity) == way.met.size(), "the depth of an entity");
}

void Twins::check_hierarchy() {
    hierarchy_.update();
    std::vector<std::uint64_t> found;
    std::vector<std::uint64_t> expected;
    const auto pair = [](Entity parent, Entity child) {
        return key_of(parent) * 0x9e3779b97f4a7c15u + key_of(child);
    };
    for (const Entity entity : model_.alive()) {
        for (const Entity child : hierarchy_.children(entity))
            found.push_back(pair(entity, child));
        const std::optional<Parent> of = parent_in(model_, entity);
        if (of && of->entity != entity && model_.find(of->entity) != nullptr)
            expected.push_back(pair(of->entity, entity));
    }
    std::ranges::sort(found);
    std::ranges::sort(expected);
    expect(found == expected, "all children of all entities");
}

}  // namespace rambla::ecs::property
