#include "assets/process/raster.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "assets/assert.h"

namespace rambla::assets {

namespace {

/// The old texels that a new one covers, with their shares of it.
struct Cover {
    std::uint32_t first = 0;
    std::vector<float> shares;
};

std::vector<Cover> covers(std::uint32_t size, std::uint32_t new_size) {
    std::vector<Cover> all(new_size);
    for (std::uint64_t i = 0; i < new_size; ++i) {
        // In units of 1/new_size of an old texel, so that the borders are whole numbers.
        const std::uint64_t begin = i * size;
        const std::uint64_t end = begin + size;
        all[i].first = static_cast<std::uint32_t>(begin / new_size);
        for (std::uint64_t texel = all[i].first; texel * new_size < end; ++texel) {
            const std::uint64_t from = std::max(begin, texel * new_size);
            const std::uint64_t to = std::min(end, (texel + 1) * new_size);
            all[i].shares.push_back(static_cast<float>(to - from) / static_cast<float>(size));
        }
    }
    return all;
}

}  // namespace

std::uint32_t mip_count(std::uint32_t width, std::uint32_t height) {
    std::uint32_t count = 1;
    for (std::uint32_t size = std::max(width, height); size > 1; size = halved(size))
        ++count;
    return count;
}

Raster resampled(std::uint32_t width, std::uint32_t height, const RowReader& source, std::uint32_t new_width,
                 std::uint32_t new_height) {
    RAMBLA_ASSERT(width > 0 && height > 0 && new_width > 0 && new_height > 0, "pictures have texels");
    const std::vector<Cover> columns = covers(width, new_width);
    const std::vector<Cover> rows = covers(height, new_height);
    Raster out{new_width, new_height, {}};
    out.texels.resize(std::size_t{new_width} * new_height);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>{0, new_height}, [&](const auto& range) {
        std::vector<glm::vec4> row(width);
        std::vector<glm::vec4> sum(width);
        for (std::uint32_t y = range.begin(); y < range.end(); ++y) {
            sum.assign(width, glm::vec4{0.0f});
            for (std::size_t i = 0; i < rows[y].shares.size(); ++i) {
                source(rows[y].first + static_cast<std::uint32_t>(i), row);
                for (std::uint32_t x = 0; x < width; ++x)
                    sum[x] += rows[y].shares[i] * row[x];
            }
            for (std::uint32_t x = 0; x < new_width; ++x) {
                glm::vec4 texel{0.0f};
                for (std::size_t i = 0; i < columns[x].shares.size(); ++i)
                    texel += columns[x].shares[i] * sum[columns[x].first + i];
                out.texels[std::size_t{y} * new_width + x] = texel;
            }
        }
    });
    return out;
}

}  // namespace rambla::assets
