#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ecs/byte_stream.h"
#include "ecs/entity.h"
#include "ecs/snapshot_error.h"
#include "ecs/type_registry.h"
#include "ecs/world.h"

namespace rambla::ecs {

namespace detail {
class RowEncoder;
}

/// Where a world stands in a chain of one snapshot and the deltas after it.
struct ChainPosition {
    std::uint32_t version = 0;   ///< the world's version that the stream ended
    std::uint64_t checksum = 0;  ///< of the stream

    bool operator==(const ChainPosition&) const = default;
};

/// Writes a world as a stream of bytes: the same bytes on every machine, for equal worlds. A stream holds
///  - all entities: rows in their order, generations, and the free slots in the order of their next use, so
///    that handles stay valid and later creation continues alike,
///  - the described fields of all components, archetype by archetype and column by column,
///  - which rows are switched off, shared values, and sparse components in their dense order,
///  - the resources that the registry names. Other resources are the caller's.
/// It does not hold change versions: in the restored world everything counts as written at the version that
/// the stream ended, so that whoever asks what changed since then is told only later changes.
/// A component type that the world has and the registry lacks is refused with Misuse, which names it.
///
/// Memory is kept from one stream to the next: nothing is allocated when the next is no longer.
class SnapshotWriter {
public:
    /// @param registry  must outlive the writer, and gets no more types
    explicit SnapshotWriter(const TypeRegistry& registry);
    ~SnapshotWriter();
    SnapshotWriter(const SnapshotWriter&) = delete;
    SnapshotWriter& operator=(const SnapshotWriter&) = delete;

    /// The whole world. Ends its version and begins a chain. The bytes stay until the next call.
    std::span<const std::byte> write(World& world);
    /// What changed since this writer's last stream of the same world: chunks of columns that were written,
    /// rows that came, went or moved, slots, and the registry's resources. Ends the world's version. Throws
    /// Misuse if the last stream was of another world or there was none.
    std::span<const std::byte> write_delta(World& world);

    /// Of the last stream.
    [[nodiscard]] ChainPosition position() const { return position_; }

private:
    struct Base;

    std::span<const std::byte> write_stream(World& world, const Base* base);
    void write_components(const World& world);
    void write_archetypes(const World& world, const Base* base);
    void write_rows(const World& world, const Base* base);
    void write_archetype_rows(const Archetype& archetype, const Base* base);
    template <class VersionOf>
    void find_runs(const Archetype& archetype, const Base* base, VersionOf version_of);
    void write_runs();
    void write_entities(std::span<const Entity> entities);
    void write_sparse_sets(const World& world, const Base* base);
    void write_slots(const World& world, const Base* base);
    void find_retired(const EntityTable& table);
    void write_resources(const World& world);
    void remember(const World& world);

    struct Run {
        std::uint32_t first;
        std::uint32_t rows;
    };
    /// What the last stream told, to tell only what is new.
    struct Base {
        std::uint64_t world_serial = 0;
        std::size_t archetypes = 0;
        std::vector<std::uint32_t> rows;     ///< by archetype
        std::vector<Entity> free;            ///< slots and generations, the one to be used last first
        std::vector<std::uint32_t> retired;  ///< slots that are never used again, ascending
    };

    const TypeRegistry* registry_;
    detail::ByteWriter out_;
    std::vector<const ComponentType*> types_;                     ///< by component number
    std::vector<std::unique_ptr<detail::RowEncoder>> encoders_;   ///< by component number; null: no values
    std::vector<std::unique_ptr<detail::RowEncoder>> resources_;  ///< as in the registry
    std::vector<Run> runs_;
    Base base_;
    std::vector<std::uint32_t> free_;
    std::vector<std::uint32_t> retired_;
    ChainPosition position_;
};

struct SnapshotOptions {
    WorldOptions world;  ///< but first_version, which the snapshot tells
    /// Components that the registry does not know are left out instead of refused. No delta applies to a
    /// world that lacks some.
    bool drop_unknown_components = false;
};

/// A world out of a snapshot, and which delta fits it next.
struct RestoredWorld {
    std::unique_ptr<World> world;
    ChainPosition position;
    std::vector<std::string> dropped;  ///< components left out
};

/// Makes a world of a snapshot. Bytes of any content are checked completely first (length, format, checksum,
/// counts, references, duplicates, values of bools and enums); what is not right throws SnapshotError.
/// Throws CapacityExceeded if the world's options are too small. Entities in fields may be stale, as in any
/// world: every use of a handle is checked.
/// Older versions of a type are upgraded as TypeRegistry::migrate says.
[[nodiscard]] RestoredWorld read_snapshot(std::span<const std::byte> bytes, const TypeRegistry& registry,
                                          const SnapshotOptions& options = {});

/// Brings a restored world to where the delta's writer was: then a snapshot of either gives the same bytes.
/// Throws SnapshotError if the bytes are not right or a delta of another position, Misuse if the world was
/// changed since, CapacityExceeded; the world's entities are then as they were.
void apply_delta(RestoredWorld& restored, std::span<const std::byte> delta, const TypeRegistry& registry);

}  // namespace rambla::ecs
