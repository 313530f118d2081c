#include "systems/simulate/actors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "systems/position.h"
#include "systems/simulate/paths.h"
#include "systems/simulate/random.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

constexpr float k_step = 1.0f / 60.0f;

/// Pavements around blocks: a grid of points 20 m apart, all neighbours joined, 3 m wide.
assets::PathNetwork grid(std::uint32_t side) {
    assets::PathNetwork network;
    for (std::uint32_t z = 0; z < side; ++z) {
        for (std::uint32_t x = 0; x < side; ++x) {
            network.points.push_back({20.0f * static_cast<float>(x), 0.15f, 20.0f * static_cast<float>(z)});
            const std::uint32_t here = z * side + x;
            if (x > 0) network.links.push_back({here - 1, here, 1.5f, true});
            if (z > 0) network.links.push_back({here - side, here, 1.5f, true});
        }
    }
    return network;
}

PathGraph graph_of(const assets::PathNetwork& network, const WorldPosition& origin = {}) {
    PathGraph graph;
    graph.add(network, origin);
    return graph;
}

/// Distance on the ground from a point to the middle of the nearest link.
float distance_to_links_m(const assets::PathNetwork& network, glm::vec3 p) {
    float nearest = 1e9f;
    for (const auto& link : network.links) {
        const glm::vec2 a{network.points[link.from].x, network.points[link.from].z};
        const glm::vec2 b{network.points[link.to].x, network.points[link.to].z};
        const glm::vec2 q{p.x, p.z};
        const float t = std::clamp(glm::dot(q - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
        nearest = std::min(nearest, glm::distance(q, a + t * (b - a)));
    }
    return nearest;
}

assets::ActorStart walker(std::uint32_t link, float along, float aside_m, float speed_m_s) {
    return {assets::ActorKind::walker, 0, link, along, aside_m, speed_m_s, false};
}

TEST(Walkers, MoveContinuouslyAtTheirSpeedWithinThePavement) {
    const assets::PathNetwork network = grid(5);
    const PathGraph graph = graph_of(network);
    const WorldPosition origin;
    for (std::uint64_t who = 0; who < 20; ++who) {
        const float speed = 0.8f + 0.06f * static_cast<float>(who);
        PathFollower follower =
            starting(graph, 0, walker(static_cast<std::uint32_t>(who), 0.5f, 0.4f, speed));
        glm::vec3 last = offset_m(origin, place_of(graph, follower));
        float walked = 0.0f;
        for (int i = 0; i < 6000; ++i) {
            const glm::vec2 heading = follower.heading;
            follower = advanced(graph, follower, 42, who, k_step);
            const glm::vec3 here = offset_m(origin, place_of(graph, follower));
            const float moved_m = glm::distance(here, last);
            ASSERT_LT(moved_m, 0.05f) << "no leap";
            ASSERT_NEAR(moved_m, speed * k_step, 0.1f * speed * k_step)
                << "constant speed, also around corners";
            ASSERT_LE(distance_to_links_m(network, here), 1.5f);
            ASSERT_NEAR(here.y, 0.15f, 1e-4f);
            // 6 rad/s at most: 0.1 rad in a step.
            ASSERT_GT(glm::dot(heading, follower.heading), std::cos(0.101f)) << "no sudden turn";
            ASSERT_NEAR(glm::length(follower.heading), 1.0f, 1e-5f);
            walked += moved_m;
            last = here;
        }
        EXPECT_GT(follower.turns, 2u);
        EXPECT_NEAR(walked, 100.0f * speed, 1.0f * speed);
    }
}

TEST(Walkers, FaceWhereTheyGoAndKeepRight) {
    const PathGraph graph = graph_of(grid(5));
    PathFollower follower = starting(graph, 0, walker(0, 0.5f, 0.0f, 1.4f));
    int straight_steps = 0;
    for (int i = 0; i < 8000; ++i) {
        const PathFollower before = follower;
        follower = advanced(graph, follower, 1, 1, k_step);
        if (before.turning || follower.turning || follower.turns == 0) continue;
        // Past the first metre of a straight the heading has caught up with the path.
        if (follower.progress < 4.0f) continue;
        const glm::vec3 ahead = offset_m(place_of(graph, before), place_of(graph, follower));
        const glm::vec2 way = glm::normalize(glm::vec2{ahead.x, ahead.z});
        ASSERT_GT(glm::dot(way, follower.heading), 0.999f);
        ASSERT_GT(follower.leg.aside_m, 0.1f);
        // Right of the direction (x, z) on the ground is (−z, x), seen from above with z towards us.
        const glm::vec3 aside = graph.point_on(follower.leg, 0.0f);
        ASSERT_NEAR(glm::dot(glm::vec2(aside.x, aside.z), glm::vec2(-way.y, way.x)), follower.leg.aside_m,
                    1e-3f);
        ++straight_steps;
    }
    EXPECT_GT(straight_steps, 3000);
}

TEST(Walkers, PassOncomingOnesWithoutTouching) {
    // A crossing, the default walkway, and wider ones; 0.01 mm is the rounding of sums of metres.
    for (const float half_width : {0.40f, 0.45f, 0.4725f, 1.0f, 1.5f}) {
        assets::PathNetwork street;
        street.points = {{-40, 0, 0}, {-20, 0, 0}, {20, 0, 0}, {40, 0, 0}};
        for (std::uint32_t i = 0; i < 3; ++i)
            street.links.push_back({i, i + 1, half_width, true});
        const PathGraph graph = graph_of(street);
        // On the middle link, by direction: nearest to the other side, which lies on z < 0 going towards −x.
        float nearest_forwards = 1e9f;
        float nearest_backwards = 1e9f;
        float farthest_forwards = 0.0f;
        for (std::uint64_t who = 0; who < 40; ++who) {
            // Starts in the middle of the link say nothing about the sides that walkers choose.
            PathFollower follower = starting(graph, 0, walker(0, 0.5f, 0.0f, 1.6f));
            for (int i = 0; i < 60 * 90; ++i) {
                follower = advanced(graph, follower, 4, who, k_step);
                if (follower.turning || follower.leg.link != 1) continue;
                const float z = offset_m({}, place_of(graph, follower)).z;
                ASSERT_LE(std::abs(z), half_width + 1e-5f);
                float& nearest = follower.leg.backwards ? nearest_backwards : nearest_forwards;
                nearest = std::min(nearest, follower.leg.backwards ? -z : z);
                if (!follower.leg.backwards) farthest_forwards = std::max(farthest_forwards, z);
            }
        }
        // Any two may meet: the worst pair's middles, less half the breadth of each.
        const float between_shoulders = nearest_forwards + nearest_backwards - 2.0f * assets::k_walker_half_m;
        EXPECT_GE(between_shoulders, -1e-5f) << "half width " << half_width;
        EXPECT_LT(nearest_forwards, 1e8f);
        EXPECT_LT(nearest_backwards, 1e8f);
        EXPECT_GT(farthest_forwards - nearest_forwards, 0.05f) << "room to overtake";
    }
}

TEST(Walkers, TurnBackOnlyAtDeadEnds) {
    assets::PathNetwork cross;
    cross.points = {{0, 0, 0}, {10, 0, 0}, {-10, 0, 0}, {0, 0, 10}};
    cross.links = {{0, 1, 1.0f, true}, {0, 2, 1.0f, true}, {0, 3, 1.0f, true}};
    const PathGraph graph = graph_of(cross);
    PathFollower follower = starting(graph, 0, walker(0, 0.5f, 0.3f, 1.5f));
    int back = 0;
    int through = 0;
    for (int i = 0; i < 60 * 600; ++i) {
        const PathFollower before = follower;
        follower = advanced(graph, follower, 9, 3, k_step);
        if (!follower.turning || before.turning) continue;
        const bool same = follower.next.link == follower.leg.link;
        const bool dead_end = graph.end_of(follower.leg) != 0;
        ASSERT_EQ(same, dead_end);
        ++(same ? back : through);
    }
    EXPECT_GT(back, 20);
    EXPECT_GT(through, 20);
}

TEST(Walkers, ChooseEveryWayOutEquallyOften) {
    const PathGraph graph = graph_of(grid(3));
    const PathLeg into_the_middle{[&] {
                                      for (std::uint32_t i = 0; i < graph.links().size(); ++i) {
                                          if (graph.links()[i].to == 4) return i;
                                      }
                                      return 0u;
                                  }(),
                                  false, 0.5f};
    std::vector<int> chosen(graph.links().size());
    for (std::uint64_t who = 0; who < 3000; ++who) {
        PathFollower follower;
        follower.leg = into_the_middle;
        follower.progress = 18.49f;
        follower = advanced(graph, follower, 5, who, k_step);
        ASSERT_TRUE(follower.turning);
        ++chosen[follower.next.link];
    }
    int ways = 0;
    for (const int count : chosen) {
        if (count == 0) continue;
        EXPECT_NEAR(count, 1000, 130);  // five standard deviations of a fair choice among three
        ++ways;
    }
    EXPECT_EQ(ways, 3);
}

TEST(Walkers, DependOnSeedAndNameAlone) {
    const PathGraph graph = graph_of(grid(5));
    const auto end = [&](std::uint64_t seed, std::uint64_t who) {
        PathFollower follower = starting(graph, 0, walker(3, 0.2f, 0.4f, 1.3f));
        for (int i = 0; i < 20000; ++i)
            follower = advanced(graph, follower, seed, who, k_step);
        return offset_m({}, place_of(graph, follower));
    };
    EXPECT_EQ(end(1, 1), end(1, 1));
    EXPECT_NE(end(1, 1), end(2, 1));
    EXPECT_NE(end(1, 1), end(1, 2));
}

TEST(Walkers, NeverLeapOnRandomNetworks) {
    test::Random random{8};
    for (int trial = 0; trial < 60; ++trial) {
        assets::PathNetwork network;
        for (int i = 0; i < 12; ++i)
            network.points.push_back(random.point(15.0f) * glm::vec3{1.0f, 0.02f, 1.0f});
        for (int i = 0; i < 18; ++i)
            network.links.push_back(
                {random.below(12), random.below(12), random.uniform(0.0f, 2.0f), random.below(2) == 0});
        network.links.push_back({3, 3, 1.0f, true});  // leads nowhere
        const PathGraph graph = graph_of(network);
        for (std::uint32_t link = 0; link < network.links.size(); ++link) {
            PathFollower follower = starting(
                graph, 0, walker(link, random.uniform(0.0f, 1.0f), random.uniform(-2.0f, 2.0f), 1.6f));
            glm::vec3 last = offset_m({}, place_of(graph, follower));
            for (int i = 0; i < 1200; ++i) {
                follower = advanced(graph, follower, 7, link, k_step);
                const glm::vec3 here = offset_m({}, place_of(graph, follower));
                ASSERT_LT(glm::distance(here, last), 0.05f)
                    << "trial " << trial << ", link " << link << ", step " << i;
                last = here;
            }
        }
    }
}

TEST(Cars, RoundCornersSlowlyEnoughToSteer) {
    assets::PathNetwork ring;
    ring.points = {{0, 0, 0}, {60, 0, 0}, {60, 0, 60}, {0, 0, 60}};
    ring.links = {{0, 1, 0.0f, false}, {1, 2, 0.0f, false}, {2, 3, 0.0f, false}, {3, 0, 0.0f, false}};
    const PathGraph graph = graph_of(ring);
    PathFollower car = starting(graph, 0, {assets::ActorKind::car, 0, 0, 0.5f, 0.0f, 7.0f, false});
    glm::vec3 last = offset_m({}, place_of(graph, car));
    for (int i = 0; i < 6000; ++i) {
        const glm::vec2 heading = car.heading;
        car = advanced(graph, car, 1, 1, k_step);
        const glm::vec3 here = offset_m({}, place_of(graph, car));
        ASSERT_NEAR(glm::distance(here, last), 7.0f * k_step, 0.02f * 7.0f * k_step);
        // Radius 4 m at 7 m/s is 1.75 rad/s; the Bézier's tightest point is a little tighter.
        ASSERT_GT(glm::dot(heading, car.heading), std::cos(2.2f * k_step));
        ASSERT_FALSE(car.leg.backwards);
        last = here;
    }
    EXPECT_NEAR(car.travelled_m, 700.0, 0.01);
    EXPECT_GT(car.turns, 8u);
}

TEST(CounterBasedRandom, IsUniformAndFreeOfPatterns) {
    std::vector<int> buckets(16);
    for (std::uint64_t who = 0; who < 200; ++who) {
        for (std::uint64_t count = 0; count < 200; ++count) {
            const float u = unit_interval(random_bits(1, who, count));
            ASSERT_GE(u, 0.0f);
            ASSERT_LT(u, 1.0f);
            ++buckets[static_cast<std::size_t>(u * 16.0f)];
        }
    }
    for (const int count : buckets)
        EXPECT_NEAR(count, 2500, 250);  // five standard deviations
}

}  // namespace
}  // namespace rambla::systems
