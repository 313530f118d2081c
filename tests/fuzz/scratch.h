#pragma once

#include <filesystem>
#include <string>

#include "fuzz/target.h"

namespace rambla::fuzz {

/// A folder of this process, gone when it ends in order.
[[nodiscard]] const std::filesystem::path& scratch_folder();

/// Writes a file there, over what was. @return its path
std::filesystem::path write_scratch(const std::string& name, Bytes bytes);

[[nodiscard]] std::vector<std::byte> read_scratch(const std::filesystem::path& file);

}  // namespace rambla::fuzz
