#include "systems/pipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "systems/look/culling.h"
#include "systems/look/projection.h"
#include "systems/look/texture_uses.h"
#include "systems/looking.h"
#include "systems/position.h"
#include "systems/simulate/clip_library.h"
#include "systems/simulate/deformation.h"
#include "systems/simulate/paths.h"
#include "systems/simulate/transform.h"
#include "systems/simulation.h"

namespace rambla::systems {
namespace {

template <class R>
R& ensure(ecs::World& world) {
    if (!world.has_resource<R>()) world.set_resource(R{});
    return world.resource<R>();
}

void note(std::vector<SystemTiming>& timings, std::span<const ecs::SystemTime> times) {
    timings.resize(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
        timings[i] = {times[i].name, static_cast<double>(times[i].ns) * 1.0e-6, times[i].begin,
                      times[i].thread};
}

/// Runs a schedule, notes what its systems took and tells who listens.
void run(ecs::World& world, ecs::Schedule& schedule, std::vector<SystemTiming> StepTimings::*timings,
         SystemsRun::Kind kind, std::uint64_t number) {
    const auto begin = std::chrono::steady_clock::now();
    schedule.run(world);
    std::vector<SystemTiming>& noted = ensure<StepTimings>(world).*timings;
    note(noted, schedule.times());
    if (!world.has_resource<SystemsListener>()) return;
    world.resource<SystemsListener>().heard({.kind = kind,
                                             .number = number,
                                             .begin = begin,
                                             .end = std::chrono::steady_clock::now(),
                                             .systems = noted});
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
    view.size_px = eye.size_px * eye.samples;
    view.samples = eye.samples;
    view.orthographic = orthographic;
    return view;
}

bool sun_shines(const assets::Environment& environment) {
    const glm::vec3 e = environment.sun_illuminance;
    return e.x > 0.0f || e.y > 0.0f || e.z > 0.0f;
}

}  // namespace

std::vector<SystemTiming> StepTimings::all() const {
    std::vector<SystemTiming> both = simulation;
    both.insert(both.end(), looking.begin(), looking.end());
    return both;
}

std::size_t worker_threads(const ecs::World& world) {
    std::size_t threads = 0;
    if (world.has_resource<Simulation>())
        threads = std::max(threads, world.resource<Simulation>().schedule->worker_threads());
    if (world.has_resource<Looking>())
        threads = std::max(threads, world.resource<Looking>().schedule->worker_threads());
    return threads;
}

void step(ecs::World& world) {
    ensure<Paths>(world);
    const std::uint64_t number = ensure<Clock>(world).steps + 1;
    ensure<ClipLibrary>(world);
    ensure<Deformations>(world);
    if (!world.has_resource<Simulation>()) world.set_resource(make_simulation());
    run(world, *world.resource<Simulation>().schedule, &StepTimings::simulation, SystemsRun::Kind::step,
        number);
}

void build_frame(ecs::World& world, const Eye& eye, float interpolation, Frame& frame) {
    if (!world.has_resource<Looking>()) world.set_resource(make_looking());
    ensure<Culling>(world);
    ensure<MaterialFacts>(world);
    ensure<TextureUses>(world);
    ensure<ClipLibrary>(world);
    ensure<Deformations>(world);
    auto& looking = world.resource<Looking>();
    auto& look = ensure<Look>(world);
    const std::uint64_t steps = ensure<Clock>(world).steps;
    look.observer = {normalised(eye.place), interpolation};

    frame.number = looking.frames++;
    const double shown =
        steps == 0 ? 0.0 : static_cast<double>(steps - 1) + static_cast<double>(interpolation);
    frame.time_s = shown * k_step_s;
    frame.view = view_of(eye, look.observer.eye);
    frame.environment = ensure<Sunlight>(world).environment;

    look.camera = frustum_volume(frame.view.clip_from_view * frame.view.view_from_world);
    look.casters = shadow_caster_volume(look.camera, frame.environment.direction_to_sun);
    look.shadows = sun_shines(frame.environment);
    look.forward = -glm::transpose(glm::mat3{frame.view.view_from_world})[2];
    ensure<FrameUnderWork>(world).frame = &frame;
    run(world, *looking.schedule, &StepTimings::looking, SystemsRun::Kind::look, frame.number);
}

}  // namespace rambla::systems
