#pragma once

#include <string_view>
#include <utility>

#include "ecs/misuse.h"

namespace rambla::ecs {

class World;

namespace detail {

/// Marks a world as being walked over by this thread, through one query, for as long as it lives. A list per
/// thread instead of a counter in the world, so that threads that only read share nothing that is written.
class IterationMark {
public:
    /// @param query  anything that identifies it
    IterationMark(const World& world, const void* query) noexcept
        : world_{&world}, query_{query}, outer_{std::exchange(innermost_, this)} {}
    ~IterationMark() {
        IterationMark** link = &innermost_;
        while (*link != this)
            link = &(*link)->outer_;
        *link = outer_;
    }
    IterationMark(const IterationMark&) = delete;
    IterationMark& operator=(const IterationMark&) = delete;

    /// Throws Misuse if this thread walks over `world`.
    static void forbid(const World& world, std::string_view operation) {
        for (const IterationMark* mark = innermost_; mark != nullptr; mark = mark->outer_) {
            if (mark->world_ == &world) throw_iterating(operation);
        }
    }
    /// Throws Misuse if this thread walks over any world through `query`.
    static void forbid_through(const void* query, std::string_view operation) {
        for (const IterationMark* mark = innermost_; mark != nullptr; mark = mark->outer_) {
            if (mark->query_ == query) throw_iterating(operation);
        }
    }

private:
    inline static constinit thread_local IterationMark* innermost_ = nullptr;

    const World* world_;
    const void* query_;
    IterationMark* outer_;
};

}  // namespace detail
}  // namespace rambla::ecs
