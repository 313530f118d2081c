#pragma once

#include <cstddef>

namespace rambla::test {

/// Calls of operator new since the program began, all forms. Linking this file replaces operator new and
/// delete.
[[nodiscard]] std::size_t allocation_count();
/// The same, of the calling thread alone.
[[nodiscard]] std::size_t allocation_count_of_this_thread();

/// While it lives, one of this thread's allocations fails, as if memory were used up just then. One at a
/// time.
class FailingAllocation {
public:
    /// @param number  which one from now on, from 0
    explicit FailingAllocation(std::size_t number);
    ~FailingAllocation();
    FailingAllocation(const FailingAllocation&) = delete;
    FailingAllocation& operator=(const FailingAllocation&) = delete;

    /// Whether so many allocations came.
    [[nodiscard]] bool happened() const;
};

}  // namespace rambla::test
