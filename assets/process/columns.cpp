#include "assets/process/columns.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace rambla::assets {

namespace {

/// FNV-1a over one row of all columns.
std::uint64_t hash_of(std::span<const ColumnBytes> columns, std::size_t row) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const ColumnBytes& column : columns)
        for (std::size_t i = 0; i < column.stride; ++i)
            hash = (hash ^ std::to_integer<std::uint64_t>(column.data[row * column.stride + i])) *
                   0x100000001b3ull;
    return hash;
}

int compare(std::span<const ColumnBytes> columns, std::size_t a, std::size_t b) {
    for (const ColumnBytes& column : columns) {
        const int order =
            std::memcmp(column.data + a * column.stride, column.data + b * column.stride, column.stride);
        if (order != 0) return order;
    }
    return 0;
}

}  // namespace

std::vector<std::uint32_t> first_identical(std::span<const ColumnBytes> columns, std::size_t count) {
    std::vector<std::uint64_t> hashes(count);
    for (std::size_t row = 0; row < count; ++row)
        hashes[row] = hash_of(columns, row);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    // Sorted, not put into a table: files made so that all hashes collide cost no more than others.
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (hashes[a] != hashes[b]) return hashes[a] < hashes[b];
        const int rows = compare(columns, a, b);
        return rows != 0 ? rows < 0 : a < b;
    });
    std::vector<std::uint32_t> first(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool as_before = i > 0 && hashes[order[i]] == hashes[order[i - 1]] &&
                               compare(columns, order[i], order[i - 1]) == 0;
        first[order[i]] = as_before ? first[order[i - 1]] : order[i];
    }
    return first;
}

std::vector<glm::vec3> without_negative_zero(std::span<const glm::vec3> positions) {
    std::vector<glm::vec3> out(positions.begin(), positions.end());
    for (glm::vec3& position : out)
        position += 0.0f;  // −0 + 0 is +0
    return out;
}

bool all_finite(std::span<const glm::vec3> positions) {
    return std::all_of(positions.begin(), positions.end(), [](glm::vec3 p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
}

std::vector<std::uint32_t> welded_by_position(std::span<const glm::vec3> positions) {
    const std::vector<glm::vec3> places = without_negative_zero(positions);
    const ColumnBytes column = bytes_of(places);
    return first_identical({&column, 1}, places.size());
}

}  // namespace rambla::assets
