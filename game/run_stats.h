#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rambla::game {

/// What a process and its renderer held after one frame.
struct HeldSample {
    std::uint64_t frame = 0;
    std::uint64_t heap_bytes = 0;      ///< C++ allocations: the engine's own, not the GL driver's
    std::uint64_t resident_bytes = 0;  ///< of the process, driver and freed pages included
    std::uint64_t gpu_bytes = 0;  ///< without the scene's textures, which come and go within their budget
    std::uint32_t gl_objects = 0;
};

/// Whether a run went on holding the same, once it had settled.
struct Steadiness {
    bool known = false;  ///< false: the run was too short to tell
    bool steady = false;
    std::int64_t heap_growth_bytes = 0;      ///< between the median of the first and of the last quarter
    std::int64_t resident_growth_bytes = 0;  ///< likewise
    std::int64_t gpu_growth_bytes = 0;       ///< between the most of the first and of the last quarter
    std::int64_t gl_object_growth = 0;       ///< likewise
};

/// Frames before this one fill caches, pools and queues; nothing after it may grow.
inline constexpr std::uint64_t k_settled_frame = 50;
/// The heap may differ by this much: encoders hold a few pictures or none.
inline constexpr std::int64_t k_heap_tolerance_bytes = 4ll << 20;
/// Resident memory may differ by this much: llvmpipe keeps the bins of every scene that it has had under way
/// at once, up to 36 MiB each (LP_SCENE_MAX_SIZE), as full as the view was heavy. Two of them come and go
/// with the view and with how far the raster threads lag behind.
inline constexpr std::int64_t k_resident_tolerance_bytes = 72ll << 20;

/// Compares the first and the last quarter of the samples from k_settled_frame on.
[[nodiscard]] Steadiness steadiness(const std::vector<HeldSample>& samples);

/// Every `every`-th sample as a line, then the verdict.
[[nodiscard]] std::string to_text(const std::vector<HeldSample>& samples, std::uint64_t every);

}  // namespace rambla::game
