#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rambla::assets {

/// A JPEG without the segments that say nothing of its texels (Exif, colour profiles, comments), whose text
/// OpenImageIO 2.4 compares beyond its end. On the way, what the library would believe is checked: it takes
/// the frame's size at its word when it opens a progressive picture, and goes over all of it once for each
/// scan, of which real files have about ten.
/// @param name  stands for the file in errors
/// @throws Error  when the frame is larger than the limit, or has more than 100 scans
[[nodiscard]] std::vector<std::byte> essential_jpeg(std::span<const std::byte> bytes, const std::string& name,
                                                    std::uint32_t max_size_px);

}  // namespace rambla::assets
