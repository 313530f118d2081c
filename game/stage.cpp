#include "game/stage.h"

#include <utility>

#include "assets/generate/places.h"
#include "game/camera_path.h"
#include "systems/position.h"
#include "systems/spawn.h"

namespace rambla::game {
namespace {

void take(Stage& stage, systems::SpawnedScene spawned) {
    stage.nodes = std::move(spawned.nodes);
    stage.player = spawned.player;
}

}  // namespace

Stage make_stage(const std::string& scene, std::uint64_t seed, assets::TimeOfDay time,
                 const systems::WorldPosition& origin) {
    return make_stage(assets::generate_place(scene, seed, time), seed, origin);
}

Stage make_stage(assets::Place place, std::uint64_t seed, const systems::WorldPosition& origin) {
    Stage stage;
    stage.world = std::make_unique<ecs::World>();
    take(stage, systems::spawn(*stage.world, place, origin, seed));
    stage.scene = std::make_shared<const assets::Scene>(std::move(place.scene));
    stage.walk = std::move(place.walk);
    stage.walk_fov_rad = place.walk_fov_rad;
    stage.walk_near_m = place.walk_near_m;
    stage.exposure_ev = place.exposure_ev;
    stage.origin = origin;
    return stage;
}

Stage make_stage(assets::Scene scene, const assets::Environment& light,
                 const systems::WorldPosition& origin) {
    Stage stage;
    stage.world = std::make_unique<ecs::World>();
    stage.world->set_resource(systems::Sunlight{light});
    take(stage, systems::spawn(*stage.world, scene, origin));
    stage.scene = std::make_shared<const assets::Scene>(std::move(scene));
    stage.origin = origin;
    return stage;
}

systems::Eye walk_eye(const Stage& stage, float time_s) {
    const CameraPose pose = pose_at(stage.walk, time_s);
    systems::Eye eye;
    eye.place = systems::moved(stage.origin, glm::dvec3{pose.eye_m});
    eye.rotation = look_rotation(pose.eye_m, pose.target_m);
    eye.vertical_fov_rad = stage.walk_fov_rad;
    eye.near_m = stage.walk_near_m;
    return eye;
}

}  // namespace rambla::game
