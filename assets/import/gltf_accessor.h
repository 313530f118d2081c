#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "assets/import/gltf_document.h"

namespace rambla::assets::gltf {

/// Takes vectors of a column that have just been read, and may change them: where the piece begins in the
/// column comes with it. Pieces are small enough to be in the nearest cache still, which a second pass over
/// the whole column would have to fetch again.
template <int N>
using Finish = std::function<void(std::span<glm::vec<N, float>> piece, std::size_t first)>;

/// Indices, and the largest of them: 0 where there are none.
struct IndexColumn {
    std::vector<std::uint32_t> indices;
    std::uint32_t largest = 0;
};

/// Typed reading of one accessor: any component type, interleaved, sparse, or without a buffer view (zeros).
/// The constructor checks every offset, count and stride in 64 bits, so that reading cannot leave the buffer.
class AccessorReader {
public:
    /// @param element  where the document refers to the accessor, for errors
    /// @throws Error
    AccessorReader(const Document& document, int accessor, std::string element);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] int components() const { return components_; }  ///< 16 for matrices of 4 × 4
    [[nodiscard]] bool is_float() const;
    /// Elements that stand apart: reading costs at least their time, however few are gathered.
    [[nodiscard]] std::uint64_t sparse_count() const { return sparse_count_; }

    /// Integers become what `normalised` of the accessor says, or [0, 1] and [−1, 1] when `always_normalise`
    /// is set. Components that the accessor lacks are `missing`; surplus ones are dropped.
    /// @param gather  the elements to read, ascending, each below count(); empty means all
    /// @param finish  called for each vector once, in pieces that follow one another
    template <int N>
    [[nodiscard]] std::vector<glm::vec<N, float>> read(std::span<const std::uint32_t> gather, float missing,
                                                       bool always_normalise, const Finish<N>& finish) const;

    /// The first `elements`, at most count(), with all their components one after the other.
    [[nodiscard]] std::vector<float> read_floats(std::uint64_t elements, bool always_normalise = false) const;

    /// Scalars of an unsigned type, all in order. @throws Error  for other types
    [[nodiscard]] IndexColumn read_indices() const;

private:
    struct Bytes {
        const unsigned char* first = nullptr;  ///< null: all elements are zero
        std::uint64_t stride = 0;
    };
    [[nodiscard]] Bytes bytes_of_view(int view, std::int64_t offset, std::uint64_t count,
                                      std::uint64_t element_bytes, bool may_interleave,
                                      const std::string& where) const;
    [[nodiscard]] std::vector<std::uint32_t> sparse_indices() const;
    const Document& document_;
    std::string element_;
    std::uint64_t count_ = 0;
    int components_ = 0;
    int component_type_ = 0;
    std::uint64_t component_bytes_ = 0;
    bool normalised_ = false;
    Bytes base_;
    std::uint64_t sparse_count_ = 0;
    int sparse_index_type_ = 0;
    Bytes sparse_index_bytes_;
    Bytes sparse_values_;
};

}  // namespace rambla::assets::gltf
