#include "assets/process/texture_plan.h"

#include <cmath>
#include <map>
#include <utility>

namespace rambla::assets {

namespace {

bool same_coordinates(const TextureSlot& a, const TextureSlot& b) {
    return a.uv_set == b.uv_set && a.offset == b.offset && a.scale == b.scale &&
           a.rotation_rad == b.rotation_rad;
}

/// The texture's own share of the alpha test, which the material's factor takes part in.
TextureJob base_colour_job(const Material& material, TextureJob job) {
    job.role = TextureRole::colour;
    if (material.alpha_mode == AlphaMode::opaque) return job;
    job.alpha = AlphaUse::blended;
    const float cutoff = material.alpha_cutoff / material.base_colour.w;
    // Beyond these limits all texels pass the test, or none, whatever their alpha is.
    if (material.alpha_mode == AlphaMode::mask && cutoff > 0.0f && cutoff <= 1.0f) {
        job.alpha = AlphaUse::tested;
        job.cutoff = cutoff;
    }
    return job;
}

class Planner {
public:
    explicit Planner(const Scene& scene) : scene_{scene} { plan_.materials = scene.materials; }

    TexturePlan run() {
        for (Material& material : plan_.materials)
            plan_material(material);
        return std::move(plan_);
    }

private:
    void plan_material(Material& material) {
        const Material before = material;
        const ChannelMask alpha = material.alpha_mode == AlphaMode::opaque ? ChannelMask{0} : k_alpha;
        constexpr ChannelMask k_rgb = k_red | k_green | k_blue;
        use(material.base_colour_texture, base_colour_job(before, job_of(before.base_colour_texture)),
            static_cast<ChannelMask>(k_rgb | alpha));
        use(material.emissive_texture, as(TextureRole::colour, before.emissive_texture), k_rgb);
        use(material.specular_colour_texture, as(TextureRole::colour, before.specular_colour_texture), k_rgb);
        use(material.normal_texture, as(TextureRole::normals, before.normal_texture), k_red | k_green);
        use(material.specular_texture, as(TextureRole::data, before.specular_texture), k_alpha);
        if (!transmits(before)) material.transmission_texture.texture = k_none;
        use(material.transmission_texture, as(TextureRole::data, before.transmission_texture), k_red);
        use(material.height_texture, as(TextureRole::data, before.height_texture), k_red);
        use(material.light_map_texture, as(TextureRole::light, before.light_map_texture), k_rgb);
        plan_roughness(material, before);
    }

    void plan_roughness(Material& material, const Material& before) {
        const TextureSlot& surface = before.metalness_roughness_texture;
        const TextureSlot& normals = before.normal_texture;
        TextureJob job = as(TextureRole::data, surface);
        const bool alone = surface.texture == k_none;
        const bool widened = usable(normals) &&
                             (alone || (bytes(surface) && same_coordinates(surface, normals))) &&
                             bytes(normals);
        if (widened) {
            job = {.image = job.image,
                   .normals = job_of(normals).image,
                   .role = TextureRole::roughness,
                   .roughness = before.roughness,
                   .normal_scale = before.normal_scale};
            material.roughness = 1.0f;
            if (alone) {
                // Ones in metalness leave the factor as it is.
                material.metalness_roughness_texture = normals;
                use(material.metalness_roughness_texture, job, k_green);
            }
        }
        if (!alone) use(material.metalness_roughness_texture, job, k_green | k_blue);
        // Occlusion mostly lies in the same picture: then it comes from the same texture too.
        const bool shared = !alone && before.occlusion_texture.texture == surface.texture;
        use(material.occlusion_texture, shared ? job : as(TextureRole::data, before.occlusion_texture),
            k_red);
    }

    [[nodiscard]] bool usable(const TextureSlot& slot) const {
        return slot.texture != k_none && scene_.textures[slot.texture].image != k_none;
    }

    [[nodiscard]] bool bytes(const TextureSlot& slot) const {
        return usable(slot) &&
               scene_.images[scene_.textures[slot.texture].image].format == PixelFormat::rgba8;
    }

    [[nodiscard]] TextureJob job_of(const TextureSlot& slot) const {
        if (slot.texture == k_none) return {};
        const Texture& texture = scene_.textures[slot.texture];
        return {.image = texture.image, .colour_space = texture.colour_space};
    }

    [[nodiscard]] TextureJob as(TextureRole role, const TextureSlot& slot) const {
        TextureJob job = job_of(slot);
        job.role = role;
        return job;
    }

    /// Lets a slot refer to the job's texture, if it refers to anything.
    void use(TextureSlot& slot, const TextureJob& job, ChannelMask channels) {
        if (slot.texture == k_none) return;
        const Texture& source = scene_.textures[slot.texture];
        if (source.image == k_none) {
            slot.texture = k_none;
            return;
        }
        const auto [job_place, job_is_new] =
            jobs_.try_emplace(job, static_cast<std::uint32_t>(plan_.jobs.size()));
        if (job_is_new) {
            plan_.jobs.push_back(job);
            plan_.channels.push_back(0);
        }
        plan_.channels[job_place->second] |= channels;
        // One texture for each texture of the scene and each use of its picture.
        const auto [place, is_new] = textures_.try_emplace(std::pair{slot.texture, job_place->second},
                                                           static_cast<std::uint32_t>(plan_.textures.size()));
        if (is_new)
            plan_.textures.push_back({.name = source.name,
                                      .image = job_place->second,
                                      .colour_space = job.colour_space,
                                      .sampler = source.sampler});
        slot.texture = place->second;
    }

    const Scene& scene_;
    TexturePlan plan_;
    std::map<TextureJob, std::uint32_t> jobs_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> textures_;
};

}  // namespace

TexturePlan plan_textures(const Scene& scene) {
    return Planner{scene}.run();
}

}  // namespace rambla::assets
