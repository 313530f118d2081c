#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rambla::assets {

/// Walks the heads of an OpenEXR file: the library believes every size that stands there and allocates it.
/// Attributes must end inside the file, windows and tiles keep to the limit, channels to 64.
/// @param name  stands for the file in errors
/// @throws Error
void check_exr(std::span<const std::byte> bytes, const std::string& name, std::uint32_t max_size_px);

}  // namespace rambla::assets
