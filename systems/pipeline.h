#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <string_view>
#include <thread>
#include <vector>

#include "assets/scene.h"
#include "ecs/world.h"
#include "systems/components.h"
#include "systems/frame.h"

namespace rambla::systems {

/// Simulation step: 60 Hz, whatever the picture rate.
inline constexpr double k_step_s = 1.0 / 60.0;

/// The eye that a Frame is built for; looks along −Z of its rotation.
struct Eye {
    WorldPosition place;
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    assets::CameraKind kind = assets::CameraKind::perspective;
    float vertical_fov_rad = 1.0f;
    float half_height_m = 1.0f;  ///< orthographic
    float near_m = 0.05f;
    float far_m = 1000.0f;         ///< orthographic only
    glm::uvec2 size_px{960, 540};  ///< of what is shown
    std::uint32_t samples = 1;     ///< pixels drawn for one that is shown, across and down; ≥ 1
};

/// What a system took when it last ran.
struct SystemTiming {
    std::string_view name;
    double ms = 0.0;
    std::chrono::steady_clock::time_point begin{};
    std::thread::id thread{};  ///< that ran it
};

/// Resource: what the last step() and build_frame() cost. Measured, hence no part of the simulation's state.
struct StepTimings {
    std::vector<SystemTiming> simulation;
    std::vector<SystemTiming> looking;

    [[nodiscard]] std::vector<SystemTiming> all() const;
};

/// One run of the systems of a step or of a look.
struct SystemsRun {
    enum class Kind : std::uint8_t { step, look };
    Kind kind = Kind::step;
    std::uint64_t number = 0;  ///< of the step, from 1, or of the Frame, from 0
    std::chrono::steady_clock::time_point begin{};
    std::chrono::steady_clock::time_point end{};
    std::span<const SystemTiming> systems;  ///< valid during the call
};

/// Resource, for who wants to know of every run: step() and build_frame() call it at their end, in their
/// thread. It must not touch the world.
struct SystemsListener {
    std::function<void(const SystemsRun&)> heard;
};

/// How many threads have worked for a world's systems so far, those that called step() and build_frame()
/// included.
[[nodiscard]] std::size_t worker_threads(const ecs::World& world);

/// Advances the simulation by one fixed step: actors along their paths, gaits, transforms. Allocates nothing
/// in a steady state, and gives the same bits for any number of threads.
void step(ecs::World& world);

/// Looks at the world from `eye` and packs what the renderer needs. Reuses the Frame's memory: no allocation
/// in a steady state. `capture` and `hud` are the caller's and stay as they are.
/// @param interpolation  in [0, 1]: 0 shows the previous step, 1 the newest
void build_frame(ecs::World& world, const Eye& eye, float interpolation, Frame& frame);

/// 64-bit hash of all simulation columns: equal for equal seeds and inputs.
[[nodiscard]] std::uint64_t state_hash(const ecs::World& world);

}  // namespace rambla::systems
