#pragma once

#include <filesystem>

namespace rambla::system_test {

/// Writes a white tile on a dark one, as .glb with two clips of two seconds: "slide" moves it across, up to
/// the middle of that time and back; "spin" turns it once.
void write_clips(const std::filesystem::path& file);

}  // namespace rambla::system_test
