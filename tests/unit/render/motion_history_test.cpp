#include "render/motion_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "assets/scene.h"
#include "support/allocation_counter.h"

namespace rambla::render {
namespace {

systems::Instance at(glm::vec3 place_m, std::uint32_t object = 0) {
    systems::Instance instance;
    instance.row0.w = place_m.x;
    instance.row1.w = place_m.y;
    instance.row2.w = place_m.z;
    instance.object = object;
    return instance;
}

systems::JointMatrix joint_at(glm::vec3 place_m) {
    return {{1, 0, 0, place_m.x}, {0, 1, 0, place_m.y}, {0, 0, 1, place_m.z}};
}

void add_batch(systems::Frame& frame, std::initializer_list<systems::Instance> instances,
               systems::Pipeline pipeline = {}, std::uint32_t mesh = 0) {
    frame.opaque.push_back({.pipeline = systems::pack(pipeline),
                            .material = 7,
                            .mesh = mesh,
                            .first_instance = static_cast<std::uint32_t>(frame.instances.size()),
                            .instance_count = static_cast<std::uint32_t>(instances.size())});
    frame.instances.insert(frame.instances.end(), instances);
}

constexpr glm::dvec3 k_no_shift{0.0};

TEST(MotionHistory, FindsWhatMovedByItsObjectWhereverItStandsInTheQueue) {
    MotionHistory history;
    systems::Frame first, second;
    add_batch(first, {at({1, 0, -5}, 10), at({2, 0, -5}, 11), at({3, 0, -5}, 12)});
    add_batch(second, {at({3, 0, -5}, 12), at({2.5f, 0, -5}, 11), at({1, 0, -5}, 10)});
    EXPECT_EQ(history.follow(first, k_no_shift).count(), 0u) << "nothing has a past yet";
    const MovedThings& moved = history.follow(second, k_no_shift);
    ASSERT_EQ(moved.count(), 1u);
    ASSERT_EQ(moved.batches.size(), 1u);
    EXPECT_EQ(moved.batches[0].first_instance, 3u) << "behind the Frame's own";
    EXPECT_EQ(moved.batches[0].instance_count, 1u);
    EXPECT_EQ(moved.batches[0].material, 7u);
    EXPECT_EQ(moved.instances[0].row0.w, 2.5f) << "first as it is";
    EXPECT_EQ(moved.instances[1].row0.w, 2.0f) << "then as it was";
}

TEST(MotionHistory, TakesTheEyesOwnMotionForNone) {
    MotionHistory history;
    systems::Frame first, second;
    add_batch(first, {at({100.1f, 2, -50}, 1), at({0.3f, 0, -1}, 2)});
    // The eye goes 0.7 m to the right, and what rests goes to the left, each rounded by itself.
    add_batch(second, {at({100.1f - 0.7f, 2, -50}, 1), at({0.3f - 0.7f, 0, -1}, 2)});
    static_cast<void>(history.follow(first, k_no_shift));
    EXPECT_EQ(history.follow(second, {0.7, 0, 0}).count(), 0u);
}

/// A thirtieth of a pixel is seen by nobody; a tenth of a millimetre a metre before the eye must be found.
TEST(MotionHistory, TellsRestFromTheLeastMotionThatMatters) {
    for (const float step_m : {0.00002f, 0.0002f}) {
        MotionHistory history;
        systems::Frame first, second;
        add_batch(first, {at({0, 0, -1}, 1)});
        add_batch(second, {at({step_m, 0, -1}, 1)});
        static_cast<void>(history.follow(first, k_no_shift));
        EXPECT_EQ(history.follow(second, k_no_shift).count(), step_m > 0.0001f ? 1u : 0u) << step_m;
    }
}

TEST(MotionHistory, SeesThingsTurnInPlace) {
    MotionHistory history;
    systems::Frame first, second;
    add_batch(first, {at({0, 0, -5}, 1)});
    systems::Instance turned = at({0, 0, -5}, 1);
    turned.row0.x = turned.row1.y = std::cos(1e-4f);
    turned.row0.y = -std::sin(1e-4f);
    turned.row1.x = std::sin(1e-4f);
    add_batch(second, {turned});
    static_cast<void>(history.follow(first, k_no_shift));
    EXPECT_EQ(history.follow(second, k_no_shift).count(), 1u);
}

TEST(MotionHistory, GivesNoPastToWhatIsNewOrIsAnotherMesh) {
    MotionHistory history;
    systems::Frame first, second;
    add_batch(first, {at({0, 0, -5}, 1)});
    add_batch(second, {at({1, 0, -5}, 2)});
    add_batch(second, {at({1, 0, -5}, 1)}, {}, 3);
    static_cast<void>(history.follow(first, k_no_shift));
    EXPECT_EQ(history.follow(second, k_no_shift).count(), 0u);
}

TEST(MotionHistory, ForgetsAtACut) {
    MotionHistory history;
    systems::Frame first, second;
    add_batch(first, {at({0, 0, -5}, 1)});
    add_batch(second, {at({1, 0, -5}, 1)});
    static_cast<void>(history.follow(first, k_no_shift));
    history.forget();
    EXPECT_EQ(history.follow(second, k_no_shift).count(), 0u);
    EXPECT_EQ(history.follow(first, k_no_shift).count(), 1u) << "and begins anew";
}

TEST(MotionHistory, KnowsSkinsByTheirJoints) {
    constexpr systems::Pipeline skinned{.skinned = true};
    const auto frame_of = [&](float hand_x, bool with_another) {
        systems::Frame frame;
        systems::Instance body = at({0, 0, 0}, 1);
        if (with_another) {  // whose joints come first, so that those of the body begin elsewhere
            add_batch(frame, {at({0, 0, 0}, 2)}, skinned);
            frame.joints = {joint_at({5, 0, -5})};
            body.joints = 1;
        }
        add_batch(frame, {body}, skinned);
        frame.joints.push_back(joint_at({0, 0, -5}));
        frame.joints.push_back(joint_at({hand_x, 0, -5}));
        return frame;
    };
    MotionHistory history;
    const systems::Frame first = frame_of(1.0f, false), second = frame_of(1.0f, true),
                         third = frame_of(1.5f, true);
    static_cast<void>(history.follow(first, k_no_shift));
    EXPECT_EQ(history.follow(second, k_no_shift).count(), 0u);
    const MovedThings& moved = history.follow(third, k_no_shift);
    ASSERT_EQ(moved.count(), 1u);
    ASSERT_EQ(moved.joints.size(), 3u) << "all those of the moment before";
    EXPECT_EQ(moved.instances[0].joints, 1u);
    ASSERT_EQ(moved.instances[1].joints, 3u + 1u) << "behind the Frame's three";
    EXPECT_EQ(moved.joints[moved.instances[1].joints - 3u + 1u].row0.w, 1.0f) << "where the hand was";
}

TEST(MotionHistory, KnowsMorphsByTheirTerms) {
    constexpr systems::Pipeline morphed{.morphed = true};
    const auto frame_of = [&](std::vector<systems::MorphTerm> terms) {
        systems::Frame frame;
        add_batch(frame, {at({0, 0, -5}, 1)}, morphed);
        frame.morphs = std::move(terms);
        frame.morphs.push_back({});
        return frame;
    };
    MotionHistory history;
    const std::array frames{frame_of({}), frame_of({{4, 0.5f}}), frame_of({{4, 0.5f}}), frame_of({{5, 0.5f}}),
                            frame_of({{5, 0.25f}})};
    std::vector<std::uint32_t> counts;
    for (const systems::Frame& frame : frames)
        counts.push_back(history.follow(frame, k_no_shift).count());
    EXPECT_EQ(counts, (std::vector<std::uint32_t>{0, 1, 0, 1, 1}));
    const MovedThings& moved = history.follow(frames[1], k_no_shift);
    ASSERT_EQ(moved.morphs.size(), 2u);
    EXPECT_EQ(moved.instances[1].morphs, 2u) << "behind the Frame's term and its end";
    EXPECT_EQ(moved.morphs[0].weight, 0.25f);
}

TEST(MotionHistory, CountsWhatIsNoNumberAsMoved) {
    MotionHistory history;
    systems::Frame frame;
    add_batch(frame, {at({std::numeric_limits<float>::quiet_NaN(), 0, -5}, 1),
                      at({std::numeric_limits<float>::infinity(), 0, -5}, 2)});
    static_cast<void>(history.follow(frame, k_no_shift));
    EXPECT_EQ(history.follow(frame, k_no_shift).count(), 2u);
}

TEST(MotionHistory, LeavesOutWhatIsBlendedButKnowsWhereItWasOnceItIsWhole) {
    MotionHistory history;
    systems::Frame fading, whole;
    add_batch(fading, {at({0, 0, -5}, 1)}, {.fading = true});
    std::swap(fading.opaque, fading.blended);
    add_batch(whole, {at({1, 0, -5}, 1)});
    static_cast<void>(history.follow(whole, k_no_shift));
    EXPECT_EQ(history.follow(fading, k_no_shift).count(), 0u);
    EXPECT_EQ(history.follow(whole, k_no_shift).count(), 1u);
}

TEST(MotionHistory, AllocatesNothingInASteadyFrame) {
    MotionHistory history;
    systems::Frame first, second;
    for (std::uint32_t i = 0; i < 100; ++i) {
        add_batch(first, {at({0, 0, -5}, i)});
        add_batch(second, {at({1, 0, -5}, i)});
    }
    for (int i = 0; i < 2; ++i) {
        static_cast<void>(history.follow(first, k_no_shift));
        static_cast<void>(history.follow(second, k_no_shift));
    }
    const std::size_t before = test::allocation_count();
    EXPECT_EQ(history.follow(first, k_no_shift).count(), 100u);
    EXPECT_EQ(test::allocation_count(), before);
}

}  // namespace
}  // namespace rambla::render
