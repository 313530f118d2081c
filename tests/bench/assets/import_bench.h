#pragma once

#include <span>

#include "bench/assets/inputs.h"

namespace rambla::bench {

/// Registers, for each input, `bare`: tinygltf reads and parses the file and its buffers, as a program would
/// that uses it alone; and `rambla`: the importer does, up to the scene with all its meshes, skins and clips.
/// Neither reads or decodes pictures; missing normals and tangents are not computed. Items are bytes.
void register_import_benchmarks(std::span<const Input> inputs);

}  // namespace rambla::bench
