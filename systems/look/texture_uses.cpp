#include "systems/look/texture_uses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace rambla::systems {
namespace {

/// ‖T·J‖² of a triangle's uv gradient J and a slot's transform T is linear in the entries of J·Jᵀ.
struct GradientWeights {
    double uu = 0.0;  ///< of |∇u|²
    double vv = 0.0;  ///< of |∇v|²
    double uv = 0.0;  ///< of ∇u·∇v
};

/// T = size · R · S with R = [cos sin; −sin cos], as KHR_texture_transform has it.
GradientWeights weights_of(const assets::TextureSlot& slot, glm::uvec2 size) {
    const glm::dvec2 texels{size};
    const glm::dvec2 scale{slot.scale};
    const double c = std::cos(static_cast<double>(slot.rotation_rad));
    const double s = std::sin(static_cast<double>(slot.rotation_rad));
    const glm::dvec2 of_u{texels.x * c * scale.x, -texels.y * s * scale.x};
    const glm::dvec2 of_v{texels.x * s * scale.y, texels.y * c * scale.y};
    return {glm::dot(of_u, of_u), glm::dot(of_v, of_v), 2.0 * glm::dot(of_u, of_v)};
}

/// ‖T·J‖² of one triangle, in texels²/m². J·Jᵀ = D·M⁻¹·Dᵀ, where D holds how u and v change along two edges
/// and M the edges' products. Negative for a triangle without area.
double squared_gradient(const assets::Mesh& mesh, const std::vector<glm::vec2>& uv, std::size_t first,
                        const GradientWeights& weights) {
    const std::array<std::uint32_t, 3> at{mesh.indices[first], mesh.indices[first + 1],
                                          mesh.indices[first + 2]};
    const glm::dvec3 origin{mesh.positions[at[0]]};
    const glm::dvec3 a = glm::dvec3{mesh.positions[at[1]]} - origin;
    const glm::dvec3 b = glm::dvec3{mesh.positions[at[2]]} - origin;
    const glm::dvec3 normal = glm::cross(a, b);
    const double area2 = glm::dot(normal, normal);
    if (!(area2 > 0.0)) return -1.0;
    const glm::dvec2 along_a = glm::dvec2{uv[at[1]]} - glm::dvec2{uv[at[0]]};
    const glm::dvec2 along_b = glm::dvec2{uv[at[2]]} - glm::dvec2{uv[at[0]]};
    const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b);
    // Entry (i, j) of D·M⁻¹·Dᵀ, with M⁻¹ = [bb −ab; −ab aa]/area².
    const auto entry = [&](glm::length_t i, glm::length_t j) {
        return along_a[i] * (bb * along_a[j] - ab * along_b[j]) +
               along_b[i] * (aa * along_b[j] - ab * along_a[j]);
    };
    const double sum = weights.uu * entry(0, 0) + weights.vv * entry(1, 1) + weights.uv * entry(0, 1);
    return sum > 0.0 ? sum / area2 : 0.0;  // rounding, or no number at all
}

/// What of a sampler makes it read finer levels than the gradient calls for.
float sharpening(const assets::Sampler& sampler) {
    if (sampler.mip == assets::MipFilter::none) return 0.0f;  // the finest level, always
    // Here OpenGL magnifies up to a level of detail of ½, where the finest level held must not be yet.
    const bool magnifies_early =
        sampler.minify == assets::Filter::nearest && sampler.magnify == assets::Filter::linear;
    return magnifies_early ? 0.5f : 1.0f;
}

/// The slots that shaders sample.
std::array<const assets::TextureSlot*, 10> sampled_slots(const assets::Material& material) {
    return {&material.base_colour_texture,     &material.metalness_roughness_texture,
            &material.normal_texture,          &material.occlusion_texture,
            &material.emissive_texture,        &material.specular_texture,
            &material.specular_colour_texture, &material.height_texture,
            &material.transmission_texture,    &material.light_map_texture};
}

}  // namespace

float least_texels_per_m(const assets::Mesh& mesh, const assets::TextureSlot& slot, glm::uvec2 size) {
    const std::vector<glm::vec2>& uv = slot.uv_set == 0 ? mesh.uv0 : mesh.uv1;
    // Without coordinates every pixel reads the same texel; points, and lines across, know no gradient.
    if (uv.empty() || mesh.topology != assets::Topology::triangles) return 0.0f;
    const GradientWeights weights = weights_of(slot, size);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const double squared = squared_gradient(mesh, uv, first, weights);
        if (squared >= 0.0) least = std::min(least, squared);
    }
    return static_cast<float>(std::sqrt(least));
}

TextureUses::TextureUses(const assets::Scene& scene, const assets::ProcessedScene& processed) {
    for (const assets::TextureData& image : processed.images)
        last_levels_.push_back(static_cast<std::uint8_t>(image.levels.size() - 1));

    for (const assets::Model& model : scene.models) {
        for (const assets::ModelPart& part : model.parts) {
            if (part.mesh < processed.meshes.size()) pairs_.push_back({part.mesh, part.material, 0, 0});
        }
    }
    const auto order = [](const Pair& pair) {
        return std::pair{pair.mesh, pair.material};
    };
    std::sort(pairs_.begin(), pairs_.end(),
              [&](const Pair& a, const Pair& b) { return order(a) < order(b); });
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end(),
                             [&](const Pair& a, const Pair& b) { return order(a) == order(b); }),
                 pairs_.end());
    first_pair_.assign(processed.meshes.size() + 1, 0);
    for (const Pair& pair : pairs_)
        ++first_pair_[pair.mesh + 1];
    for (std::size_t mesh = 1; mesh < first_pair_.size(); ++mesh)
        first_pair_[mesh] += first_pair_[mesh - 1];

    std::vector<const assets::TextureSlot*> slots;  // by use
    std::vector<std::uint32_t> meshes;
    for (Pair& pair : pairs_) {
        pair.first_use = static_cast<std::uint32_t>(uses_.size());
        if (pair.material >= processed.materials.size()) continue;
        const assets::Material& material = processed.materials[pair.material];
        for (const assets::TextureSlot* const slot : sampled_slots(material)) {
            if (slot->texture >= processed.textures.size()) continue;
            const bool cuts_out =
                slot == &material.base_colour_texture && material.alpha_mode == assets::AlphaMode::mask;
            uses_.push_back({processed.textures[slot->texture].image, 0.0f, cuts_out});
            slots.push_back(slot);
            meshes.push_back(pair.mesh);
        }
        pair.use_count = static_cast<std::uint32_t>(uses_.size()) - pair.first_use;
    }
    tbb::parallel_for(std::size_t{0}, uses_.size(), [&](std::size_t i) {
        const assets::TextureLevel& finest = processed.images[uses_[i].image].levels[0];
        const float sharp = sharpening(processed.textures[slots[i]->texture].sampler);
        if (sharp == 0.0f) return;
        uses_[i].texels_per_m = sharp * least_texels_per_m(processed.meshes[meshes[i]].mesh, *slots[i],
                                                           {finest.width, finest.height});
    });
}

std::uint32_t TextureUses::pair(std::uint32_t mesh, std::uint32_t material) const {
    if (first_pair_.empty() || mesh >= first_pair_.size() - 1) return assets::k_none;
    for (std::uint32_t i = first_pair_[mesh]; i < first_pair_[mesh + 1]; ++i) {
        if (pairs_[i].material == material) return i;
    }
    return assets::k_none;
}

std::span<const TextureUse> TextureUses::uses(std::uint32_t pair) const {
    return std::span{uses_}.subspan(pairs_[pair].first_use, pairs_[pair].use_count);
}

}  // namespace rambla::systems
