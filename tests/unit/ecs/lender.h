#pragma once

#include <cstddef>
#include <limits>
#include <memory_resource>
#include <new>

namespace rambla::ecs::test {

/// Memory that counts what it has lent, and refuses what goes beyond a limit or one request of its choice.
class Lender : public std::pmr::memory_resource {
public:
    static constexpr std::size_t k_none = std::numeric_limits<std::size_t>::max();

    std::size_t limit = k_none;    ///< bytes lent at one time
    std::size_t refused = k_none;  ///< number of the request that is refused, from 0
    std::size_t lent = 0;
    std::size_t requests = 0;

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        if (requests++ == refused || bytes > limit - lent) throw std::bad_alloc{};
        lent += bytes;
        return std::pmr::new_delete_resource()->allocate(bytes, alignment);
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
        lent -= bytes;
        std::pmr::new_delete_resource()->deallocate(memory, bytes, alignment);
    }
    [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
        return this == &other;
    }
};

}  // namespace rambla::ecs::test
