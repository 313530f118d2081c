#include <algorithm>
#include <string>

#include "ecs/checksum.h"
#include "ecs/iteration.h"
#include "ecs/misuse.h"
#include "ecs/row_codec.h"
#include "ecs/snapshot.h"
#include "ecs/snapshot_format.h"
#include "ecs/snapshot_parse.h"
#include "ecs/world_access.h"

namespace rambla::ecs {

using detail::WorldAccess;

SnapshotWriter::SnapshotWriter(const TypeRegistry& registry) : registry_{&registry} {
    for (const ResourceType& type : registry.resources())
        resources_.push_back(std::make_unique<detail::RowEncoder>(*type.description));
}

SnapshotWriter::~SnapshotWriter() = default;

std::span<const std::byte> SnapshotWriter::write(World& world) {
    return write_stream(world, nullptr);
}

std::span<const std::byte> SnapshotWriter::write_delta(World& world) {
    if (base_.world_serial != WorldAccess::serial(world)) {
        throw Misuse{"ecs: SnapshotWriter::write_delta: the last stream was not of this world"};
    }
    return write_stream(world, &base_);
}

std::span<const std::byte> SnapshotWriter::write_stream(World& world, const Base* base) {
    detail::IterationMark::forbid(world,
                                  base == nullptr ? "SnapshotWriter::write" : "SnapshotWriter::write_delta");
    out_.clear();
    std::memcpy(out_.extend(detail::k_magic.size()), detail::k_magic.data(), detail::k_magic.size());
    out_.number(detail::k_format);
    out_.number(static_cast<std::uint32_t>(base == nullptr ? detail::StreamKind::snapshot
                                                           : detail::StreamKind::delta));
    out_.number(std::uint64_t{0});
    out_.number(world.version());
    out_.number(base == nullptr ? std::uint32_t{0} : position_.version);
    out_.number(base == nullptr ? std::uint64_t{0} : position_.checksum);
    write_components(world);
    write_archetypes(world, base);
    write_rows(world, base);
    write_sparse_sets(world, base);
    write_slots(world, base);
    write_resources(world);
    out_.patch(detail::k_length_offset, std::uint64_t{out_.size() + detail::k_checksum_bytes});
    const std::uint64_t sum = checksum(out_.bytes());
    out_.number(sum);
    remember(world);
    position_ = {world.advance_version(), sum};
    return out_.bytes();
}

void SnapshotWriter::write_components(const World& world) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const std::size_t count = graph.component_count();
    types_.resize(count);
    encoders_.resize(count);
    out_.number(static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const ComponentInfo& info = graph.info(static_cast<ComponentId>(i));
        const ComponentType* type = registry_->component(info);
        if (type == nullptr) {
            base_.world_serial = 0;
            throw Misuse{"ecs: SnapshotWriter: component " + std::string{info.name} +
                         " is not registered: describe it with reflection<>, or add it as transient"};
        }
        if (types_[i] != type) {
            types_[i] = type;
            const bool has_values = !type->transient() && info.size != 0;
            encoders_[i] = has_values ? std::make_unique<detail::RowEncoder>(*type->description) : nullptr;
        }
        out_.text(type->name);
        out_.number(detail::flags_of(*type));
        if (type->transient()) {
            detail::write_schema({{}, 0, {}}, out_);
        } else {
            detail::write_schema(detail::schema_of(*type->description), out_);
        }
    }
}

void SnapshotWriter::write_archetypes(const World& world, const Base* base) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const std::size_t known = base == nullptr ? 1 : base->archetypes;
    out_.number(static_cast<std::uint32_t>(known));
    out_.number(static_cast<std::uint32_t>(graph.size() - known));
    for (std::size_t i = known; i < graph.size(); ++i) {
        const std::span<const ComponentId> signature = graph[i].signature();
        out_.number(static_cast<std::uint32_t>(signature.size()));
        for (ComponentId component : signature)
            out_.number(component);
        for (const SharedValue* value : graph[i].shared())
            encoders_[value->component]->encode(value->bytes, 1, out_);
    }
}

void SnapshotWriter::write_rows(const World& world, const Base* base) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const std::size_t count_at = out_.size();
    out_.number(std::uint32_t{0});
    std::uint32_t written = 0;
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const std::size_t before = out_.size();
        write_archetype_rows(graph[i], base);
        written += out_.size() != before ? 1 : 0;
    }
    out_.patch(count_at, written);
}

void SnapshotWriter::write_archetype_rows(const Archetype& archetype, const Base* base) {
    const std::uint32_t known_rows =
        base != nullptr && archetype.index() < base->archetypes ? base->rows[archetype.index()] : 0;
    const auto rows_version = [&](std::uint32_t chunk) {
        return WorldAccess::rows_version(archetype, chunk);
    };
    const auto column_version = [&](std::size_t column) {
        return [&archetype, column](std::uint32_t chunk) {
            return archetype.version(static_cast<ColumnIndex>(column), chunk);
        };
    };
    find_runs(archetype, base, rows_version);
    bool changed = !runs_.empty() || archetype.rows() != known_rows;
    for (std::size_t column = 0; column < archetype.columns().size() && !changed; ++column) {
        find_runs(archetype, base, column_version(column));
        changed = !runs_.empty();
    }
    if (!changed) return;
    out_.number(archetype.index());
    out_.number(archetype.rows());
    find_runs(archetype, base, rows_version);
    write_runs();
    for (const Run& run : runs_)
        write_entities({archetype.entities() + run.first, run.rows});
    for (std::size_t column = 0; column < archetype.columns().size(); ++column) {
        const Archetype::Column& values = archetype.columns()[column];
        const detail::RowEncoder* encoder = encoders_[values.component].get();
        if (encoder == nullptr) continue;
        find_runs(archetype, base, column_version(column));
        write_runs();
        for (const Run& run : runs_)
            encoder->encode(values.at(run.first), run.rows, out_);
    }
}

/// Rows of the chunks with a version after the base, neighbours together; all rows without a base.
template <class VersionOf>
void SnapshotWriter::find_runs(const Archetype& archetype, const Base* base, VersionOf version_of) {
    runs_.clear();
    const std::uint32_t rows = archetype.rows();
    if (base == nullptr) {
        if (rows != 0) runs_.push_back({0, rows});
        return;
    }
    for (std::uint32_t first = 0; first < rows; first += k_chunk_rows) {
        const std::uint32_t version = version_of(first / k_chunk_rows);
        if (static_cast<std::int32_t>(version - position_.version) <= 0) continue;
        const std::uint32_t count = std::min(rows - first, k_chunk_rows);
        if (!runs_.empty() && runs_.back().first + runs_.back().rows == first) {
            runs_.back().rows += count;
        } else {
            runs_.push_back({first, count});
        }
    }
}

void SnapshotWriter::write_runs() {
    out_.number(static_cast<std::uint32_t>(runs_.size()));
    for (const Run& run : runs_) {
        out_.number(run.first);
        out_.number(run.rows);
    }
}

/// Sets are for what few entities have, so one that changed is told whole.
void SnapshotWriter::write_sparse_sets(const World& world, const Base* base) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const std::size_t count_at = out_.size();
    out_.number(std::uint32_t{0});
    std::uint32_t written = 0;
    for (std::size_t i = 0; i < graph.component_count(); ++i) {
        const SparseSet* set = graph.sparse().find(static_cast<ComponentId>(i));
        if (set == nullptr || (base != nullptr && !WorldAccess::changed_since(*set, position_.version)))
            continue;
        ++written;
        const auto size = static_cast<std::uint32_t>(set->size());
        out_.number(static_cast<std::uint32_t>(i));
        out_.number(size);
        write_entities(set->entities());
        for (std::uint32_t place = 0; encoders_[i] != nullptr && place < size; ++place)
            encoders_[i]->encode(set->value(place), 1, out_);
    }
    out_.patch(count_at, written);
}

void SnapshotWriter::write_entities(std::span<const Entity> entities) {
    if (entities.empty()) return;
    detail::copy_little_endian(out_.extend(entities.size_bytes()),
                               reinterpret_cast<const std::byte*>(entities.data()), entities.size_bytes(),
                               sizeof(std::uint32_t));
}

void SnapshotWriter::write_slots(const World& world, const Base* base) {
    const EntityTable& table = WorldAccess::entities(world);
    const std::uint32_t slots = WorldAccess::slots(table);
    free_.clear();
    for (std::uint32_t slot = WorldAccess::first_free(table); slot != WorldAccess::k_no_slot;
         slot = WorldAccess::record(table, slot).row)
        free_.push_back(slot);
    std::reverse(free_.begin(), free_.end());
    find_retired(table);
    out_.number(slots);

    std::size_t kept = 0;
    if (base != nullptr) {
        const auto still = [&](std::uint32_t slot) {
            return WorldAccess::record(table, slot).generation;
        };
        const std::size_t both = std::min(free_.size(), base->free.size());
        while (kept < both && free_[kept] == base->free[kept].index &&
               still(free_[kept]) == base->free[kept].generation)
            ++kept;
    }
    out_.number(static_cast<std::uint32_t>(kept));
    out_.number(static_cast<std::uint32_t>(free_.size() - kept));
    for (std::size_t i = kept; i < free_.size(); ++i) {
        out_.number(free_[i]);
        out_.number(WorldAccess::record(table, free_[i]).generation);
    }

    const std::size_t known = base == nullptr ? 0 : base->retired.size();
    out_.number(static_cast<std::uint32_t>(retired_.size() - known));
    for (std::uint32_t slot : retired_) {
        if (known == 0 || !std::binary_search(base->retired.begin(), base->retired.end(), slot))
            out_.number(slot);
    }
}

/// Slots that are neither alive nor free, because their generations are used up.
void SnapshotWriter::find_retired(const EntityTable& table) {
    retired_.clear();
    const std::uint32_t slots = WorldAccess::slots(table);
    if (WorldAccess::retired(table) == 0) return;
    std::vector<bool> free(slots);
    for (std::uint32_t slot : free_)
        free[slot] = true;
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
        if (!free[slot] && WorldAccess::record(table, slot).archetype == k_no_archetype)
            retired_.push_back(slot);
    }
}

void SnapshotWriter::write_resources(const World& world) {
    const std::vector<ResourceType>& types = registry_->resources();
    out_.number(static_cast<std::uint32_t>(types.size()));
    for (std::size_t i = 0; i < types.size(); ++i) {
        out_.text(types[i].description->name);
        detail::write_schema(detail::schema_of(*types[i].description), out_);
        const void* value = types[i].find(WorldAccess::resources(world));
        out_.number(static_cast<std::uint8_t>(value == nullptr ? 0 : 1));
        if (value != nullptr) resources_[i]->encode(static_cast<const std::byte*>(value), 1, out_);
    }
}

void SnapshotWriter::remember(const World& world) {
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    const EntityTable& table = WorldAccess::entities(world);
    base_.world_serial = WorldAccess::serial(world);
    base_.archetypes = graph.size();
    base_.rows.clear();
    for (std::size_t i = 0; i < graph.size(); ++i)
        base_.rows.push_back(graph[i].rows());
    base_.free.clear();
    for (std::uint32_t slot : free_)
        base_.free.push_back({slot, WorldAccess::record(table, slot).generation});
    base_.retired = retired_;
}

}  // namespace rambla::ecs
