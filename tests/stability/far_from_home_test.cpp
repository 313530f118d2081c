#include <gtest/gtest.h>

#include <cstring>

#include "systems/pipeline.h"
#include "systems/position.h"
#include "systems/spawn.h"

namespace rambla::systems {
namespace {

/// A row of walking boxes and a few that rest, on both sides of a cell's border.
assets::Place walkers_across_a_border() {
    assets::Place place;
    place.environment = assets::noon();
    assets::Scene& scene = place.scene;
    scene.materials.emplace_back();
    assets::Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-0.3f, 0, -0.3f}, {0.3f, 1.8f, 0.3f}};
    for (const glm::vec3& p : mesh.positions)
        mesh.bounds.expand(p);
    scene.models.push_back({"box", {{0, 0}}});
    for (std::uint32_t i = 0; i < 11; ++i) {
        assets::Node node;
        node.name = i == 0 ? "walker" : "box";
        node.model = 0;
        node.local.translation_m = {250.0f + 1.7f * static_cast<float>(i), 0.1f, -10.0f};
        if (i > 0) scene.roots.push_back(i);
        scene.nodes.push_back(node);
    }
    place.pavements.points = {{240, 0, -5}, {270, 0, -5}, {270, 0, -12}};
    place.pavements.links = {{0, 1, 1.0f, true}, {1, 2, 1.0f, true}};
    for (int i = 0; i < 8; ++i) {
        place.actors.push_back({assets::ActorKind::walker, 0, 0, 0.1f * static_cast<float>(i), 0.3f,
                                1.3f + 0.02f * static_cast<float>(i), false});
    }
    return place;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(FarFromHome, TheSameWalkGivesTheSameFramesAnywhere) {
    const assets::Place place = walkers_across_a_border();
    Frame expected, frame;
    for (const glm::ivec3 away :
         {glm::ivec3{391, 0, -391}, glm::ivec3{3907, 12, 3907}, glm::ivec3{-1000000, 0, 1000000}}) {
        ecs::World world;
        spawn(world, place, {away, {}}, 7);
        ecs::World fresh_home;
        spawn(fresh_home, place, {}, 7);
        for (int i = 0; i < 600; ++i) {
            step(world);
            step(fresh_home);
            if (i % 30 != 0) continue;
            Eye eye;
            eye.place = normalised({{0, 0, 0}, {245.0f + 0.02f * static_cast<float>(i), 1.7f, 0.0f}});
            build_frame(fresh_home, eye, 0.3f, expected);
            eye.place.cell += away;
            build_frame(world, eye, 0.3f, frame);
            ASSERT_GT(frame.instances.size(), 8u);
            ASSERT_TRUE(same_bytes(frame.instances, expected.instances)) << "step " << i;
            ASSERT_TRUE(same_bytes(frame.opaque, expected.opaque));
            ASSERT_TRUE(same_bytes(frame.casters.centre_x, expected.casters.centre_x));
            ASSERT_EQ(frame.view.view_from_world, expected.view.view_from_world);
        }
    }
}

TEST(FarFromHome, AMillimetreStaysAMillimetre) {
    const WorldPosition eye{{3907, 0, 0}, {255.5f, 0, 0}};
    for (int i = 0; i < 1000; ++i) {
        const WorldPosition thing = moved(eye, {0.001 * i, 0.0, 0.0});
        // A float's step just below 256 m is 1.5e-5 m.
        EXPECT_NEAR(offset_m(eye, thing).x, 0.001 * i, 3.1e-5);
    }
}

}  // namespace
}  // namespace rambla::systems
