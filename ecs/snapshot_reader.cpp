#include <algorithm>
#include <memory>
#include <utility>

#include "ecs/iteration.h"
#include "ecs/misuse.h"
#include "ecs/snapshot.h"
#include "ecs/snapshot_parse.h"
#include "ecs/staged_rows.h"
#include "ecs/world_access.h"

namespace rambla::ecs {
namespace {

using detail::ParsedStream;
using detail::StagedRows;
using detail::WorldAccess;

/// Brings a world to where a validated stream says. What can fail comes first.
class Applier {
public:
    Applier(World& world, const ParsedStream& parsed)
        : world_{world},
          graph_{WorldAccess::graph(world)},
          table_{WorldAccess::entities(world)},
          parsed_{parsed} {}

    void apply() {
        stage_values();
        stage_resources();
        make_archetypes();
        stage_sparse();
        reserve();
        for (Staged& staged : staged_resources_)
            staged.type->set(WorldAccess::resources(world_), staged.value.get());
        commit();
    }

private:
    struct StagedColumn {
        std::uint32_t component;
        std::uint32_t first;
        std::uint32_t rows;
        StagedRows values;
    };
    struct StagedSet {
        SparseSet* old;
        std::unique_ptr<SparseSet> fresh;
    };
    struct Staged {
        const ResourceType* type;
        ResourceType::Value value;
    };

    void stage_values() {
        staged_.resize(parsed_.rows.size());
        for (std::size_t i = 0; i < parsed_.rows.size(); ++i) {
            for (const ParsedStream::Column& column : parsed_.rows[i].columns)
                stage_column(column, staged_[i]);
            stage_transient(parsed_.rows[i], staged_[i]);
        }
    }

    void stage_column(const ParsedStream::Column& column, std::vector<StagedColumn>& staged) {
        const ParsedStream::Component& component = parsed_.components[column.component];
        if (component.type == nullptr) return;
        for (const ParsedStream::Run& run : column.runs) {
            if (component.decoder.raw()) {
                staged.push_back({column.component, run.first, run.rows,
                                  StagedRows{*component.type->info, run.rows, run.values.data()}});
                continue;
            }
            StagedRows values{*component.type, run.rows};
            component.decoder.decode(run.values, run.rows, values.objects());
            staged.push_back({column.component, run.first, run.rows, std::move(values)});
        }
    }

    /// Rows that came or moved get default values of what is not saved.
    void stage_transient(const ParsedStream::Rows& rows, std::vector<StagedColumn>& staged) {
        for (const ComponentId component : signature_of(rows.archetype)) {
            const ComponentType* type = parsed_.components[component].type;
            if (type == nullptr || !type->transient() || type->info->size == 0) continue;
            for (const ParsedStream::Run& run : rows.entities)
                staged.push_back({component, run.first, run.rows, StagedRows{*type, run.rows}});
        }
    }

    /// Makes the changed sets anew, beside those that they will be exchanged with.
    void stage_sparse() {
        const std::uint32_t version = parsed_.header.position.version;
        for (const ParsedStream::Sparse& told : parsed_.sparse) {
            const ParsedStream::Component& component = parsed_.components[told.component];
            if (component.type == nullptr) continue;
            const ComponentInfo& info = *component.type->info;
            SparseSet& old = graph_.sparse_set(info);
            StagedSet staged{&old, std::make_unique<SparseSet>(WorldAccess::pool(graph_), info)};
            WorldAccess::set_membership_version(*staged.fresh, version);
            if (info.size == 0) {
                for (std::uint32_t place = 0; place < told.size; ++place)
                    staged.fresh->insert(detail::entity_at(told.entities, place), version);
            } else {
                StagedRows values{*component.type, told.size};
                if (component.has_values) component.decoder.decode(told.values, told.size, values.objects());
                for (std::uint32_t place = 0; place < told.size; ++place) {
                    staged.fresh->insert(detail::entity_at(told.entities, place), version);
                    values.move_one(staged.fresh->value(place));
                }
            }
            staged_sets_.push_back(std::move(staged));
        }
    }

    void stage_resources() {
        for (const ParsedStream::Resource& resource : parsed_.resources) {
            Staged staged{resource.type, resource.type->make()};
            resource.decoder.decode(resource.fields, 1, static_cast<std::byte*>(staged.value.get()));
            staged_resources_.push_back(std::move(staged));
        }
    }

    [[nodiscard]] std::span<const ComponentId> signature_of(std::uint32_t archetype) const {
        if (archetype < parsed_.known_archetypes) return graph_[archetype].signature();
        return parsed_.archetypes[archetype - parsed_.known_archetypes].signature;
    }

    void make_archetypes() {
        for (const ParsedStream::Component& component : parsed_.components) {
            ids_.push_back(component.type == nullptr ? k_no_component
                                                     : graph_.component(*component.type->info));
        }
        for (std::uint32_t i = 0; i < parsed_.known_archetypes; ++i)
            targets_.push_back(&graph_[i]);
        std::vector<ComponentId> signature;
        std::vector<const SharedValue*> shared;
        for (const ParsedStream::Archetype& stored : parsed_.archetypes) {
            signature.clear();
            for (ComponentId component : stored.signature) {
                if (ids_[component] != k_no_component) signature.push_back(ids_[component]);
            }
            shared.clear();
            for (const StagedRows& value : stored.shared)
                shared.push_back(&graph_.intern(value.info(), value.objects()));
            std::sort(shared.begin(), shared.end(),
                      [](const SharedValue* a, const SharedValue* b) { return a->component < b->component; });
            targets_.push_back(&graph_.with_signature(signature, shared));
        }
    }

    /// Where components were left out, several archetypes of the stream may become one, row after row.
    void reserve() {
        std::vector<std::uint64_t> rows(graph_.size());
        for (const ParsedStream::Rows& block : parsed_.rows) {
            Archetype& target = *targets_[block.archetype];
            const bool shares = parsed_.header.kind == detail::StreamKind::snapshot;
            first_rows_.push_back(shares ? static_cast<std::uint32_t>(rows[target.index()]) : 0);
            rows[target.index()] += block.rows;
            if (rows[target.index()] > WorldAccess::max_rows(graph_))
                detail::throw_full("rows in one archetype", WorldAccess::max_rows(graph_));
            WorldAccess::reserve(target, static_cast<std::uint32_t>(rows[target.index()]));
        }
        WorldAccess::reserve(table_, parsed_.slots);
        kept_ = detail::free_slots(world_);
        kept_.resize(parsed_.free_kept);
        retired_ = WorldAccess::retired(table_);
    }

    void commit() noexcept {
        for (std::size_t i = 0; i < parsed_.rows.size(); ++i)
            commit_rows(parsed_.rows[i], *targets_[parsed_.rows[i].archetype], first_rows_[i], staged_[i]);
        for (StagedSet& set : staged_sets_)
            WorldAccess::swap(*set.old, *set.fresh);
        commit_slots();
        WorldAccess::set_version(world_, parsed_.header.position.version + 1);
    }

    void commit_rows(const ParsedStream::Rows& block, Archetype& target, std::uint32_t first_row,
                     std::vector<StagedColumn>& staged) noexcept {
        const std::uint32_t version = parsed_.header.position.version;
        const std::uint32_t old_rows = target.rows();
        const std::uint32_t rows = first_row + block.rows;
        for (const Archetype::Column& column : target.columns()) {
            if (rows < old_rows) end_rows(column, rows, old_rows);
        }
        for (StagedColumn& values : staged) {
            const ColumnIndex index = target.column_of(ids_[values.component]);
            const Archetype::Column& column = target.columns()[index];
            const std::uint32_t first = first_row + values.first;
            end_rows(column, first, std::min(first + values.rows, old_rows));
            values.values.move_to(column.at(first));
            for_each_chunk(first, values.rows,
                           [&](std::uint32_t chunk) { target.stamp(index, chunk, version); });
        }
        for (const ParsedStream::Run& run : block.entities) {
            const std::uint32_t first = first_row + run.first;
            for (std::uint32_t i = 0; i < run.rows; ++i) {
                const Entity entity = detail::entity_at(run.values, i);
                WorldAccess::entities(target)[first + i] = entity;
                table_[entity.index] = {entity.generation, target.index(), first + i};
            }
            for_each_chunk(first, run.rows, [&](std::uint32_t chunk) {
                WorldAccess::stamp_rows(target, chunk * k_chunk_rows, version);
            });
        }
        WorldAccess::set_rows(target, rows);
    }

    static void end_rows(const Archetype::Column& column, std::uint32_t first, std::uint32_t last) noexcept {
        if (first < last && column.info->destroy != nullptr)
            column.info->destroy(column.at(first), last - first);
    }

    template <class F>
    static void for_each_chunk(std::uint32_t first_row, std::uint32_t rows, F f) {
        for (std::uint32_t chunk = first_row / k_chunk_rows; chunk <= (first_row + rows - 1) / k_chunk_rows;
             ++chunk)
            f(chunk);
    }

    void commit_slots() noexcept {
        std::uint32_t first_free = kept_.empty() ? WorldAccess::k_no_slot : kept_.back();
        for (const Entity& slot : parsed_.free) {
            table_[slot.index] = {slot.generation, k_no_archetype, first_free};
            first_free = slot.index;
        }
        for (std::uint32_t slot : parsed_.retired)
            table_[slot] = {WorldAccess::k_last_generation, k_no_archetype, WorldAccess::k_no_slot};
        WorldAccess::set_first_free(table_, first_free);
        const std::size_t dead = kept_.size() + parsed_.free.size() + retired_ + parsed_.retired.size();
        WorldAccess::set_slots(table_, parsed_.slots, parsed_.slots - static_cast<std::uint32_t>(dead),
                               retired_ + static_cast<std::uint32_t>(parsed_.retired.size()));
    }

    World& world_;
    ArchetypeGraph& graph_;
    EntityTable& table_;
    const ParsedStream& parsed_;
    std::vector<std::vector<StagedColumn>> staged_;  ///< as parsed_.rows
    std::vector<StagedSet> staged_sets_;
    std::vector<Staged> staged_resources_;
    std::vector<ComponentId> ids_;           ///< of the world, by component of the stream
    std::vector<Archetype*> targets_;        ///< by archetype of the stream
    std::vector<std::uint32_t> first_rows_;  ///< as parsed_.rows: where a block's rows begin in its target
    std::vector<std::uint32_t> kept_;        ///< free slots that stay
    std::uint32_t retired_ = 0;              ///< slots before
};

/// Whether something was written, or a version ended, after a position.
bool changed_since(const World& world, const ChainPosition& position) {
    if (world.version() != position.version + 1) return true;
    const auto later = [&](std::uint32_t version) {
        return is_after(version, position.version);
    };
    const ArchetypeGraph& graph = WorldAccess::graph(world);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const Archetype& archetype = graph[i];
        for (std::uint32_t chunk = 0; chunk * k_chunk_rows < archetype.capacity(); ++chunk) {
            bool written = later(WorldAccess::rows_version(archetype, chunk));
            for (std::size_t column = 0; column < archetype.columns().size(); ++column)
                written = written || later(archetype.version(static_cast<ColumnIndex>(column), chunk));
            if (written) return true;
        }
    }
    const auto& sets = graph.sparse().all();
    return std::any_of(sets.begin(), sets.end(),
                       [&](const auto& set) { return WorldAccess::changed_since(*set, position.version); });
}

}  // namespace

RestoredWorld read_snapshot(std::span<const std::byte> bytes, const TypeRegistry& registry,
                            const SnapshotOptions& options) {
    const detail::StreamHeader header = detail::read_header(bytes, detail::StreamKind::snapshot);
    detail::check_base(header, {});
    WorldOptions world_options = options.world;
    world_options.first_version = header.position.version;
    RestoredWorld restored;
    restored.world = std::make_unique<World>(world_options);
    ParsedStream parsed =
        detail::parse_stream(bytes, header, *restored.world, registry, options.drop_unknown_components);
    Applier{*restored.world, parsed}.apply();
    if (parsed.dropped.empty()) restored.position = header.position;
    restored.dropped = std::move(parsed.dropped);
    return restored;
}

void apply_delta(RestoredWorld& restored, std::span<const std::byte> delta, const TypeRegistry& registry) {
    World& world = *restored.world;
    detail::IterationMark::forbid(world, "apply_delta");
    const detail::StreamHeader header = detail::read_header(delta, detail::StreamKind::delta);
    detail::check_base(header, restored.position);
    if (changed_since(world, restored.position)) {
        throw Misuse{"ecs: apply_delta: the world was changed since it was restored"};
    }
    const ParsedStream parsed = detail::parse_stream(delta, header, world, registry, false);
    Applier{world, parsed}.apply();
    restored.position = header.position;
}

}  // namespace rambla::ecs
