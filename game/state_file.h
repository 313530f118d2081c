#pragma once

#include <filesystem>

#include "game/options.h"
#include "game/stage.h"

namespace rambla::game {

/// Writes the simulation's state, beside the file first, so that a file of this name is always whole.
/// @throws assets::Error  if the file cannot be written
void save_state_file(const std::filesystem::path& file, Stage& stage, const Options& options);

/// Replaces the stage's world by the saved one. The stage holds the same scene, seed, time and origin.
/// @throws assets::Error  if the file cannot be read, or holds no state of this place; the stage is unchanged
void load_state_file(const std::filesystem::path& file, Stage& stage, const Options& options);

}  // namespace rambla::game
