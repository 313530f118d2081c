#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>

namespace rambla::game {

/// All that `rambla inspect` tells of a file: glTF by its name, else a picture. See game/inspect_json.h.
/// @throws assets::Error
[[nodiscard]] nlohmann::json inspect_file(const std::filesystem::path& file);

/// A row for each of several files, as rambla.inspect_files/1: whether it loads, loads with warnings or is
/// refused (`load`, `warn`, `refuse`), what it holds, and what there is to say of it (`words`). Of pictures
/// and of refused files the counts are null. Triangles count once for each model, however many nodes show it.
[[nodiscard]] nlohmann::json inspect_files(std::span<const std::filesystem::path> files);

}  // namespace rambla::game
