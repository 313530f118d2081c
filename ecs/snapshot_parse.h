#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/row_codec.h"
#include "ecs/snapshot.h"
#include "ecs/snapshot_format.h"
#include "ecs/staged_rows.h"

namespace rambla::ecs::detail {

/// What a stream says of itself.
struct StreamHeader {
    StreamKind kind = StreamKind::snapshot;
    ChainPosition position;
    ChainPosition base;  ///< that it is to be applied to; nothing for a snapshot
};

/// Checks the stream as a whole: its length, its format, its kind and its checksum. Throws SnapshotError.
[[nodiscard]] StreamHeader read_header(std::span<const std::byte> bytes, StreamKind kind);

/// Throws SnapshotError if the stream is not for a world that stands at `position`.
void check_base(const StreamHeader& header, const ChainPosition& position);

/// A validated stream: what it says, with the values still in the stream's bytes.
struct ParsedStream {
    struct Component {
        const ComponentType* type;  ///< null: left out
        bool has_values;            ///< in the stream
        bool sparse;
        bool shared;
        RowDecoder decoder;
    };
    struct Run {
        std::uint32_t first;
        std::uint32_t rows;
        std::span<const std::byte> values;
    };
    struct Column {
        std::uint32_t component;  ///< number in the stream
        std::vector<Run> runs;
    };
    struct Archetype {
        std::vector<ComponentId> signature;
        std::vector<StagedRows> shared;  ///< one each, of the shared components that are not left out
    };
    /// What is new in one archetype.
    struct Rows {
        std::uint32_t archetype;  ///< number in the stream
        std::uint32_t rows;
        std::vector<Run> entities;
        std::vector<Column> columns;
    };
    /// A sparse set that changed.
    struct Sparse {
        std::uint32_t component;  ///< number in the stream
        std::uint32_t size;
        std::span<const std::byte> entities;
        std::span<const std::byte> values;
    };
    struct Resource {
        const ResourceType* type;
        RowDecoder decoder;
        std::span<const std::byte> fields;
    };

    StreamHeader header;
    std::vector<Component> components;
    std::uint32_t known_archetypes = 1;
    std::vector<Archetype> archetypes;  ///< new ones
    std::vector<Rows> rows;
    std::vector<Sparse> sparse;
    std::uint32_t slots = 0;
    std::uint32_t free_kept = 0;
    std::vector<Entity> free;            ///< new ones; the one used last first
    std::vector<std::uint32_t> retired;  ///< new ones
    std::vector<Resource> resources;
    std::vector<std::string> dropped;
};

/// How a component is stored, as streams tell it.
[[nodiscard]] std::uint8_t flags_of(const ComponentType& type);

[[nodiscard]] Entity entity_at(std::span<const std::byte> entities, std::uint32_t row);

/// Reads and checks all of a stream behind its header against the world that it is to be applied to, an empty
/// one for a snapshot. Throws SnapshotError, and CapacityExceeded if the world's limits are too low.
[[nodiscard]] ParsedStream parse_stream(std::span<const std::byte> bytes, const StreamHeader& header,
                                        const World& world, const TypeRegistry& registry,
                                        bool drop_unknown_components);

/// The world's free slots, the one used last first.
[[nodiscard]] std::vector<std::uint32_t> free_slots(const World& world);

/// Checks that afterwards every slot is exactly one living entity, free, or retired.
/// @param offset  of what the stream says of slots
void check_slots(const ParsedStream& parsed, const World& world, std::size_t offset);

/// Checks that afterwards the sparse sets hold living entities only, each once.
void check_sparse(const ParsedStream& parsed, const World& world, std::size_t offset);

}  // namespace rambla::ecs::detail
