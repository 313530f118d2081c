#include "render/render_thread.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "assets/assert.h"
#include "render/renderer.h"

namespace rambla::render {

namespace {

/// How often an otherwise idle render thread asks whether the GPU has finished a frame.
constexpr std::chrono::milliseconds k_poll{1};

/// Work in the order in which it was handed over: a scene, or else the frame in a slot.
struct Command {
    std::shared_ptr<const assets::Scene> scene;
    std::shared_ptr<const assets::ProcessedScene> processed;
    std::shared_ptr<assets::LevelSource> source;
    std::vector<std::uint32_t> fading;
    std::size_t slot = 0;
};

}  // namespace

struct RenderThread::State {
    RenderThreadOptions options;

    std::array<FrameInput, 2> slots;  ///< each belongs to one thread at a time, as `slot_busy` says
    std::size_t filling = 0;

    std::mutex mutex;
    std::condition_variable changed;
    // Guarded by the mutex:
    std::array<bool, 2> slot_busy{};  ///< submitted and not yet drawn
    std::optional<DeviceInfo> device;
    std::vector<Command> queue;
    std::vector<std::weak_ptr<assets::LevelSource>> sources;  ///< of all scenes that may still be drawn
    std::vector<FrameOutput> outputs;
    bool working = false;    ///< a command is being carried out, or frames are in flight
    bool finishing = false;  ///< somebody waits for everything
    bool stop = false;
    std::exception_ptr failure;

    std::thread thread;  ///< last: runs on all of the above

    void run();
    void serve(Renderer& renderer);
    void rethrow() const {
        if (failure) std::rethrow_exception(failure);
    }
};

void RenderThread::State::run() {
    try {
        Renderer renderer{options, [this](const DeviceInfo& info) {
                              const std::scoped_lock lock{mutex};
                              device = info;
                              changed.notify_all();
                          }};
        serve(renderer);
    } catch (...) {
        const std::scoped_lock lock{mutex};
        failure = std::current_exception();
    }
    changed.notify_all();
}

void RenderThread::State::serve(Renderer& renderer) {
    std::vector<FrameOutput> finished;
    std::unique_lock lock{mutex};
    for (;;) {
        const auto called = [this] {
            return stop || !queue.empty() || finishing;
        };
        if (renderer.frames_in_flight()) {
            changed.wait_for(lock, k_poll, called);
        } else {
            working = false;
            changed.notify_all();
            changed.wait(lock, [this] { return stop || !queue.empty(); });
        }
        if (stop) return;
        working = true;
        const bool has_command = !queue.empty();
        Command command;
        if (has_command) {
            command = std::move(queue.front());
            queue.erase(queue.begin());
        }
        const bool drain = finishing && !has_command;
        lock.unlock();
        if (command.scene) {
            renderer.upload(*command.scene, *command.processed, std::move(command.source), command.fading);
            command = {};
        } else if (has_command) {
            renderer.draw(slots[command.slot]);
            lock.lock();
            slot_busy[command.slot] = false;
            lock.unlock();
            changed.notify_all();
        }
        renderer.take_finished(finished, drain);
        lock.lock();
        for (FrameOutput& output : finished)
            outputs.push_back(std::move(output));
        finished.clear();
    }
}

RenderThread::RenderThread(RenderThreadOptions options) : state_{std::make_unique<State>()} {
    state_->options = std::move(options);
    state_->thread = std::thread{[state = state_.get()] {
        state->run();
    }};
}

RenderThread::~RenderThread() {
    {
        const std::scoped_lock lock{state_->mutex};
        state_->stop = true;
        for (const std::weak_ptr<assets::LevelSource>& source : state_->sources) {
            if (const auto waited_for = source.lock()) waited_for->close();
        }
    }
    state_->changed.notify_all();
    state_->thread.join();
}

const DeviceInfo& RenderThread::device() {
    std::unique_lock lock{state_->mutex};
    state_->changed.wait(lock, [this] { return state_->failure || state_->device; });
    state_->rethrow();
    return *state_->device;
}

void RenderThread::upload(std::shared_ptr<const assets::Scene> scene,
                          std::shared_ptr<const assets::ProcessedScene> processed,
                          std::shared_ptr<assets::LevelSource> source, std::vector<std::uint32_t> fading) {
    RAMBLA_ASSERT(scene != nullptr && processed != nullptr, "there is a scene to upload");
    {
        const std::scoped_lock lock{state_->mutex};
        state_->rethrow();
        std::erase_if(state_->sources, [](const auto& known) { return known.expired(); });
        if (source) state_->sources.push_back(source);
        state_->queue.push_back({.scene = std::move(scene),
                                 .processed = std::move(processed),
                                 .source = std::move(source),
                                 .fading = std::move(fading)});
    }
    state_->changed.notify_all();
}

FrameInput& RenderThread::begin() {
    std::unique_lock lock{state_->mutex};
    state_->changed.wait(lock, [this] { return state_->failure || !state_->slot_busy[state_->filling]; });
    state_->rethrow();
    return state_->slots[state_->filling];
}

void RenderThread::submit() {
    {
        const std::scoped_lock lock{state_->mutex};
        state_->rethrow();
        RAMBLA_ASSERT(!state_->slot_busy[state_->filling], "begin() came before submit()");
        state_->slot_busy[state_->filling] = true;
        state_->queue.push_back({.scene = nullptr,
                                 .processed = nullptr,
                                 .source = nullptr,
                                 .fading = {},
                                 .slot = state_->filling});
        state_->filling = 1 - state_->filling;
    }
    state_->changed.notify_all();
}

std::vector<FrameOutput> RenderThread::collect() {
    const std::scoped_lock lock{state_->mutex};
    state_->rethrow();
    return std::exchange(state_->outputs, {});
}

void RenderThread::finish() {
    std::unique_lock lock{state_->mutex};
    state_->finishing = true;
    state_->changed.notify_all();
    state_->changed.wait(lock,
                         [this] { return state_->failure || (state_->queue.empty() && !state_->working); });
    state_->finishing = false;
    state_->rethrow();
}

}  // namespace rambla::render
