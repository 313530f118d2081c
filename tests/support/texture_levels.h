#pragma once

#include <algorithm>
#include <bit>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assets/process/blocks.h"
#include "assets/texture_levels.h"

namespace rambla::tests {

/// A texture with all levels, of bytes that tell where they are from.
[[nodiscard]] inline assets::TextureData noise_texture(
    std::uint32_t width, std::uint32_t height, std::uint32_t seed,
    assets::TexelFormat format = assets::TexelFormat::rgba8) {
    assets::TextureData texture;
    texture.name = "noise " + std::to_string(seed);
    texture.format = format;
    const auto count = static_cast<std::uint32_t>(std::bit_width(std::max(width, height)));
    std::size_t offset = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t w = std::max(width >> i, 1u), h = std::max(height >> i, 1u);
        const std::size_t size = assets::stored_size(format, w, h);
        texture.levels.push_back({w, h, offset, size, 0.0f});
        offset += size;
    }
    std::uint32_t state = seed * 2654435761u + 1u;
    for (std::size_t i = 0; i < offset; ++i) {
        state = state * 1664525u + 1013904223u;
        texture.bytes.push_back(static_cast<std::byte>(state >> 24u));
    }
    return texture;
}

/// Whole textures in memory, handed out at once or only so many as the test allows.
class TestLevels final : public assets::LevelSource {
public:
    explicit TestLevels(std::vector<assets::TextureData> images) : images_{std::move(images)} {}

    void request(const assets::LevelRange& range) override {
        const std::scoped_lock lock{mutex_};
        requests_.push_back(range);
        ++asked_;
    }
    std::optional<assets::LoadedLevels> take() override {
        const std::scoped_lock lock{mutex_};
        if (requests_.empty() || allowed_ == 0) return std::nullopt;
        --allowed_;
        const assets::LevelRange range = requests_.front();
        requests_.pop_front();
        if (range.image == broken_) return assets::LoadedLevels{range, {}};
        const auto bytes = assets::bytes_of(images_[range.image], range.first, range.end);
        return assets::LoadedLevels{range, {bytes.begin(), bytes.end()}};
    }
    bool wait() override {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [this] { return closed_ || allowed_ > 0 || requests_.empty(); });
        return !closed_ && !requests_.empty();
    }
    void close() override {
        {
            const std::scoped_lock lock{mutex_};
            closed_ = true;
        }
        changed_.notify_all();
    }

    /// Lets so many answers come, and no more.
    void allow(std::uint64_t answers) {
        {
            const std::scoped_lock lock{mutex_};
            allowed_ = answers;
        }
        changed_.notify_all();
    }
    /// The levels of this image cannot be had.
    void lose(std::uint32_t image) {
        const std::scoped_lock lock{mutex_};
        broken_ = image;
    }
    [[nodiscard]] std::uint64_t asked() {
        const std::scoped_lock lock{mutex_};
        return asked_;
    }

private:
    std::vector<assets::TextureData> images_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<assets::LevelRange> requests_;
    std::uint64_t allowed_ = ~std::uint64_t{0};
    std::uint64_t asked_ = 0;
    std::uint32_t broken_ = ~std::uint32_t{0};
    bool closed_ = false;
};

/// The images as a scene holds them whose finer levels come and go.
[[nodiscard]] inline std::vector<assets::TextureData> floors_of(std::vector<assets::TextureData> images) {
    for (assets::TextureData& image : images)
        assets::drop_levels(image, assets::floor_level(image));
    return images;
}

}  // namespace rambla::tests
