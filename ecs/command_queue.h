#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "ecs/commands.h"

namespace rambla::ecs {

/// The place of a job's commands in the order of playback.
struct CommandKey {
    std::uint32_t system = 0;  ///< place of the system in the serial order of the schedule
    std::uint32_t chunk = 0;   ///< first chunk of the job's range, counted in the order of the query

    auto operator<=>(const CommandKey&) const = default;
};

/// The recordings of jobs that run at the same time. Each job records into one of its own, under the key that
/// says where its part of the work stands; apply() plays them in the order of the keys, so that the result
/// depends neither on the number of threads, nor on which of them was faster, nor on where a range of chunks
/// was split. Recordings are kept for the next time: a steady use does not allocate.
class CommandQueue {
public:
    CommandQueue();
    ~CommandQueue();
    CommandQueue(const CommandQueue&) = delete;
    CommandQueue& operator=(const CommandQueue&) = delete;

    /// An empty recording for one job, to be used by one thread at a time until apply() or clear(). May be
    /// called from any thread, but not during those two.
    [[nodiscard]] Commands& recording(CommandKey key);

    /// Plays everything as one recording and empties the queue; entities are told by Commands::created until
    /// the recording is handed out again. Throws Misuse when two recordings that hold commands have the same
    /// key: then nothing is changed and the queue stays. Otherwise as Commands::apply.
    Playback apply(World& world);
    /// Forgets what was recorded.
    void clear() noexcept;

    /// Whether no recording holds a command.
    [[nodiscard]] bool empty() const;

private:
    struct Recording {
        CommandKey key;
        std::unique_ptr<Commands> commands;
    };

    void order_by_key();
    void put_all_back() noexcept;

    std::mutex mutex_;
    std::vector<Recording> in_use_;
    std::vector<Commands*> playing_;
    std::vector<std::unique_ptr<Commands>> free_;  ///< the one put back last is handed out first
};

}  // namespace rambla::ecs
