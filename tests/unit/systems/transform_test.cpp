#include "systems/simulate/transform.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/allocation_counter.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

using test::Random;

ecs::Entity moving_root(ecs::World& world, const LocalTransform& local, glm::ivec3 cell = {}) {
    return world.create(local, Cell{cell}, WorldTransform{}, PreviousWorldTransform{});
}
ecs::Entity moving_child(ecs::World& world, ecs::Entity parent, const LocalTransform& local) {
    return world.create(local, Parent{parent}, WorldTransform{}, PreviousWorldTransform{});
}

LocalTransform random_local(Random& random) {
    // Non-uniform and negative scales: chains of them shear and mirror.
    glm::vec3 scale = random.point(1.5f);
    for (int axis = 0; axis < 3; ++axis)
        scale[axis] += scale[axis] < 0.0f ? -0.3f : 0.3f;
    return {random.point(3.0f), random.rotation(), scale};
}

/// The same map by another way: 4×4 matrices in double, from the root down.
glm::dmat4 naive(const ecs::World& world, ecs::Entity entity) {
    const LocalTransform& local = world.get<LocalTransform>(entity);
    glm::dmat4 matrix = glm::mat4_cast(glm::dquat{local.rotation});
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis] *= static_cast<double>(local.scale[axis]);
    matrix[3] = glm::dvec4{local.translation_m, 1.0};
    const Parent* parent = world.try_get<Parent>(entity);
    return parent != nullptr ? naive(world, parent->entity) * matrix : matrix;
}

void expect_near(const WorldTransform& made, const glm::dmat4& expected, double relative) {
    double largest = 1.0;
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(expected[c][r]));
    }
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(made.linear[c][r], expected[c][r], relative * largest);
        ASSERT_NEAR(made.translation_m[r], expected[3][r], relative * largest);
    }
}

TEST(TransformHierarchy, EqualsNaiveRecursionWithShearAndMirrors) {
    Random random{1};
    ecs::World world;
    std::vector<ecs::Entity> entities{moving_root(world, {glm::vec3{100.0f}, random.rotation(), {1, -2, 3}})};
    for (int i = 0; i < 3000; ++i) {
        entities.push_back(moving_child(world,
                                        entities[random.below(static_cast<std::uint32_t>(entities.size()))],
                                        random_local(random)));
    }
    TransformPropagation{}(world);
    // Trees of 3000 random nodes are about 20 deep; each level adds a few roundings of 6e-8.
    for (const ecs::Entity entity : entities)
        expect_near(world.get<WorldTransform>(entity), naive(world, entity), 1e-5);
}

TEST(TransformHierarchy, DoesNotDependOnTheOrderOfCreation) {
    ecs::World world;
    // Children are made before their parents, and every second one lies in another archetype.
    const ecs::Entity child =
        world.create(LocalTransform{{0, 0, 1}}, Parent{}, WorldTransform{}, PreviousWorldTransform{}, Gait{});
    const ecs::Entity middle =
        world.create(LocalTransform{{0, 1, 0}}, Parent{}, WorldTransform{}, PreviousWorldTransform{});
    const ecs::Entity root = moving_root(world, {{1, 0, 0}});
    world.get_mut<Parent>(child).entity = middle;
    world.get_mut<Parent>(middle).entity = root;
    TransformPropagation{}(world);
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(1, 1, 1));
}

TEST(TransformHierarchy, FollowsStructuralChanges) {
    ecs::World world;
    TransformPropagation propagate;
    const ecs::Entity a = moving_root(world, {{1, 0, 0}});
    const ecs::Entity b = moving_root(world, {{2, 0, 0}});
    const ecs::Entity child = moving_child(world, a, {{0, 5, 0}});
    propagate(world);
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(1, 5, 0));
    world.get_mut<Parent>(child).entity = b;
    propagate(world);
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(2, 5, 0));
    world.add(a, Gait{});  // moves a to another archetype, and b to a's row
    world.get_mut<LocalTransform>(b).translation_m.x = 3.0f;
    propagate(world);
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(3, 5, 0));
    EXPECT_EQ(world.get<WorldTransform>(a).translation_m, glm::vec3(1, 0, 0));
    world.destroy(b);
    propagate(world);
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(3, 5, 0)) << "orphans stay";
    EXPECT_EQ(world.get<PreviousWorldTransform>(child).value.translation_m, glm::vec3(3, 5, 0)) << "and rest";
}

TEST(TransformHierarchy, MovingChildrenOfRestingParentsMove) {
    ecs::World world;
    const ecs::Entity house =
        world.create(LocalTransform{}, WorldTransform{{4, 0, 0}, glm::mat3{2.0f}, {10, 0, 0}});
    const ecs::Entity door = moving_child(world, house, {{1, 0, 0}});
    const ecs::Entity handle = moving_child(world, door, {{0, 1, 0}});
    TransformPropagation{}(world);
    EXPECT_EQ(world.get<WorldTransform>(handle).translation_m, glm::vec3(12, 2, 0));
    EXPECT_EQ(world.get<WorldTransform>(handle).cell, glm::ivec3(4, 0, 0));
}

TEST(TransformHierarchy, ARingOfParentsIsLeftAlone) {
    ecs::World world;
    const ecs::Entity a = moving_child(world, {}, {});
    const ecs::Entity b = moving_child(world, a, {{1, 1, 1}});
    world.get_mut<Parent>(a).entity = b;
    TransformPropagation{}(world);
    EXPECT_EQ(world.get<WorldTransform>(b).translation_m, glm::vec3(0.0f));
}

TEST(TransformHierarchy, DoesNotTouchWhatRests) {
    ecs::World world;
    world.create(LocalTransform{{5, 0, 0}}, Cell{}, WorldTransform{{}, glm::mat3{1.0f}, {7, 0, 0}});
    moving_root(world, {});
    TransformPropagation{}(world);
    ecs::Query<const WorldTransform, ecs::Without<PreviousWorldTransform>> resting;
    for (auto [transforms] : resting.chunks(world))
        EXPECT_EQ(transforms[0].translation_m.x, 7.0f);
}

TEST(TransformHierarchy, RootsThatLeaveTheirCellCountFromTheNext) {
    ecs::World world;
    TransformPropagation propagate;
    const ecs::Entity root = moving_root(world, {{255.5f, 0.0f, 0.25f}}, {7, 0, 0});
    const ecs::Entity child = moving_child(world, root, {{1, 0, 0}});
    propagate(world);
    world.get_mut<LocalTransform>(root).translation_m += glm::vec3{1.0f, 0.0f, -0.5f};
    propagate(world);
    EXPECT_EQ(world.get<Cell>(root).value, glm::ivec3(8, 0, -1));
    EXPECT_EQ(world.get<LocalTransform>(root).translation_m, glm::vec3(0.5f, 0.0f, 255.75f));
    EXPECT_EQ(world.get<WorldTransform>(child).cell, glm::ivec3(8, 0, -1));
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(1.5f, 0.0f, 255.75f));
    EXPECT_EQ(world.get<PreviousWorldTransform>(child).value.cell, glm::ivec3(7, 0, 0));
}

TEST(TransformHierarchy, SettlingMakesBothTransformsAlike) {
    ecs::World world;
    const ecs::Entity root = moving_root(world, {{1, 2, 3}});
    settle(world);
    EXPECT_EQ(world.get<WorldTransform>(root).translation_m, glm::vec3(1, 2, 3));
    EXPECT_EQ(world.get<PreviousWorldTransform>(root).value.translation_m, glm::vec3(1, 2, 3));
}

TEST(TransformHierarchy, ASteadyStepAllocatesNothing) {
    Random random{2};
    ecs::World world;
    std::vector<ecs::Entity> entities{moving_root(world, {})};
    for (int i = 0; i < 5000; ++i) {
        entities.push_back(moving_child(world,
                                        entities[random.below(static_cast<std::uint32_t>(entities.size()))],
                                        random_local(random)));
    }
    TransformPropagation propagate;
    propagate(world);
    propagate(world);
    const std::size_t before = test::allocation_count();
    propagate(world);
    EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::systems
