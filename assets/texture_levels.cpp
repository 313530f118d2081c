#include "assets/texture_levels.h"

#include <algorithm>

#include "assets/assert.h"

namespace rambla::assets {

std::uint32_t floor_level(const TextureData& texture) {
    std::uint32_t level = 0;
    while (level + 1 < texture.levels.size() &&
           std::max(texture.levels[level].width, texture.levels[level].height) > k_floor_side) {
        ++level;
    }
    return level;
}

void drop_levels(TextureData& texture, std::uint32_t first) {
    if (first <= texture.first_stored) return;
    std::size_t dropped = 0;
    for (std::uint32_t level = texture.first_stored; level < first; ++level)
        dropped += texture.levels[level].size;
    // A vector of its own: erasing would keep the memory.
    texture.bytes = std::vector<std::byte>(texture.bytes.begin() + static_cast<std::ptrdiff_t>(dropped),
                                           texture.bytes.end());
    for (std::uint32_t level = 0; level < texture.levels.size(); ++level) {
        std::size_t& offset = texture.levels[level].offset;
        offset = level < first ? 0 : offset - dropped;
    }
    texture.first_stored = first;
}

std::span<const std::byte> bytes_of(const TextureData& texture, std::uint32_t first, std::uint32_t end) {
    RAMBLA_ASSERT(texture.first_stored <= first && first < end && end <= texture.levels.size(),
                  "only levels that are stored have bytes");
    const TextureLevel& last = texture.levels[end - 1];
    const std::size_t offset = texture.levels[first].offset;
    return std::span{texture.bytes}.subspan(offset, last.offset + last.size - offset);
}

}  // namespace rambla::assets
