#include "game/picture_writer.h"

#include <spdlog/spdlog.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <utility>

#include "assets/export/image.h"

namespace rambla::game {
namespace {

/// Queued pictures hold memory (8 MiB each at full HD); encoders that lag further behind would only pile them
/// up.
constexpr int k_most_queued = 8;

}  // namespace

/// An arena of its own: threads that wait for the simulation's tasks never pick up an encoding instead.
struct PictureWriter::State {
    tbb::task_arena arena;
    tbb::task_group group;
    std::atomic<int> queued{0};

    void wait() {
        arena.execute([this] { group.wait(); });
    }
};

PictureWriter::PictureWriter() : state_{std::make_unique<State>()} {}

PictureWriter::~PictureWriter() {
    try {
        finish();
    } catch (const std::exception& error) {
        spdlog::error("{}", error.what());
    }
}

void PictureWriter::write(std::filesystem::path file, assets::Image image) {
    // std::function asks for copyable work, and a picture must not be copied.
    auto picture = std::make_shared<const assets::Image>(std::move(image));
    run([file = std::move(file), picture = std::move(picture)] { assets::write_image(file, *picture); });
}

void PictureWriter::run(std::function<void()> work) {
    if (state_->queued.load() >= k_most_queued) state_->wait();
    ++state_->queued;
    state_->arena.execute([this, &work] {
        state_->group.run([state = state_.get(), work = std::move(work)] {
            struct Done {
                std::atomic<int>& queued;
                ~Done() { --queued; }
            } done{state->queued};
            work();
        });
    });
}

void PictureWriter::finish() {
    state_->wait();
}

}  // namespace rambla::game
