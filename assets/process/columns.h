#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace rambla::assets {

/// The column's values at `rows`, in their order; empty where the column is.
template <class T>
[[nodiscard]] std::vector<T> gathered(const std::vector<T>& column, std::span<const std::uint32_t> rows) {
    std::vector<T> out;
    if (column.empty()) return out;
    out.reserve(rows.size());
    for (const std::uint32_t row : rows)
        out.push_back(column[row]);
    return out;
}

/// Bytes of one vertex column.
struct ColumnBytes {
    const std::byte* data = nullptr;
    std::size_t stride = 0;  ///< bytes of one row, all of them significant
};

template <class T>
[[nodiscard]] ColumnBytes bytes_of(const std::vector<T>& column) {
    return {reinterpret_cast<const std::byte*>(column.data()), sizeof(T)};
}

/// For every row the first row with the same bytes in all columns. Takes n log n time whatever the bytes are.
[[nodiscard]] std::vector<std::uint32_t> first_identical(std::span<const ColumnBytes> columns,
                                                         std::size_t count);

/// Positions whose equality is that of their bytes: −0 becomes +0.
[[nodiscard]] std::vector<glm::vec3> without_negative_zero(std::span<const glm::vec3> positions);

[[nodiscard]] bool all_finite(std::span<const glm::vec3> positions);

/// For every vertex the first vertex at the same place.
[[nodiscard]] std::vector<std::uint32_t> welded_by_position(std::span<const glm::vec3> positions);

}  // namespace rambla::assets
