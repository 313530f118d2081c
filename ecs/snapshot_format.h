#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rambla::ecs::detail {

/// A stream, all numbers little-endian; text is a u32 length and bytes; lists are a u32 count and their
/// elements:
///     header      magic, u32 format, u32 kind, u64 length of the whole, u32 version,
///                 u32 base version, u64 base checksum (0 in a snapshot)
///     components  all of the world, by number: name, u8 flags, schema (u32 version, fields: path, u8 kind,
///                 u32 count)
///     archetypes  u32 known before (the empty one in a snapshot), then new ones: u16 component numbers,
///                 values of those that are shared
///     rows        archetypes with changes: u32 archetype, u32 rows, runs and entities, then for each column
///                 with values its runs and values; a run is u32 first row, u32 rows
///     sparse      sets with changes: u32 component, u32 entities, entities, values
///     slots       u32 slots, u32 free ones kept (those used last), new free ones (index, generation; the one
///                 used last first), new retired ones (index)
///     resources   name, schema, u8 there, fields
///     checksum    u64 of all before it
inline constexpr std::array<char, 8> k_magic{'R', 'b', 'l', 'a', 'E', 'C', 'S', '\n'};
inline constexpr std::uint32_t k_format = 1;

enum class StreamKind : std::uint32_t { snapshot = 1, delta = 2 };

inline constexpr std::size_t k_length_offset = 16;
inline constexpr std::size_t k_base_offset = 28;
inline constexpr std::size_t k_header_bytes = 40;
inline constexpr std::size_t k_checksum_bytes = 8;

/// Of a component: no column.
inline constexpr std::uint8_t k_tag_flag = 1;
/// Of a component: its values are not in the stream.
inline constexpr std::uint8_t k_transient_flag = 2;
/// Of a component: in a sparse set, not in archetypes.
inline constexpr std::uint8_t k_sparse_flag = 4;
/// Of a component: its value is the archetype's.
inline constexpr std::uint8_t k_shared_flag = 8;

}  // namespace rambla::ecs::detail
