#include "ecs/sparse_set.h"

#include <algorithm>
#include <cstring>

#include "ecs/version.h"

namespace rambla::ecs {
namespace {

/// Room for one more, so that the push_back that follows cannot fail.
template <class T>
void reserve_one(std::vector<T>& vector) {
    if (vector.size() == vector.capacity()) vector.reserve(std::max<std::size_t>(16, vector.size() * 2));
}

}  // namespace

SparseSet::SparseSet(BlockPool& pool, const ComponentInfo& info) : pool_{&pool}, info_{&info} {}

SparseSet::~SparseSet() {
    for (std::uint32_t place = 0; info_->destroy != nullptr && place < size(); ++place)
        info_->destroy(value(place), 1);
    for (std::uint32_t* page : pages_) {
        if (page != nullptr)
            pool_->give_back(reinterpret_cast<std::byte*>(page), k_page_places * sizeof(std::uint32_t));
    }
    for (std::byte* page : values_)
        pool_->give_back(page, value_page_bytes());
}

std::uint32_t SparseSet::insert(Entity entity, std::uint32_t version) {
    const std::size_t page = entity.index / k_page_places;
    if (page >= pages_.size()) pages_.resize(page + 1, nullptr);
    if (pages_[page] == nullptr) {
        auto* places = reinterpret_cast<std::uint32_t*>(pool_->take(k_page_places * sizeof(std::uint32_t)));
        std::fill_n(places, k_page_places, k_none);
        pages_[page] = places;
    }
    reserve_one(entities_);
    reserve_one(versions_);
    const std::uint32_t place = static_cast<std::uint32_t>(size());
    if (info_->size != 0 && place / k_page_values == values_.size()) {
        reserve_one(values_);
        values_.push_back(pool_->take(value_page_bytes()));
    }
    entities_.push_back(entity);
    versions_.push_back(version);
    pages_[page][entity.index % k_page_places] = place;
    membership_version_ = version;
    return place;
}

void SparseSet::erase(std::uint32_t place, std::uint32_t version) noexcept {
    const std::uint32_t last = static_cast<std::uint32_t>(size()) - 1;
    const auto place_of = [this](Entity entity) -> std::uint32_t& {
        return pages_[entity.index / k_page_places][entity.index % k_page_places];
    };
    if (info_->destroy != nullptr) info_->destroy(value(place), 1);
    place_of(entities_[place]) = k_none;
    if (place != last) {
        if (info_->relocate != nullptr) {
            info_->relocate(value(place), value(last), 1);
        } else if (info_->size != 0) {
            std::memcpy(value(place), value(last), info_->size);
        }
        place_of(entities_[last]) = place;
        entities_[place] = entities_[last];
        versions_[place] = versions_[last];
    }
    entities_.pop_back();
    versions_.pop_back();
    membership_version_ = version;
}

void SparseSet::age_versions(std::uint32_t oldest) noexcept {
    for (std::uint32_t& version : versions_)
        version = later(version, oldest);
    membership_version_ = later(membership_version_, oldest);
}

void SparseSet::compact() {
    while (values_.size() * k_page_values >= size() + k_page_values) {
        pool_->give_back(values_.back(), value_page_bytes());
        values_.pop_back();
    }
    for (std::uint32_t*& page : pages_) {
        if (page == nullptr ||
            std::any_of(page, page + k_page_places, [](std::uint32_t place) { return place != k_none; }))
            continue;
        pool_->give_back(reinterpret_cast<std::byte*>(page), k_page_places * sizeof(std::uint32_t));
        page = nullptr;
    }
    while (!pages_.empty() && pages_.back() == nullptr)
        pages_.pop_back();
    pages_.shrink_to_fit();
    entities_.shrink_to_fit();
    versions_.shrink_to_fit();
    values_.shrink_to_fit();
}

std::size_t SparseSet::memory_bytes() const {
    return sizeof(SparseSet) + pages_.capacity() * sizeof(std::uint32_t*) +
           entities_.capacity() * sizeof(Entity) + versions_.capacity() * sizeof(std::uint32_t) +
           values_.capacity() * sizeof(std::byte*);
}

SparseSet& SparseSets::get_or_make(ComponentId component, BlockPool& pool, const ComponentInfo& info) {
    if (SparseSet* known = find(component)) return *known;
    auto set = std::make_unique<SparseSet>(pool, info);
    if (by_component_.size() <= component) by_component_.resize(component + std::size_t{1}, nullptr);
    sets_.push_back(std::move(set));
    by_component_[component] = sets_.back().get();
    return *sets_.back();
}

std::size_t SparseSets::memory_bytes() const {
    std::size_t bytes =
        sets_.capacity() * sizeof(std::unique_ptr<SparseSet>) + by_component_.capacity() * sizeof(SparseSet*);
    for (const auto& set : sets_)
        bytes += set->memory_bytes();
    return bytes;
}

}  // namespace rambla::ecs
