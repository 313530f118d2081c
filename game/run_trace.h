#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>
#include <vector>

#include "ecs/world.h"
#include "game/trace_file.h"
#include "systems/feedback.h"
#include "systems/pipeline.h"

namespace rambla::game {

/// What a run did and when, as --trace writes it: the systems on the threads that ran them, the passes on the
/// render thread and on the GPU, all on one clock that begins with this.
///
/// Categories: `system` and, around those of one run, `step` or `look`; `pass,cpu` and `pass,gpu`, and around
/// those of one frame `frame,cpu` and `frame,gpu`. Used by the main thread alone.
class RunTrace {
public:
    /// @throws assets::Error  if the file cannot be made
    explicit RunTrace(const std::filesystem::path& file);
    RunTrace(const RunTrace&) = delete;
    RunTrace& operator=(const RunTrace&) = delete;

    /// Adds the systems of every step and look of a world from now on. This must outlive the world's use.
    void listen_to(ecs::World& world);
    /// Adds a drawn frame; they come in their order.
    void add(const systems::Feedback& frame);
    /// Ends the file. @throws assets::Error  if anything could not be written
    void finish();

private:
    void add(const systems::SystemsRun& run);
    void add_gpu(const systems::Feedback& frame);
    [[nodiscard]] std::uint32_t track_of(std::thread::id thread);

    TraceFile file_;
    std::map<std::thread::id, std::uint32_t> tracks_;
    std::vector<systems::SystemTiming> sorted_;
    std::chrono::steady_clock::time_point gpu_end_{};  ///< of what was added last
};

/// The trace that --trace asks for; null if it is not given. @throws assets::Error
[[nodiscard]] std::unique_ptr<RunTrace> begin_trace(const std::filesystem::path& file);

}  // namespace rambla::game
