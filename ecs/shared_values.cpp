#include "ecs/shared_values.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace rambla::ecs {

SharedValues::~SharedValues() {
    for (const auto& value : values_)
        pool_->give_back(value->bytes, value->info->size);
}

const SharedValue& SharedValues::intern(ComponentId component, const ComponentInfo& info, const void* value) {
    const std::uint64_t hash = info.hash(value) ^ (std::uint64_t{component} << 48u);
    const auto [first, last] = by_hash_.equal_range(hash);
    for (auto entry = first; entry != last; ++entry) {
        const SharedValue& known = *values_[entry->second];
        if (known.component == component && info.equal(known.bytes, value)) return known;
    }
    if (values_.size() == values_.capacity()) values_.reserve(std::max<std::size_t>(8, values_.size() * 2));
    const auto number = static_cast<std::uint32_t>(values_.size());
    auto fresh = std::make_unique<SharedValue>(SharedValue{component, number, &info, nullptr});
    const auto entry = by_hash_.emplace(hash, number);
    try {
        fresh->bytes = pool_->take(info.size);
    } catch (...) {
        by_hash_.erase(entry);
        throw;
    }
    std::memcpy(fresh->bytes, value, info.size);
    values_.push_back(std::move(fresh));
    return *values_.back();
}

std::size_t SharedValues::memory_bytes() const {
    constexpr std::size_t k_map_node_bytes =
        sizeof(std::pair<std::uint64_t, std::uint32_t>) + 2 * sizeof(void*);
    return values_.capacity() * sizeof(std::unique_ptr<SharedValue>) + values_.size() * sizeof(SharedValue) +
           by_hash_.bucket_count() * sizeof(void*) + by_hash_.size() * k_map_node_bytes;
}

}  // namespace rambla::ecs
