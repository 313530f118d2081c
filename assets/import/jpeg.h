#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rambla::assets {

/// Walks the segments of a JPEG: the library takes the frame's size at its word when it opens a progressive
/// one, and goes over the whole picture once for each scan, of which real files have about ten.
/// @param name  stands for the file in errors
/// @throws Error  when the frame is larger than the limit, or has more than 100 scans
void check_jpeg(std::span<const std::byte> bytes, const std::string& name, std::uint32_t max_size_px);

}  // namespace rambla::assets
