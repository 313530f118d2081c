#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "assets/cache/cache.h"
#include "assets/process/process.h"
#include "assets/processed.h"
#include "assets/scene.h"

namespace rambla::assets {

/// Part of every key. To be raised by one with each change of what processing makes of the same input, or of
/// how payloads are laid out: what older code has kept is then not found any more.
inline constexpr std::uint32_t k_processing_version = 2;

/// Which levels of textures stay in memory.
enum class KeptLevels : std::uint8_t {
    all,
    floors  ///< where the cache has the texture, only the small ones, see floor_level()
};

/// A processed scene, and where it came from.
struct CachedProcess {
    ProcessedScene scene;
    /// Where the cache keeps each of the scene's images; none where it has not got it (any more).
    std::vector<std::optional<ContentHash>> texture_entries;
    std::uint32_t loaded = 0;     ///< meshes and uses of pictures that the cache had
    std::uint32_t processed = 0;  ///< those that had to be made
    double loading_ms = 0.0;      ///< wall time to hash what they are made of, and to read
    double processing_ms = 0.0;   ///< wall time to make and to store the others
};

/// Is told after each result that had to be made, from one thread at a time.
using ProcessProgress = std::function<void(std::uint32_t made, std::uint32_t missing)>;

/// As process(), but what the cache holds of the same content, use and parameters is read from there, and
/// everything else stored for next time. What is read and does not fit the scene is made anew. Side by side
/// on oneTBB; the processed scene is the same for any number of threads and whatever the cache holds.
/// @param scene  as for process()
[[nodiscard]] CachedProcess process_cached(const Scene& scene, const ProcessParameters& parameters,
                                           Cache& cache, const ProcessProgress& progress = {},
                                           KeptLevels kept = KeptLevels::all);

}  // namespace rambla::assets
