#include "ecs/command_queue.h"

#include <algorithm>
#include <string>

#include "ecs/command_player.h"
#include "ecs/misuse.h"

namespace rambla::ecs {

CommandQueue::CommandQueue() = default;
CommandQueue::~CommandQueue() = default;

Commands& CommandQueue::recording(CommandKey key) {
    const std::lock_guard lock{mutex_};
    if (free_.empty()) {
        free_.reserve(in_use_.size() + 1);  // so that putting all back cannot fail
        free_.push_back(std::make_unique<Commands>());
    }
    in_use_.push_back({key, nullptr});
    in_use_.back().commands = std::move(free_.back());
    free_.pop_back();
    return *in_use_.back().commands;
}

Playback CommandQueue::apply(World& world) {
    detail::IterationMark::forbid(world, "CommandQueue::apply");
    order_by_key();
    playing_.clear();
    for (const Recording& recording : in_use_)
        playing_.push_back(recording.commands.get());
    try {
        const Playback playback = detail::CommandPlayer::of(world).play(playing_, "CommandQueue::apply");
        put_all_back();
        return playback;
    } catch (...) {
        clear();
        throw;
    }
}

void CommandQueue::clear() noexcept {
    for (const Recording& recording : in_use_)
        recording.commands->clear();
    put_all_back();
}

bool CommandQueue::empty() const {
    return std::ranges::all_of(in_use_,
                               [](const Recording& recording) { return recording.commands->empty(); });
}

void CommandQueue::order_by_key() {
    std::ranges::sort(in_use_, {}, &Recording::key);
    const Recording* before = nullptr;
    for (const Recording& recording : in_use_) {
        if (recording.commands->empty()) continue;
        if (before != nullptr && before->key == recording.key) {
            throw Misuse{"ecs: two recordings of system " + std::to_string(recording.key.system) +
                         " at chunk " + std::to_string(recording.key.chunk) + ": their order is undefined"};
        }
        before = &recording;
    }
}

void CommandQueue::put_all_back() noexcept {
    for (Recording& recording : in_use_)
        free_.push_back(std::move(recording.commands));
    in_use_.clear();
}

}  // namespace rambla::ecs
