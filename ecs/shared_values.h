#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "ecs/block_pool.h"
#include "ecs/component.h"

namespace rambla::ecs {

/// One of the distinct values of a shared component. Lives as long as the world: archetypes refer to it.
struct SharedValue {
    ComponentId component;
    std::uint32_t number;  ///< in the order of their birth
    const ComponentInfo* info;
    std::byte* bytes;

    template <class C>
    [[nodiscard]] const C& as() const {
        return *reinterpret_cast<const C*>(bytes);
    }
};

/// The distinct values of a world's shared components, in the order of their birth. Values are the same if
/// they compare equal or have the same bytes: a NaN is itself, −0 is 0, padding does not count where there is
/// an operator==.
class SharedValues {
public:
    /// Memory comes from `pool`, which outlives the values.
    explicit SharedValues(BlockPool& pool) : pool_{&pool} {}
    ~SharedValues();
    SharedValues(const SharedValues&) = delete;
    SharedValues& operator=(const SharedValues&) = delete;

    /// The one that is the same as `value`, a copy of it where there is none yet.
    const SharedValue& intern(ComponentId component, const ComponentInfo& info, const void* value);

    [[nodiscard]] std::span<const std::unique_ptr<SharedValue>> all() const { return values_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    BlockPool* pool_;
    std::vector<std::unique_ptr<SharedValue>> values_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> by_hash_;
};

}  // namespace rambla::ecs
