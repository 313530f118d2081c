#pragma once

#include <filesystem>

namespace rambla::fuzz {

/// Imports a glTF file: it must become a sound scene or an assets::Error in one line, nothing else.
void check_import(const std::filesystem::path& file);

}  // namespace rambla::fuzz
