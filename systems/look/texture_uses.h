#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/processed.h"
#include "assets/scene.h"

namespace rambla::systems {

/// How densely an image lies on a mesh.
struct TextureUse {
    std::uint32_t image = 0;  ///< of assets::ProcessedScene::images
    /// Texels of the finest level per metre in the mesh's own space: the least, over its triangles, of the
    /// Frobenius norm of the gradient. 0: the finest level is needed, however small it is seen.
    float texels_per_m = 0.0f;
    bool cuts_out = false;  ///< it decides what of the mesh throws a shadow
};

/// Resource: which images a mesh shows with a material, as far as drawing samples them. Follows from the
/// scene; without it Frames demand nothing.
class TextureUses {
public:
    TextureUses() = default;
    /// Measures all parts of the scene's models, side by side on oneTBB.
    /// @param processed  what was made of the scene
    TextureUses(const assets::Scene& scene, const assets::ProcessedScene& processed);

    /// @return  index of a mesh with a material, below pair_count(); k_none for those of no model
    [[nodiscard]] std::uint32_t pair(std::uint32_t mesh, std::uint32_t material) const;
    [[nodiscard]] std::uint32_t pair_count() const { return static_cast<std::uint32_t>(pairs_.size()); }
    [[nodiscard]] std::span<const TextureUse> uses(std::uint32_t pair) const;
    /// The coarsest level of each image.
    [[nodiscard]] std::span<const std::uint8_t> last_levels() const { return last_levels_; }

private:
    struct Pair {
        std::uint32_t mesh = 0;
        std::uint32_t material = 0;
        std::uint32_t first_use = 0;
        std::uint32_t use_count = 0;
    };
    std::vector<Pair> pairs_;                ///< by mesh, then material
    std::vector<std::uint32_t> first_pair_;  ///< by mesh, and one more behind the last
    std::vector<TextureUse> uses_;
    std::vector<std::uint8_t> last_levels_;
};

/// Least Frobenius norm, over a mesh's triangles, of the gradient of a slot's coordinates, in texels per
/// metre. Triangles without area are never drawn and do not count; infinite if none is left.
/// @param size  texels of the finest level
[[nodiscard]] float least_texels_per_m(const assets::Mesh& mesh, const assets::TextureSlot& slot,
                                       glm::uvec2 size);

}  // namespace rambla::systems
