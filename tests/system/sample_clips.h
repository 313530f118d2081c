#pragma once

#include <filesystem>

namespace rambla::system_test {

/// Writes a white tile on a dark one, as .glb with two clips of two seconds: "slide" moves it across, up to
/// the middle of that time and back; "spin" turns it once.
void write_clips(const std::filesystem::path& file);

/// Writes a white tile and a black one, as .glb with a camera that looks straight at the white one; within
/// two seconds the clip "ride" carries it in front of the black one. Nothing else moves.
void write_ride(const std::filesystem::path& file);

}  // namespace rambla::system_test
