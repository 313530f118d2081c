#include "ecs/archetype_graph.h"

#include <algorithm>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

/// Numbers from here on mean something else (k_no_component, k_tag_column).
constexpr std::size_t k_max_components = 0xfffd;

/// Below 2³², so that the row after the last chunk still has a number.
constexpr std::uint32_t k_highest_max_rows = 1u << 31u;

constexpr std::uint32_t usable_max_rows(std::uint32_t rows) {
    const std::uint32_t bounded = std::clamp(rows, 1u, k_highest_max_rows);
    return (bounded + k_row_padding - 1) / k_row_padding * k_row_padding;
}

/// FNV-1a over the numbers of components and values.
std::uint64_t hash_of(std::span<const ComponentId> signature, std::span<const SharedValue* const> shared) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (ComponentId component : signature)
        hash = (hash ^ component) * 0x100000001b3u;
    for (const SharedValue* value : shared)
        hash = (hash ^ value->number) * 0x100000001b3u;
    return hash;
}

/// Makes room for one more, so that the push_back that follows cannot fail.
template <class T>
void reserve_one(std::vector<T>& vector) {
    if (vector.size() == vector.capacity()) vector.reserve(std::max<std::size_t>(8, vector.size() * 2));
}

}  // namespace

ArchetypeGraph::ArchetypeGraph(std::uint32_t max_rows, bool reserves, std::uint32_t oldest_version,
                               std::pmr::memory_resource* memory)
    : storage_{memory} {
    storage_.oldest_version = oldest_version;
    storage_.max_rows = usable_max_rows(max_rows);
    storage_.reserves = reserves && ReservedMemory::grows_in_place;
    make({}, {});
}

ComponentId ArchetypeGraph::component(const ComponentInfo& info) {
    const ComponentId known = find_component(info.type_index);
    if (known != k_no_component) return known;
    if (info.companion != nullptr) {
        component(*info.companion);
        has_companions_ = true;
    }
    has_shared_ = has_shared_ || info.storage == Storage::shared;
    if (infos_.size() == k_max_components) detail::throw_full("kinds of components", k_max_components);
    if (ids_.size() <= info.type_index) ids_.resize(info.type_index + std::size_t{1}, k_no_component);
    infos_.push_back(&info);
    return ids_[info.type_index] = static_cast<ComponentId>(infos_.size() - 1);
}

Archetype& ArchetypeGraph::with_signature(std::span<ComponentId> signature,
                                          std::span<const SharedValue* const> shared) {
    std::sort(signature.begin(), signature.end());
    if (has_shared_) require_values(signature, shared);
    const std::span<const ComponentId> whole = has_companions_ ? with_companions(signature) : signature;
    Archetype* found = find(whole, shared);
    return found != nullptr ? *found : make(whole, shared);
}

void ArchetypeGraph::require_values(std::span<const ComponentId> signature,
                                    std::span<const SharedValue* const> shared) const {
    auto value = shared.begin();
    for (ComponentId component : signature) {
        if (infos_[component]->storage != Storage::shared) continue;
        if (value == shared.end() || (*value)->component != component)
            detail::throw_no_shared_value(infos_[component]->name);
        ++value;
    }
}

std::span<const ComponentId> ArchetypeGraph::with_companions(std::span<const ComponentId> signature) {
    completed_.clear();
    for (ComponentId component : signature) {
        const ComponentInfo& info = *infos_[component];
        if (info.is_companion) continue;
        completed_.push_back(component);
        if (info.companion != nullptr) completed_.push_back(find_component(info.companion->type_index));
    }
    std::sort(completed_.begin(), completed_.end());
    return completed_;
}

Archetype& ArchetypeGraph::toggled(Archetype& from, ComponentId component) {
    const auto edge_of = [](std::vector<Edge>& edges, ComponentId wanted) {
        return std::lower_bound(edges.begin(), edges.end(), wanted,
                                [](const Edge& edge, ComponentId id) { return edge.component < id; });
    };
    std::vector<Edge>& edges = edges_[from.index()];
    const auto known = edge_of(edges, component);
    if (known != edges.end() && known->component == component) return *archetypes_[known->archetype];

    neighbour_.assign(from.signature().begin(), from.signature().end());
    neighbours_values_.assign(from.shared().begin(), from.shared().end());
    if (from.has(component)) {
        std::erase(neighbour_, component);
        std::erase_if(neighbours_values_,
                      [&](const SharedValue* value) { return value->component == component; });
    } else {
        neighbour_.push_back(component);
    }
    Archetype& to = with_signature(neighbour_, neighbours_values_);
    const auto link = [&](const Archetype& a, const Archetype& b) {
        std::vector<Edge>& edges_of_a = edges_[a.index()];
        const auto place = edge_of(edges_of_a, component);
        const bool linked = place != edges_of_a.end() && place->component == component;
        if (!linked) edges_of_a.insert(place, {component, b.index()});
    };
    link(from, to);
    if (infos_[component]->storage != Storage::shared) link(to, from);  // the way back depends on the value
    return to;
}

Archetype& ArchetypeGraph::sharing(Archetype& from, const SharedValue& value) {
    neighbour_.assign(from.signature().begin(), from.signature().end());
    if (!from.has(value.component)) neighbour_.push_back(value.component);
    neighbours_values_.assign(from.shared().begin(), from.shared().end());
    std::erase_if(neighbours_values_,
                  [&](const SharedValue* other) { return other->component == value.component; });
    const auto place = std::ranges::find_if(
        neighbours_values_, [&](const SharedValue* other) { return other->component > value.component; });
    neighbours_values_.insert(place, &value);
    return with_signature(neighbour_, neighbours_values_);
}

void ArchetypeGraph::age_versions(std::uint32_t oldest) noexcept {
    storage_.oldest_version = oldest;
    for (const auto& archetype : archetypes_)
        archetype->age_versions(oldest);
    for (const auto& set : sparse_.all())
        set->age_versions(oldest);
}

void ArchetypeGraph::compact() {
    for (const auto& archetype : archetypes_)
        archetype->compact();
    for (const auto& set : sparse_.all())
        set->compact();
    storage_.pool.compact();
}

std::size_t ArchetypeGraph::memory_bytes() const {
    constexpr std::size_t k_map_node_bytes =
        sizeof(std::pair<std::uint64_t, std::uint32_t>) + 2 * sizeof(void*);
    std::size_t bytes =
        storage_.pool.memory_bytes() + sparse_.memory_bytes() + shared_.memory_bytes() +
        infos_.capacity() * sizeof(const ComponentInfo*) + ids_.capacity() * sizeof(ComponentId) +
        archetypes_.capacity() * sizeof(std::unique_ptr<Archetype>) +
        edges_.capacity() * sizeof(std::vector<Edge>) + by_signature_.bucket_count() * sizeof(void*) +
        by_signature_.size() * k_map_node_bytes;
    for (const auto& archetype : archetypes_)
        bytes += archetype->memory_bytes();
    for (const auto& edges : edges_)
        bytes += edges.capacity() * sizeof(Edge);
    return bytes;
}

Archetype* ArchetypeGraph::find(std::span<const ComponentId> signature,
                                std::span<const SharedValue* const> shared) const {
    const auto [first, last] = by_signature_.equal_range(hash_of(signature, shared));
    for (auto entry = first; entry != last; ++entry) {
        Archetype& archetype = *archetypes_[entry->second];
        if (std::ranges::equal(archetype.signature(), signature) &&
            std::ranges::equal(archetype.shared(), shared))
            return &archetype;
    }
    return nullptr;
}

Archetype& ArchetypeGraph::make(std::span<const ComponentId> signature,
                                std::span<const SharedValue* const> shared) {
    const auto index = static_cast<std::uint32_t>(archetypes_.size());
    std::vector<const ComponentInfo*> infos;
    for (ComponentId component : signature)
        infos.push_back(infos_[component]);
    auto archetype = std::make_unique<Archetype>(
        storage_, index, std::vector<ComponentId>{signature.begin(), signature.end()}, infos,
        std::vector<const SharedValue*>{shared.begin(), shared.end()});
    reserve_one(archetypes_);
    reserve_one(edges_);
    by_signature_.emplace(hash_of(signature, shared), index);
    edges_.emplace_back();
    archetypes_.push_back(std::move(archetype));
    return *archetypes_.back();
}

}  // namespace rambla::ecs
