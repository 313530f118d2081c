#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "ecs/row_mask.h"
#include "ecs/sparse_set.h"

namespace rambla::ecs {

/// The values of a sparse component (const C or C) for the rows of one chunk. What is taken from a view that
/// is not const counts as written, value by value.
template <class T>
class SparseView {
public:
    SparseView(const SparseSet* set, const Entity* entities, std::uint32_t version)
        : set_{set}, entities_{entities}, version_{version} {}

    /// Null for a row whose entity has no value.
    [[nodiscard]] T* find(std::size_t row) const {
        if (set_ == nullptr) return nullptr;
        const std::uint32_t place = set_->find_alive(entities_[row].index);
        return place == SparseSet::k_none ? nullptr : at(place);
    }
    /// The value of a row that has one, as all in the chunk's rows() do if the term is required.
    [[nodiscard]] T& operator[](std::size_t row) const { return *at(set_->find_alive(entities_[row].index)); }

private:
    T* at(std::uint32_t place) const {
        if constexpr (!std::is_const_v<T>) set_->stamp(place, version_);
        return reinterpret_cast<T*>(set_->value(place));
    }

    const SparseSet* set_;
    const Entity* entities_;
    std::uint32_t version_;
};

namespace detail {

/// Takes out the rows whose entity is not in the set.
inline void keep_those_in(const SparseSet* set, const Entity* entities, RowMask& rows) {
    if (set == nullptr || set->size() == 0) {
        rows = {};
        return;
    }
    rows.keep_if([&](std::size_t row) { return set->find_alive(entities[row].index) != SparseSet::k_none; });
}

/// Takes out the rows whose entity is in the set.
inline void keep_those_not_in(const SparseSet* set, const Entity* entities, RowMask& rows) {
    if (set == nullptr || set->size() == 0) return;
    rows.keep_if([&](std::size_t row) { return set->find_alive(entities[row].index) == SparseSet::k_none; });
}

}  // namespace detail
}  // namespace rambla::ecs
