#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rambla::ecs {

/// What one archetype holds.
struct ArchetypeStats {
    std::vector<std::string_view> components;  ///< names, in the order in which the world met them
    std::uint32_t rows = 0;                    ///< entities
    std::uint32_t capacity = 0;                ///< rows that fit into row_bytes
    std::size_t row_bytes = 0;                 ///< committed columns, or the block of the pool
    std::size_t table_bytes = 0;               ///< besides: change versions and tables
    bool has_reservation = false;  ///< each column has an address range of its own; else they share a block
};

}  // namespace rambla::ecs
