#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace rambla::assets {

/// Four floats a texel, row-major: what filtering works on.
struct Raster {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::vec4> texels;

    [[nodiscard]] std::span<const glm::vec4> row(std::uint32_t y) const {
        return std::span{texels}.subspan(std::size_t{y} * width, width);
    }
};

/// Fills a row of `width` texels; called from several threads.
using RowReader = std::function<void(std::uint32_t y, std::span<glm::vec4> row)>;

/// The next mip level's size: half of it, rounded down, at least 1.
[[nodiscard]] constexpr std::uint32_t halved(std::uint32_t size) {
    return size > 1 ? size / 2 : 1;
}

/// Number of levels down to 1×1.
[[nodiscard]] std::uint32_t mip_count(std::uint32_t width, std::uint32_t height);

/// Every new texel is the mean over exactly the area that it covers, so that nothing shifts at any size: an
/// odd row of 2m + 1 texels is weighted (m − i, m, i + 1)/(2m + 1) for the i-th of m (Guthe & Heckbert 2005,
/// "Non-power-of-two mipmap creation"). Sizes may grow too.
[[nodiscard]] Raster resampled(std::uint32_t width, std::uint32_t height, const RowReader& source,
                               std::uint32_t new_width, std::uint32_t new_height);

}  // namespace rambla::assets
