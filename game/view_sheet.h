#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "game/model_view.h"

namespace rambla::game {

/// What tells files apart: their paths without the folders that all of them have in common.
[[nodiscard]] std::vector<std::string> distinct_names(std::span<const std::filesystem::path> files);

/// Draws files one after the other and writes them as one picture, a cell of wishes.size_px for each, with
/// its name. A file that cannot be shown as wished gets a cell with the reason.
/// @param out  a .png file
/// @return     for each file what picture_facts() says, or the reason as `error`
/// @throws assets::Error  if the sheet cannot be written
nlohmann::json write_view_sheet(std::span<const std::filesystem::path> files, const ViewWishes& wishes,
                                const std::filesystem::path& out, bool quiet);

}  // namespace rambla::game
