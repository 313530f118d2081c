#include "assets/cache/level_loader.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "assets/cache/processed_payload.h"

namespace rambla::assets {

namespace {

bool is_same_kind(const TextureData& a, const TextureData& b) {
    return a.format == b.format && a.colour_space == b.colour_space && a.swizzle == b.swizzle &&
           std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                      [](const TextureLevel& one, const TextureLevel& other) {
                          return one.width == other.width && one.height == other.height;
                      });
}

std::vector<std::byte> copy_of(std::span<const std::byte> bytes) {
    return {bytes.begin(), bytes.end()};
}

}  // namespace

LevelLoader::LevelLoader(std::shared_ptr<Cache> cache, std::vector<LevelOrigin> images)
    : cache_{std::move(cache)}, images_{std::move(images)}, warned_(images_.size()) {
    thread_ = std::thread{[this] {
        run();
    }};
}

LevelLoader::~LevelLoader() {
    close();
    thread_.join();
}

void LevelLoader::request(const LevelRange& range) {
    {
        const std::scoped_lock lock{mutex_};
        requests_.push_back(range);
    }
    changed_.notify_all();
}

std::optional<LoadedLevels> LevelLoader::take() {
    const std::scoped_lock lock{mutex_};
    if (loaded_.empty()) return std::nullopt;
    LoadedLevels levels = std::move(loaded_.front());
    loaded_.pop_front();
    return levels;
}

bool LevelLoader::wait() {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [this] { return closed_ || !loaded_.empty() || (requests_.empty() && !loading_); });
    return !closed_ && !loaded_.empty();
}

void LevelLoader::close() {
    {
        const std::scoped_lock lock{mutex_};
        closed_ = true;
        requests_.clear();
    }
    changed_.notify_all();
}

void LevelLoader::run() {
    std::unique_lock lock{mutex_};
    for (;;) {
        changed_.wait(lock, [this] { return closed_ || !requests_.empty(); });
        if (closed_) return;
        const LevelRange range = requests_.front();
        requests_.pop_front();
        loading_ = true;
        lock.unlock();
        LoadedLevels levels{range, load(range)};
        lock.lock();
        loading_ = false;
        loaded_.push_back(std::move(levels));
        changed_.notify_all();
    }
}

std::vector<std::byte> LevelLoader::load(const LevelRange& range) {
    const LevelOrigin& origin = images_[range.image];
    try {
        if (!origin.entry) return copy_of(bytes_of(origin.image, range.first, range.end));
        const std::optional<std::vector<std::byte>> payload = cache_->load(*origin.entry);
        if (!payload) {
            warn_once(range.image, "no entry, or a damaged one");
            return {};
        }
        const std::optional<TextureData> texture = texture_from_payload(*payload);
        if (texture && is_same_kind(*texture, origin.image))
            return copy_of(bytes_of(*texture, range.first, range.end));
        warn_once(range.image, "another picture");
    } catch (const std::exception& error) {  // no memory: a picture that stays blurred ends no game
        warn_once(range.image, error.what());
    }
    return {};
}

void LevelLoader::warn_once(std::uint32_t image, const char* found) {
    if (std::exchange(warned_[image], char{1}) != 0) return;
    const LevelOrigin& origin = images_[image];
    const std::string file = origin.entry ? cache_->file_of(*origin.entry).string() : "memory";
    spdlog::warn("{}: found {}, expected the levels of image {} '{}'; it stays as fine as it is", file, found,
                 image, origin.image.name);
}

std::shared_ptr<LevelLoader> make_level_loader(CachedProcess& processed, std::shared_ptr<Cache> cache) {
    std::vector<LevelOrigin> origins;
    for (std::size_t i = 0; i < processed.scene.images.size(); ++i) {
        TextureData& image = processed.scene.images[i];
        const std::uint32_t floor = floor_level(image);
        const std::optional<ContentHash>& entry = processed.texture_entries[i];
        TextureData kept = image;
        drop_levels(kept, floor);
        if (entry) drop_levels(image, static_cast<std::uint32_t>(image.levels.size()));
        origins.push_back({entry, std::move(image)});
        image = std::move(kept);
    }
    return std::make_shared<LevelLoader>(std::move(cache), std::move(origins));
}

}  // namespace rambla::assets
