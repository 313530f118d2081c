#include "systems/pipeline.h"

#include <array>
#include <chrono>
#include <cmath>

#include "systems/look/culling.h"
#include "systems/look/lights.h"
#include "systems/look/projection.h"
#include "systems/pack/queue.h"
#include "systems/position.h"
#include "systems/simulate/actors.h"
#include "systems/simulate/transform.h"

namespace rambla::systems {
namespace {

/// Resource: the systems with the memory that they keep from step to step.
struct SimulationSystems {
    ActorMotion actors;
    TransformPropagation transforms;
};

/// Resource: the same for looking and packing.
struct LookSystems {
    Culling culling;
    LightSearch lights;
    PackQueues queues;
    std::uint64_t frames = 0;
};

template <class R>
R& ensure(ecs::World& world) {
    if (!world.has_resource<R>()) world.set_resource(R{});
    return world.resource<R>();
}

template <class System>
void timed(SystemTiming& timing, const System& system) {
    const auto start = std::chrono::steady_clock::now();
    system();
    timing.ms = std::chrono::duration<double, std::milli>{std::chrono::steady_clock::now() - start}.count();
}

FrameView view_of(const Eye& eye, const WorldPosition& place) {
    const glm::uvec2 size = glm::max(eye.size_px, glm::uvec2{1});
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const bool orthographic = eye.kind == assets::CameraKind::orthographic;
    FrameView view;
    view.view_from_world = glm::mat4{glm::transpose(glm::mat3_cast(renormalised(eye.rotation)))};
    view.clip_from_view = orthographic ? reversed_orthographic(eye.half_height_m * aspect, eye.half_height_m,
                                                               eye.near_m, eye.far_m)
                                       : reversed_perspective(eye.vertical_fov_rad, aspect, eye.near_m);
    view.eye_cell = place.cell;
    view.eye_local_m = place.local_m;
    view.size_px = eye.size_px;
    view.orthographic = orthographic;
    return view;
}

bool sun_shines(const assets::Environment& environment) {
    const glm::vec3 e = environment.sun_illuminance;
    return e.x > 0.0f || e.y > 0.0f || e.z > 0.0f;
}

}  // namespace

void step(ecs::World& world) {
    auto& systems = ensure<SimulationSystems>(world);
    auto& timings = ensure<StepTimings>(world);
    timed(timings.actors, [&] { systems.actors(world); });
    timed(timings.transforms, [&] { systems.transforms(world); });
    ++ensure<Clock>(world).steps;
}

void build_frame(ecs::World& world, const Eye& eye, float interpolation, Frame& frame) {
    auto& systems = ensure<LookSystems>(world);
    auto& timings = ensure<StepTimings>(world);
    const auto& facts = ensure<MaterialFacts>(world);
    const std::uint64_t steps = ensure<Clock>(world).steps;
    const Observer observer{normalised(eye.place), interpolation};

    frame.number = systems.frames++;
    const double shown =
        steps == 0 ? 0.0 : static_cast<double>(steps - 1) + static_cast<double>(interpolation);
    frame.time_s = shown * k_step_s;
    frame.view = view_of(eye, observer.eye);
    frame.environment = ensure<Sunlight>(world).environment;

    const CullVolume camera = frustum_volume(frame.view.clip_from_view * frame.view.view_from_world);
    const std::array volumes{camera, shadow_caster_volume(camera, frame.environment.direction_to_sun)};
    const std::size_t views = sun_shines(frame.environment) ? 2 : 1;
    timed(timings.culling, [&] { systems.culling(world, observer, std::span{volumes}.first(views)); });
    timed(timings.lights, [&] {
        frame.counts.lights = systems.lights(world, observer, camera, frame.lights);
        frame.counts.visible_lights = static_cast<std::uint32_t>(frame.lights.size());
    });
    const glm::vec3 forward = -glm::transpose(glm::mat3{frame.view.view_from_world})[2];
    timed(timings.packing, [&] { systems.queues(systems.culling, observer, forward, facts, frame); });
    frame.counts.renderables = static_cast<std::uint32_t>(systems.culling.seen_by().size());
    frame.counts.broken_bounds = systems.culling.broken_bounds();
}

}  // namespace rambla::systems
