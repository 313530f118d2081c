#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/component.h"
#include "ecs/misuse.h"

namespace rambla::ecs {

/// Values of which a world has one each, by type. Ended in the reverse order of their coming.
class Resources {
public:
    Resources() = default;
    Resources(const Resources&) = delete;
    Resources& operator=(const Resources&) = delete;
    ~Resources() {
        while (!entries_.empty()) {
            entries_.back().destroy(entries_.back().value);
            entries_.pop_back();
        }
    }

    /// Sets or replaces; where R can be assigned, references to the old value show the new one.
    template <class R>
    R& set(R value) {
        if (R* old = find<R>()) {
            if constexpr (std::is_move_assignable_v<R>) {
                *old = std::move(value);
                return *old;
            } else {
                R* fresh = new R(std::move(value));
                delete std::exchange(old, fresh);
                entries_[slots_[type_index<R>()] - 1].value = fresh;
                return *fresh;
            }
        }
        const std::uint32_t type = type_index<R>();
        if (slots_.size() <= type) slots_.resize(type + 1);
        entries_.reserve(entries_.size() + 1);
        R* fresh = new R(std::move(value));
        entries_.push_back(
            {fresh, [](void* resource) noexcept { delete static_cast<R*>(resource); }, sizeof(R)});
        slots_[type] = static_cast<std::uint32_t>(entries_.size());
        return *fresh;
    }

    /// Null if there is none.
    template <class R>
    [[nodiscard]] R* find() const {
        const std::uint32_t type = type_index<R>();
        if (type >= slots_.size() || slots_[type] == 0) return nullptr;
        return static_cast<R*>(entries_[slots_[type] - 1].value);
    }

    /// Throws Misuse if there is none.
    template <class R>
    [[nodiscard]] R& get() const {
        if (R* found = find<R>()) return *found;
        detail::throw_no_resource(type_name<R>());
    }

    /// The values themselves and the tables; not what values own elsewhere.
    [[nodiscard]] std::size_t memory_bytes() const {
        std::size_t bytes = slots_.capacity() * sizeof(std::uint32_t) + entries_.capacity() * sizeof(Entry);
        for (const Entry& entry : entries_)
            bytes += entry.size;
        return bytes;
    }

private:
    struct Entry {
        void* value;
        void (*destroy)(void*) noexcept;
        std::size_t size;
    };

    std::vector<Entry> entries_;        ///< in the order of their coming
    std::vector<std::uint32_t> slots_;  ///< by type index: 1 + place in entries_, 0 for none
};

}  // namespace rambla::ecs
