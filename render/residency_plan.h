#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rambla::render {

/// What never changes of an image whose levels come and go. Level 0 is the finest.
struct ImageLevels {
    std::uint8_t floor = 0;  ///< this level and all coarser ones are always resident
    /// The coarsest level that is half of the finest in exact powers of two. From there on, texture
    /// coordinates of a copy without finer levels are rounded otherwise, and pictures differ in the last bit.
    std::uint8_t exact = 0;
    std::vector<std::uint64_t> chain_bytes;  ///< by level, down to the floor: of it and all coarser ones
};

/// Chooses which level of each image is to be the finest resident one, for a budget in bytes.
///
/// All images have their floor. What is left is spent on what pictures need, a level at a time: first where
/// most levels are missing, among equals where the level is resident already, then where it is cheapest.
/// What is left then keeps levels that nobody needs any more, those that were needed last before others.
/// Room is left for a texture beside the one that it replaces: see limit().
///
/// The same calls give the same targets. As long as the demand stays, so do the targets once they are
/// resident, and a demand that comes back within k_hold_frames has not been forgotten: nothing flickers.
class ResidencyPlan {
public:
    /// Demands are remembered that long: what is seen every other frame is needed.
    static constexpr std::uint64_t k_hold_frames = 16;

    ResidencyPlan() = default;
    explicit ResidencyPlan(std::vector<ImageLevels> images);

    /// Chooses the targets, once per frame.
    /// @param demand    finest level needed, or systems::k_not_demanded; one for each image
    /// @param resident  finest level that is resident, one for each image; not coarser than its floor
    /// @param to_be_had  finest level that can be loaded, one for each image: finer ones get no room
    void aim(std::span<const std::uint8_t> demand, std::span<const std::uint8_t> resident,
             std::span<const std::uint8_t> to_be_had, std::uint64_t budget_bytes);

    [[nodiscard]] std::span<const ImageLevels> images() const { return images_; }
    [[nodiscard]] std::span<const std::uint8_t> targets() const { return targets_; }
    /// Finest level of each image that is needed, or was within k_hold_frames, and can be had; else its
    /// floor.
    [[nodiscard]] std::span<const std::uint8_t> needed() const { return needed_; }
    [[nodiscard]] std::uint64_t floor_bytes() const { return floor_bytes_; }
    /// Most that a texture which makes others finer may lead to: the rest of a budget lets any image return
    /// to its floor.
    [[nodiscard]] std::uint64_t limit(std::uint64_t budget_bytes) const;

private:
    struct Candidate {
        std::uint32_t image = 0;
        std::int32_t missing = 0;  ///< levels from its target to what is needed; ≤ 0: only exactness is
        bool resident = false;     ///< the next finer level is
        std::uint64_t cost = 0;    ///< bytes that this level adds
    };
    [[nodiscard]] static bool is_less_urgent(const Candidate& a, const Candidate& b);
    [[nodiscard]] Candidate candidate(std::uint32_t image, std::span<const std::uint8_t> resident) const;
    void remember(std::span<const std::uint8_t> demand, std::span<const std::uint8_t> to_be_had);
    void refine(std::span<const std::uint8_t> resident);
    void keep_unneeded(std::span<const std::uint8_t> resident);
    /// Takes `target` for an image if it fits.
    bool take(std::uint32_t image, std::uint8_t target, std::span<const std::uint8_t> resident);
    [[nodiscard]] std::uint64_t& needed_at(std::uint32_t image, std::uint8_t level) {
        return needed_at_[first_stamp_[image] + level];
    }

    std::vector<ImageLevels> images_;
    std::uint64_t floor_bytes_ = 0;
    std::uint64_t reserve_bytes_ = 0;  ///< the largest floor
    std::uint64_t now_ = 0;
    std::vector<std::uint32_t> first_stamp_;
    std::vector<std::uint64_t> needed_at_;  ///< by image and level: the last frame that needed it; 0: none
    std::vector<std::uint8_t> needed_;
    std::vector<std::uint8_t> wanted_;  ///< as needed_, or finer for exactness
    std::vector<std::uint8_t> targets_;

    // Of one aim():
    std::uint64_t room_bytes_ = 0;      ///< what targets may take together
    std::uint64_t target_bytes_ = 0;    ///< what they take
    std::uint64_t replaced_bytes_ = 0;  ///< most that one of them will lie beside while it replaces it
    std::vector<Candidate> queue_;
    std::vector<std::uint32_t> kept_;
};

}  // namespace rambla::render
