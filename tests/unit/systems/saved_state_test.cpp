#include "systems/saved_state.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "assets/generate/places.h"
#include "ecs/query.h"
#include "systems/pipeline.h"
#include "systems/reflection.h"
#include "systems/simulate/paths.h"
#include "systems/spawn.h"
#include "unit/systems/worlds.h"

namespace rambla::systems {
namespace {

const SavedPlace k_city{"city:blocks=2x2", 3, {{1, 0, -2}, {5.0f, 0.0f, 7.0f}}};

/// A world with a generated city in it, walked over for some steps.
std::unique_ptr<ecs::World> city_after(int steps) {
    auto world = std::make_unique<ecs::World>();
    static const assets::Place place = assets::generate_place(k_city.scene, k_city.seed);
    spawn(*world, place, k_city.origin, k_city.seed);
    for (int i = 0; i < steps; ++i)
        step(*world);
    return world;
}

TEST(SavedState, OfACityContinuesWithTheSameBits) {
    const auto uninterrupted = city_after(200);
    const auto saved = city_after(100);
    const std::vector<std::byte> bytes = save_state(*saved, k_city);
    const auto restored = load_state(bytes, *city_after(0), k_city);
    EXPECT_EQ(state_hash(*restored), state_hash(*saved));
    EXPECT_EQ(restored->resource<Clock>().steps, 100u);
    for (int i = 0; i < 100; ++i) {
        step(*saved);
        step(*restored);
    }
    EXPECT_EQ(state_hash(*saved), state_hash(*uninterrupted)) << "saving changes nothing";
    EXPECT_EQ(state_hash(*restored), state_hash(*uninterrupted));
    ecs::Query<const PathFollower> followers;
    EXPECT_GT(followers.count(*restored), 20u);
}

TEST(SavedState, OfAnotherPlaceIsRefused) {
    const auto world = city_after(0);
    const std::vector<std::byte> bytes = save_state(*world, k_city);
    SavedPlace other = k_city;
    other.seed = 4;
    try {
        (void)load_state(bytes, *world, other);
        FAIL();
    } catch (const ecs::SnapshotError& error) {
        EXPECT_NE(std::string{error.what()}.find("seed 3"), std::string::npos) << error.what();
        EXPECT_NE(std::string{error.what()}.find("seed 4"), std::string::npos) << error.what();
    }
    SavedPlace later = k_city;
    later.time = "22:00";
    EXPECT_THROW((void)load_state(bytes, *world, later), ecs::SnapshotError) << "other lamps burn";
    ecs::World empty;
    EXPECT_THROW((void)load_state(bytes, empty, k_city), ecs::SnapshotError) << "actors without paths";
    const auto is_refused = [&](const auto&... components) {
        const ecs::Entity odd = world->create(components...);
        EXPECT_THROW((void)load_state(save_state(*world, k_city), *world, k_city), ecs::SnapshotError);
        world->destroy(odd);
    };
    const auto alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend);
    const Renderable haze{assets::k_none, 0, pack({.alpha = alpha, .haze = true})};
    is_refused(ParticleSource{.count = assets::k_max_particles + 1}, haze);
    is_refused(ParticleSource{}, Renderable{0, 0, 0});
    is_refused(ParticleSource{}, Renderable{assets::k_none, 0, pack({.haze = true})});
    is_refused(haze);
    is_refused(Renderable{});
    is_refused(Renderable{0, 0, pack({.fading = true})});
    // It is what is odd about them that is refused.
    world->create(ParticleSource{.count = assets::k_max_particles}, haze);
    world->create(ParticleSource{},
                  Renderable{assets::k_none, 0, pack({.alpha = alpha, .unlit = true, .haze = true})});
    world->create(Renderable{0, 0, 0});
    EXPECT_NO_THROW((void)load_state(save_state(*world, k_city), *world, k_city));
}

TEST(Reflection, DescribesEveryComponentOfASpawnedCity) {
    const auto world = city_after(1);
    EXPECT_NO_THROW((void)save_state(*world, k_city)) << "a component without description is refused";
    const ecs::TypeRegistry registry = component_registry();
    const ecs::StructDescription& transform = *registry.component("local_transform")->description;
    const ecs::FieldDescription& translation = *transform.find("translation_m");
    EXPECT_EQ(translation.options.unit, "m");
    LocalTransform local;
    ecs::set_field(*translation.structure->find("y"), ecs::nested(translation, &local), 2.0);
    EXPECT_EQ(local.translation_m, (glm::vec3{0, 2, 0}));
    const ecs::FieldDescription& rotation = *transform.find("rotation");
    EXPECT_EQ(std::get<double>(ecs::get_field(*rotation.structure->find("w"), ecs::nested(rotation, &local))),
              1.0);
}

}  // namespace
}  // namespace rambla::systems
