#include "game/shown_bounds.h"

#include <gtest/gtest.h>

#include "systems/frame.h"

namespace rambla::game {
namespace {

TEST(ShownBounds, HoldWhatASourceHasBecomeWhateverItsBoundsSay) {
    ecs::World world;
    const systems::Pipeline haze{.alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend), .haze = true};
    const systems::LocalBounds outdated{{0, 0, 60}, glm::vec3{0.25f}};
    const ecs::Entity source = world.create(
        systems::WorldTransform{{0, 0, 0}, glm::mat3{1.0f}, {1, 2, 3}},
        systems::Renderable{assets::k_none, 0, systems::pack(haze)}, outdated,
        systems::ParticleSource{.start_radius_m = 0.5f, .end_radius_m = 0.5f}, systems::NoShadow{});
    assets::Bounds box = shown_bounds(world, {}, {});
    EXPECT_EQ(box.min, glm::vec3(0.5f, 1.5f, 2.5f));
    EXPECT_EQ(box.max, glm::vec3(1.5f, 2.5f, 3.5f));
    world.get_mut<systems::ParticleSource>(source).end_radius_m = 2.0f;
    box = shown_bounds(world, {}, {});
    EXPECT_EQ(box.min, glm::vec3(-1, 0, 1));
    EXPECT_EQ(box.max, glm::vec3(3, 4, 5));
    // Of anything else the stored ones are all that is known.
    world.create(systems::WorldTransform{}, systems::Renderable{0, 0, 0}, outdated);
    EXPECT_EQ(shown_bounds(world, {}, {}).max.z, 60.25f);
}

}  // namespace
}  // namespace rambla::game
