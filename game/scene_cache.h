#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "assets/process/process.h"
#include "assets/processed.h"
#include "assets/scene.h"
#include "assets/texture_levels.h"
#include "game/stage.h"
#include "render/gl/context.h"
#include "render/render_thread.h"

namespace rambla::game {

/// Processed scenes may take so much of a user's disk.
inline constexpr std::uint64_t k_cache_limit_bytes = std::uint64_t{2} << 30;

/// Where processed scenes are kept: $RAMBLA_CACHE_DIR, else rambla in $XDG_CACHE_HOME, else in ~/.cache, else
/// a folder of the user's own among the temporary files.
[[nodiscard]] std::filesystem::path cache_folder();

/// A scene as a device draws it, and what it took to get it.
struct PreparedScene {
    std::shared_ptr<const assets::ProcessedScene> scene;  ///< with the small levels of textures alone
    std::shared_ptr<assets::LevelSource> textures;        ///< of the finer levels
    std::uint32_t cache_hits = 0;    ///< meshes and textures that an earlier start had made
    std::uint32_t cache_misses = 0;  ///< those made now
    double loading_ms = 0.0;
    double processing_ms = 0.0;
};

/// Takes from the cache what is there and makes the rest, with textures as suits the device.
/// @param quiet  shows no progress
[[nodiscard]] PreparedScene prepare_scene(const assets::Scene& scene, const render::DeviceInfo& device,
                                          bool quiet);
/// The same by other parameters than suit the device.
[[nodiscard]] PreparedScene prepare_scene(const assets::Scene& scene,
                                          const assets::ProcessParameters& parameters, bool quiet);

/// Gives a stage's scene to who draws it, and lets the stage's Frames say which textures they need.
void hand_over(PreparedScene prepared, Stage& stage, render::RenderThread& thread);

}  // namespace rambla::game
