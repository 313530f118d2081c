#include "game/camera_path.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace rambla::game {
namespace {

using assets::CameraKey;

std::vector<CameraKey> random_path(unsigned seed) {
    std::mt19937 random{seed};
    std::uniform_real_distribution<float> coordinate{-20.0f, 20.0f};
    std::uniform_real_distribution<float> pause{0.2f, 5.0f};
    std::vector<CameraKey> keys;
    float time_s = 0.0f;
    for (int i = 0; i < 8; ++i) {
        keys.push_back({time_s,
                        {coordinate(random), coordinate(random), coordinate(random)},
                        {coordinate(random), coordinate(random), coordinate(random)}});
        time_s += pause(random);
    }
    return keys;
}

TEST(CameraPath, PassesThroughEveryKeyExactly) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<CameraKey> keys = random_path(seed);
        for (const CameraKey& key : keys) {
            EXPECT_EQ(pose_at(keys, key.time_s).eye_m, key.eye_m);
            EXPECT_EQ(pose_at(keys, key.time_s).target_m, key.target_m);
        }
    }
}

TEST(CameraPath, NeitherPlaceNorVelocityJumpsAtAKey) {
    constexpr float k_dt = 1e-2f;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<CameraKey> keys = random_path(seed);
        for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
            const float t = keys[i].time_s;
            const glm::vec3 before = pose_at(keys, t - k_dt).eye_m;
            const glm::vec3 at = pose_at(keys, t).eye_m;
            const glm::vec3 after = pose_at(keys, t + k_dt).eye_m;
            const glm::vec3 jump = (after - at) / k_dt - (at - before) / k_dt;
            // Velocity is continuous, so the two differences differ by acceleration · dt only. With keys
            // within 40 m and 0.2 s apart at least, accelerations stay below 6 · 70 m / (0.2 s)²; a kink
            // would be of the order of the velocities themselves, hundreds of metres per second on those
            // segments.
            const float shortest_s =
                std::min(keys[i].time_s - keys[i - 1].time_s, keys[i + 1].time_s - keys[i].time_s);
            const float fastest = 70.0f / shortest_s;
            EXPECT_LT(glm::length(jump), 20.0f * fastest / shortest_s * k_dt)
                << "seed " << seed << ", key " << i;
        }
    }
}

TEST(CameraPath, StandsStillBeforeTheFirstAndAfterTheLastKey) {
    const std::vector<CameraKey> keys = random_path(7);
    EXPECT_EQ(pose_at(keys, -3.0f).eye_m, keys.front().eye_m);
    EXPECT_EQ(pose_at(keys, keys.back().time_s + 3.0f).eye_m, keys.back().eye_m);
    EXPECT_EQ(duration_s(keys), keys.back().time_s);
}

TEST(CameraPath, FollowsAParabolaExactlyBetweenInnerKeysOfUnevenTimes) {
    const auto parabola = [](float t) {
        return glm::vec3{3.0f * t - 0.5f * t * t, t, 1.0f - t * t};
    };
    std::vector<CameraKey> keys;
    for (const float t : {0.0f, 0.5f, 1.5f, 2.0f, 4.0f})
        keys.push_back({t, parabola(t), {}});
    for (const float t : {0.7f, 1.1f, 1.6f, 1.9f}) {
        // A few roundings of values below 8.
        EXPECT_LT(glm::distance(pose_at(keys, t).eye_m, parabola(t)), 1e-5f) << t;
    }
}

TEST(CameraPath, OneKeyIsAPathThatStandsStill) {
    const std::vector<CameraKey> keys{{0.0f, {1.0f, 2.0f, 3.0f}, {4.0f, 5.0f, 6.0f}}};
    EXPECT_EQ(pose_at(keys, 1.0f).eye_m, keys[0].eye_m);
    EXPECT_EQ(duration_s(keys), 0.0f);
    EXPECT_EQ(duration_s({}), 0.0f);
}

TEST(LookRotation, TurnsMinusZTowardsTheTargetAndKeepsTheHorizonLevel) {
    std::mt19937 random{3};
    std::uniform_real_distribution<float> coordinate{-10.0f, 10.0f};
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 eye{coordinate(random), coordinate(random), coordinate(random)};
        const glm::vec3 target{coordinate(random), coordinate(random), coordinate(random)};
        const glm::quat rotation = look_rotation(eye, target);
        // Rounding of a unit quaternion: a few 1e-7.
        EXPECT_LT(glm::distance(rotation * glm::vec3{0.0f, 0.0f, -1.0f}, glm::normalize(target - eye)),
                  1e-5f);
        EXPECT_NEAR((rotation * glm::vec3{1.0f, 0.0f, 0.0f}).y, 0.0f, 1e-5f);
        EXPECT_GE((rotation * glm::vec3{0.0f, 1.0f, 0.0f}).y, -1e-5f);
    }
}

TEST(LookRotation, StraightUpDownAndNowhereAreRotationsToo) {
    for (const glm::vec3 target :
         {glm::vec3{0.0f, 5.0f, 0.0f}, glm::vec3{0.0f, -5.0f, 0.0f}, glm::vec3{0.0f}}) {
        const glm::quat rotation = look_rotation(glm::vec3{0.0f}, target);
        EXPECT_NEAR(glm::length(rotation), 1.0f, 1e-5f);
        if (target == glm::vec3{0.0f}) continue;
        EXPECT_LT(glm::distance(rotation * glm::vec3{0.0f, 0.0f, -1.0f}, glm::normalize(target)), 1e-5f);
    }
}

}  // namespace
}  // namespace rambla::game
