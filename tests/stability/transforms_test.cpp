#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "systems/components.h"
#include "systems/simulate/transform.h"

namespace rambla::systems {
namespace {

TEST(TransformStability, QuaternionsStayUnitOverTenMillionCompositions) {
    const glm::quat turn = glm::angleAxis(0.37f, glm::normalize(glm::vec3{1, 2, 3}));
    const glm::quat skewed{turn.w * 1.00001f, turn.x, turn.y,
                           turn.z};  // a factor that is not quite a rotation
    glm::quat rotation{1, 0, 0, 0};
    double worst = 0.0;
    for (int i = 0; i < 10000000; ++i) {
        rotation = renormalised(rotation * skewed);
        const glm::dquat exact{rotation};
        worst = std::max(worst, std::abs(std::sqrt(glm::dot(exact, exact)) - 1.0));
    }
    EXPECT_LT(worst, 1e-6);
}

TEST(TransformStability, AnyQuaternionBecomesUnitOrIdentity) {
    constexpr float k_max = std::numeric_limits<float>::max();
    constexpr float k_tiny = std::numeric_limits<float>::denorm_min();
    constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
    for (const glm::quat q : {glm::quat{k_max, k_max, -k_max, k_max}, glm::quat{k_tiny, 0, 0, k_tiny},
                              glm::quat{0, 0, 0, 3}, glm::quat{0, 0, 0, 0}, glm::quat{1, k_nan, 0, 0},
                              glm::quat{1, std::numeric_limits<float>::infinity(), 0, 0},
                              glm::quat{0.98f, 0.0f, 0.0f, 0.0f}, glm::quat{1.03f, 0.01f, 0.0f, 0.0f}}) {
        const glm::quat made = renormalised(q);
        // One Newton step leaves 3/8 · ε² of a squared length that is off by ε ≤ 1/16.
        EXPECT_NEAR(std::sqrt(glm::dot(made, made)), 1.0f, 0.0015f) << q.w << ' ' << q.x;
    }
    EXPECT_EQ(renormalised({0, 0, 0, 0}).w, 1.0f);
}

TEST(TransformStability, HierarchiesAThousandDeepEqualTheirProduct) {
    std::mt19937 engine{1};
    std::uniform_real_distribution<float> unit{-1.0f, 1.0f};
    ecs::World world;
    std::vector<ecs::Entity> chain;
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{128.0};
    for (int depth = 0; depth < 1000; ++depth) {
        const glm::quat rotation = glm::normalize(glm::quat{1.0f, unit(engine), unit(engine), unit(engine)});
        // Scales that shear and mirror, but whose product stays near one.
        const float stretch = std::exp2(0.2f * unit(engine));
        const LocalTransform local{
            {unit(engine), unit(engine), unit(engine)}, rotation, {stretch, -1.0f / stretch, 1.0f}};
        if (depth == 0) {
            chain.push_back(world.create(LocalTransform{glm::vec3{128.0f}}, Cell{}, WorldTransform{},
                                         PreviousWorldTransform{}));
        }
        chain.push_back(
            world.create(local, Parent{chain.back()}, WorldTransform{}, PreviousWorldTransform{}));
        glm::dmat3 step = glm::mat3_cast(glm::dquat{rotation});
        for (int axis = 0; axis < 3; ++axis)
            step[axis] *= static_cast<double>(local.scale[axis]);
        translation += linear * glm::dvec3{local.translation_m};
        linear = linear * step;
    }
    TransformPropagation{}(world);
    const WorldTransform& last = world.get<WorldTransform>(chain.back());
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        size = std::max(size, glm::length(linear[axis]));
    // A thousand products of matrices with roundings of 6e-8 each, which sum like a random walk or at worst
    // linearly.
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r)
            EXPECT_NEAR(last.linear[c][r], linear[c][r], 1e-4 * size);
    }
    EXPECT_LT(glm::distance(glm::dvec3{last.translation_m}, translation),
              1e-4 * 1000.0 * std::max(size, 1.0));
}

TEST(TransformStability, ZeroScalesStayFinite) {
    ecs::World world;
    const ecs::Entity root = world.create(LocalTransform{{1, 2, 3}, {0, 0, 0, 0}, {0, 1, 1}}, Cell{},
                                          WorldTransform{}, PreviousWorldTransform{});
    const ecs::Entity child = world.create(LocalTransform{{5, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}}, Parent{root},
                                           WorldTransform{}, PreviousWorldTransform{});
    TransformPropagation{}(world);
    EXPECT_EQ(world.get<WorldTransform>(child).translation_m, glm::vec3(1, 2, 3));
    EXPECT_EQ(world.get<WorldTransform>(child).linear, glm::mat3(0.0f));
}

TEST(TransformStability, PlacesThatAreNotNumbersStayWhereTheyAreAndHarmNobody) {
    ecs::World world;
    const float bad = std::numeric_limits<float>::quiet_NaN();
    world.create(LocalTransform{{bad, 1e30f, -std::numeric_limits<float>::infinity()}}, Cell{},
                 WorldTransform{}, PreviousWorldTransform{});
    const ecs::Entity good =
        world.create(LocalTransform{{1, 2, 3}}, Cell{}, WorldTransform{}, PreviousWorldTransform{});
    TransformPropagation{}(world);
    EXPECT_EQ(world.get<WorldTransform>(good).translation_m, glm::vec3(1, 2, 3));
}

}  // namespace
}  // namespace rambla::systems
