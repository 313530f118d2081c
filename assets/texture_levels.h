#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assets/texture_data.h"

namespace rambla::assets {

/// Levels of no side longer than this are always kept: a thirtieth of what a 1024² texture takes at most.
inline constexpr std::uint32_t k_floor_side = 64;

/// The finest level that is small enough to be kept always.
[[nodiscard]] std::uint32_t floor_level(const TextureData& texture);

/// Lets go of the bytes of all levels finer than `first`, which may be levels.size(): of all of them.
void drop_levels(TextureData& texture, std::uint32_t first);

/// Neighbouring levels of a scene's image, `first` … `end` − 1.
struct LevelRange {
    std::uint32_t image = 0;  ///< of ProcessedScene::images
    std::uint32_t first = 0;
    std::uint32_t end = 0;

    bool operator==(const LevelRange&) const = default;
};

/// The bytes of levels that are stored, one behind the other.
[[nodiscard]] std::span<const std::byte> bytes_of(const TextureData& texture, std::uint32_t first,
                                                  std::uint32_t end);

struct LoadedLevels {
    LevelRange range;
    std::vector<std::byte> bytes;  ///< as bytes_of(); empty: they cannot be had, now or later
};

/// Brings levels of a scene's textures, off the threads that ask. One thread may ask at a time; close() may
/// come from any.
class LevelSource {
public:
    LevelSource() = default;
    virtual ~LevelSource() = default;
    LevelSource(const LevelSource&) = delete;
    LevelSource& operator=(const LevelSource&) = delete;

    /// Returns at once. Each request is answered once, in the order of the requests.
    virtual void request(const LevelRange& range) = 0;
    /// The next answer that has come; never waits.
    [[nodiscard]] virtual std::optional<LoadedLevels> take() = 0;
    /// Waits for an answer to take. @return  false if there is none to come, or the source was closed
    [[nodiscard]] virtual bool wait() = 0;
    /// Nothing is to come any more: whoever waits, waits no longer.
    virtual void close() = 0;
};

}  // namespace rambla::assets
