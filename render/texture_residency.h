#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "assets/texture_levels.h"
#include "render/gl/texture.h"
#include "render/residency_plan.h"
#include "render/settings.h"
#include "systems/feedback.h"

namespace rambla::render {

/// The images of a scene on the graphics card, of which finer levels come and go within a budget.
///
/// A texture's storage cannot change, so an image that gets finer or coarser gets a new one: the new levels
/// are uploaded, as many bytes a frame as the settings allow; those that both have are copied on the card;
/// then the new one takes the old one's place, which is deleted when the last frame that reads it is done.
/// All three, the old, the new and the half-finished one, count against the budget, always.
class TextureResidency {
public:
    /// Uploads all levels that `images` hold.
    /// @param source  of the finer levels; none: all stays as it is
    TextureResidency(std::span<const assets::TextureData> images,
                     std::shared_ptr<assets::LevelSource> source);
    ~TextureResidency();
    TextureResidency(const TextureResidency&) = delete;
    TextureResidency& operator=(const TextureResidency&) = delete;

    /// Before a frame is drawn: goes a step towards what it needs. Never waits.
    /// @param demand  Frame::texture_demand; empty: what was demanded before
    void update(std::span<const std::uint8_t> demand, const TextureParameters& parameters);
    /// As update(), but for a picture that must not depend on the speed of disks: waits for all that it needs
    /// and the budget allows.
    /// @param finish  waits until nothing submitted is being drawn, and calls release()
    void complete(std::span<const std::uint8_t> demand, const TextureParameters& parameters,
                  const std::function<void()>& finish);

    /// Deletes textures that were replaced before frame number `finished`, counted as in begin_frame().
    void release(std::uint64_t finished);
    /// What is replaced from now on is still read by frames up to this one.
    void begin_frame(std::uint64_t number) { frame_ = number; }

    /// Of the texture that holds an image now.
    [[nodiscard]] GLuint name(std::uint32_t image) const { return textures_[image].name(); }
    /// Images whose name has changed since update() or complete() was called.
    [[nodiscard]] std::span<const std::uint32_t> changed() const { return changed_; }
    [[nodiscard]] systems::TextureFeedback feedback() const;
    /// Textures that exist for a while beside the one of each image.
    [[nodiscard]] std::uint32_t passing_textures() const {
        return static_cast<std::uint32_t>(retired_.size()) + (building_ ? 1u : 0u);
    }

private:
    struct Retired {
        gl::Texture texture;
        std::uint64_t frame = 0;
    };
    /// A texture that is being filled, in order of levels and rows.
    struct Building {
        gl::Texture texture;
        assets::LoadedLevels levels;
        std::uint32_t first = 0;
        std::uint32_t level = 0;
        std::uint32_t row = 0;
        std::size_t offset = 0;  ///< of the level, in levels.bytes
    };

    void aim(std::span<const std::uint8_t> demand, const TextureParameters& parameters);
    /// @return  whether anything has moved
    bool advance(std::uint64_t upload_bytes);
    bool take_answers();
    bool coarsen();
    /// Whether a texture from level `first` on has room beside all that there is.
    [[nodiscard]] bool fits(std::uint32_t image, std::uint32_t first) const;
    /// Levels finer than its floor that pictures need.
    [[nodiscard]] int needed_levels(std::uint32_t image) const;
    void make_coarser(std::uint32_t image, std::uint32_t first);
    bool build(std::uint64_t upload_bytes);
    [[nodiscard]] bool start_building();
    [[nodiscard]] std::uint64_t upload(Building& building, std::uint64_t bytes) const;
    bool request();
    [[nodiscard]] bool is_coming(std::uint32_t image) const;
    [[nodiscard]] std::optional<std::uint32_t> most_missing() const;
    void replace(std::uint32_t image, std::uint32_t first, gl::Texture texture);
    [[nodiscard]] gl::Texture make_texture(std::uint32_t image, std::uint32_t first);
    [[nodiscard]] std::uint64_t chain_bytes(std::uint32_t image, std::uint32_t first) const {
        return plan_.images()[image].chain_bytes[first];
    }

    std::shared_ptr<assets::LevelSource> source_;
    std::vector<assets::TextureData> images_;  ///< without their bytes
    ResidencyPlan plan_;
    std::vector<gl::Texture> textures_;
    std::vector<std::uint8_t> resident_;  ///< finest level of each texture
    std::vector<std::uint8_t> finest_to_be_had_;
    std::vector<std::uint8_t> demand_;
    std::uint64_t budget_bytes_ = 0;
    bool warned_ = false;
    bool lost_ = false;  ///< some level cannot be had that the targets count on

    std::vector<assets::LevelRange> asked_;
    std::vector<assets::LoadedLevels> ready_;
    std::uint64_t staged_bytes_ = 0;  ///< asked for or ready
    std::optional<Building> building_;
    std::vector<Retired> retired_;
    std::vector<std::uint32_t> changed_;

    std::uint64_t frame_ = 0;
    std::uint64_t held_bytes_ = 0;  ///< of all textures above
    std::uint64_t peak_bytes_ = 0;
    std::uint64_t loads_ = 0;
};

}  // namespace rambla::render
