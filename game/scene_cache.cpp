#include "game/scene_cache.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

#include "assets/cache/cached_process.h"
#include "assets/cache/level_loader.h"
#include "game/progress.h"
#include "systems/look/texture_uses.h"
#include "systems/pack/fading.h"

namespace rambla::game {

namespace {

namespace fs = std::filesystem;

fs::path path_from(const char* variable) {
    const char* const value = std::getenv(variable);
    return value != nullptr ? value : "";
}

assets::ProcessParameters parameters_for(const render::DeviceInfo& device) {
    assets::ProcessParameters parameters;
    if (!device.block_compression) parameters.textures.compression = assets::Compression::off;
    return parameters;
}

}  // namespace

fs::path cache_folder() {
    if (fs::path own = path_from("RAMBLA_CACHE_DIR"); !own.empty()) return own;
    // XDG Base Directory Specification 0.8: relative paths are invalid and to be ignored.
    if (const fs::path caches = path_from("XDG_CACHE_HOME"); caches.is_absolute()) return caches / "rambla";
    if (const fs::path home = path_from("HOME"); !home.empty()) return home / ".cache" / "rambla";
    std::error_code failure;
    const fs::path temporary = fs::temp_directory_path(failure);
    return (failure ? fs::path{"/tmp"} : temporary) / fmt::format("rambla-cache-{}", ::getuid());
}

PreparedScene prepare_scene(const assets::Scene& scene, const render::DeviceInfo& device, bool quiet) {
    return prepare_scene(scene, parameters_for(device), quiet);
}

PreparedScene prepare_scene(const assets::Scene& scene, const assets::ProcessParameters& parameters,
                            bool quiet) {
    const fs::path folder = cache_folder();
    const auto cache = std::make_shared<assets::Cache>(folder, k_cache_limit_bytes);
    std::optional<Progress> progress;
    assets::CachedProcess result = assets::process_cached(
        scene, parameters, *cache,
        [&](std::uint32_t made, std::uint32_t missing) {
            if (!progress) progress.emplace("Processing for the first time", missing, !quiet);
            progress->update(made);
        },
        assets::KeptLevels::floors);
    progress.reset();
    spdlog::debug("Cache {}: {} hits in {:.0f} ms, {} misses in {:.0f} ms", folder.string(), result.loaded,
                  result.loading_ms, result.processed, result.processing_ms);
    std::shared_ptr<assets::LevelSource> textures = assets::make_level_loader(result, cache);
    return {.scene = std::make_shared<const assets::ProcessedScene>(std::move(result.scene)),
            .textures = std::move(textures),
            .cache_hits = result.loaded,
            .cache_misses = result.processed,
            .loading_ms = result.loading_ms,
            .processing_ms = result.processing_ms};
}

void hand_over(PreparedScene prepared, Stage& stage, render::RenderThread& thread) {
    stage.world->set_resource(systems::TextureUses{*stage.scene, *prepared.scene});
    thread.upload(stage.scene, std::move(prepared.scene), std::move(prepared.textures),
                  systems::fading_materials(*stage.world));
}

}  // namespace rambla::game
