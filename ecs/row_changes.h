#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecs/version.h"

namespace rambla::ecs {

/// Which rows of a chunk were written, for one column: a bit per 16 neighbours, kept for each of the last
/// four versions that wrote. What a reader asks for beyond those counts as written in every row.
class ChunkChanges {
public:
    static constexpr std::uint32_t k_rows_per_bit = 16;
    static constexpr std::uint64_t k_all = ~std::uint64_t{0};

    explicit ChunkChanges(std::uint32_t oldest) : before_{oldest} { versions_.fill(oldest); }

    /// Adds rows (bits) written in `version`, which is not older than the last one.
    void mark(std::uint64_t bits, std::uint32_t version) noexcept {
        if (versions_[0] != version) {
            before_ = versions_.back();
            for (std::size_t i = versions_.size() - 1; i > 0; --i) {
                versions_[i] = versions_[i - 1];
                masks_[i] = masks_[i - 1];
            }
            versions_[0] = version;
            masks_[0] = 0;
        }
        masks_[0] |= bits;
    }
    /// Rows that may have been written after `since`.
    [[nodiscard]] std::uint64_t after(std::uint32_t since) const {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < versions_.size(); ++i) {
            if (!is_after(versions_[i], since)) return bits;
            bits |= masks_[i];
        }
        return is_after(before_, since) ? k_all : bits;
    }
    void age(std::uint32_t oldest) noexcept {
        for (std::uint32_t& version : versions_)
            version = later(version, oldest);
        before_ = later(before_, oldest);
    }

private:
    std::array<std::uint64_t, 4> masks_{};
    std::array<std::uint32_t, 4> versions_;  ///< latest first
    std::uint32_t before_;                   ///< the latest one forgotten
};

/// The ChunkChanges of a column whose component asks for a row mask, by chunk.
using RowChanges = std::vector<ChunkChanges>;

}  // namespace rambla::ecs
