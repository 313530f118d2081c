#include "systems/position.h"

#include <gtest/gtest.h>

#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

glm::dvec3 absolute(const WorldPosition& p) {
    return glm::dvec3{p.cell} * 256.0 + glm::dvec3{p.local_m};
}

TEST(WorldPosition, NormalisingKeepsThePlaceAndBringsItIntoItsCell) {
    test::Random random{1};
    for (int i = 0; i < 100000; ++i) {
        const WorldPosition place{glm::ivec3{random.point(4000.0f)},
                                  random.point(std::exp2(random.uniform(-30.0f, 14.0f)))};
        const WorldPosition made = normalised(place);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_GE(made.local_m[axis], 0.0f);
            ASSERT_LT(made.local_m[axis], k_cell_m);
            // One rounding of a float below 256 is at most 2⁻¹⁷ m.
            ASSERT_NEAR(absolute(made)[axis], absolute(place)[axis], 7.7e-6);
        }
    }
}

TEST(WorldPosition, ATinyNegativeNumberGoesToTheNextCell) {
    const WorldPosition made = normalised({{0, 0, 0}, {-1e-9f, 0.0f, 256.0f}});
    EXPECT_EQ(made.cell, glm::ivec3(0, 0, 1));
    EXPECT_EQ(made.local_m, glm::vec3(0.0f));
}

TEST(WorldPosition, OffsetsAreTheSameAnywhere) {
    const WorldPosition eye{{0, 0, 0}, {255.99f, 1.7f, 3.0f}};
    const WorldPosition thing{{1, 0, -1}, {0.01f, 1.5f, 250.0f}};
    // Odd numbers beyond 2²⁴: not even whole cells would survive a detour through floats.
    const glm::ivec3 far{20000001, -30000003, 100000001};
    const WorldPosition far_eye{eye.cell + far, eye.local_m};
    const WorldPosition far_thing{thing.cell + far, thing.local_m};
    EXPECT_EQ(offset_m(eye, thing), offset_m(far_eye, far_thing));
    EXPECT_NEAR(offset_m(eye, thing).x, 0.02f, 1.6e-5f);  // a float's step at 256 m
    const WorldPosition ends[]{{{-2147483647, 0, 0}, {}}, {{2147483647, 0, 0}, {}}};
    EXPECT_FLOAT_EQ(offset_m(ends[0], ends[1]).x, 4294967294.0f * 256.0f) << "no integer overflow";
}

TEST(WorldPosition, MovingFarKeepsMillimetres) {
    const WorldPosition made = moved({{10, 0, 0}, {1.25f, 0.0f, 0.0f}}, {1.0e6 + 0.001, -300.0, 0.0});
    EXPECT_NEAR(absolute(made).x, 2560.0 + 1.25 + 1.0e6 + 0.001, 1e-5);
    EXPECT_NEAR(absolute(made).y, -300.0, 1e-5);
}

}  // namespace
}  // namespace rambla::systems
