#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "assets/cache/cache.h"
#include "assets/cache/cached_process.h"
#include "assets/texture_levels.h"

namespace rambla::assets {

/// Where all levels of an image are.
struct LevelOrigin {
    std::optional<ContentHash> entry;  ///< of the cache
    TextureData image;  ///< without an entry all of it is stored here; with one nothing need be
};

/// Reads levels from the cache in a thread of its own. An entry is read whole, checked as any other time, and
/// must still be of the image's size and format; one that is not there any more, or damaged, is named in one
/// warning for each image.
class LevelLoader final : public LevelSource {
public:
    LevelLoader(std::shared_ptr<Cache> cache, std::vector<LevelOrigin> images);
    /// Waits for the entry that is just being read, no longer.
    ~LevelLoader() override;

    void request(const LevelRange& range) override;
    [[nodiscard]] std::optional<LoadedLevels> take() override;
    [[nodiscard]] bool wait() override;
    void close() override;

private:
    void run();
    [[nodiscard]] std::vector<std::byte> load(const LevelRange& range);
    void warn_once(std::uint32_t image, const char* found);

    std::shared_ptr<Cache> cache_;
    std::vector<LevelOrigin> images_;
    std::vector<char> warned_;  ///< by image; of the thread alone

    std::mutex mutex_;
    std::condition_variable changed_;
    // Guarded by the mutex:
    std::deque<LevelRange> requests_;
    std::deque<LoadedLevels> loaded_;
    bool loading_ = false;
    bool closed_ = false;

    std::thread thread_;  ///< last: runs on all of the above
};

/// A loader for what was processed with KeptLevels::floors. Moves what the cache does not have out of the
/// scene, where of all images only the levels from floor_level() on are left.
[[nodiscard]] std::shared_ptr<LevelLoader> make_level_loader(CachedProcess& processed,
                                                             std::shared_ptr<Cache> cache);

}  // namespace rambla::assets
