#include "assets/generate/palette.h"

#include <cmath>

#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

/// Indices of a pattern's textures in the scene.
struct TextureSet {
    std::uint32_t colour = k_none, normal = k_none, roughness = k_none, emission = k_none, height = k_none;
    float height_depth = 0.0f;
};

std::uint32_t add_texture(Scene& scene, Image image, ColourSpace space, bool clamp) {
    const std::string name = image.name;
    scene.images.push_back(std::move(image));
    Sampler sampler;
    if (clamp) sampler.wrap_u = sampler.wrap_v = WrapMode::clamp_to_edge;
    scene.textures.push_back({name, static_cast<std::uint32_t>(scene.images.size() - 1), space, sampler});
    return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

std::array<TextureSet, k_pattern_count> add_textures(Scene& scene, std::uint64_t seed) {
    std::array<TextureSet, k_pattern_count> result;
    std::vector<PaintedSet> sets = paint_all_patterns(static_cast<std::uint32_t>(scramble(seed)));
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const auto pattern = static_cast<Pattern>(i);
        const bool clamp = pattern == Pattern::leaves || pattern == Pattern::door ||
                           pattern == Pattern::cover || pattern == Pattern::signs;
        PaintedSet& set = sets[i];
        result[i].colour = add_texture(scene, std::move(set.colour), ColourSpace::srgb, clamp);
        if (set.normal)
            result[i].normal = add_texture(scene, std::move(*set.normal), ColourSpace::linear, clamp);
        if (set.roughness)
            result[i].roughness = add_texture(scene, std::move(*set.roughness), ColourSpace::linear, clamp);
        if (set.emission)
            result[i].emission = add_texture(scene, std::move(*set.emission), ColourSpace::srgb, clamp);
        if (set.relief) {
            result[i].height = add_texture(scene, std::move(set.relief->image), ColourSpace::linear, clamp);
            result[i].height_depth = set.relief->depth;
        }
    }
    return result;
}

float linear(float s) {
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

/// A linear colour from display values as painters name them.
glm::vec4 srgb(float r, float g, float b) {
    return {linear(r), linear(g), linear(b), 1.0f};
}

class Maker {
public:
    Maker(Scene& scene, std::uint64_t seed) : scene_{scene}, textures_{add_textures(scene, seed)} {}

    /// A dielectric without textures.
    std::uint32_t plain(const std::string& name, glm::vec4 colour, float roughness, float metalness = 0.0f) {
        Material material;
        material.name = name;
        material.base_colour = colour;
        material.roughness = roughness;
        material.metalness = metalness;
        return add(material);
    }
    std::uint32_t textured(const std::string& name, Pattern pattern, glm::vec4 colour, float roughness) {
        const TextureSet& set = textures_[static_cast<std::size_t>(pattern)];
        Material material;
        material.name = name;
        material.base_colour = colour;
        material.roughness = set.roughness == k_none ? roughness : 1.0f;
        // Dielectric; a roughness map's B is 0 as well.
        material.metalness = 0.0f;
        material.base_colour_texture.texture = set.colour;
        material.normal_texture.texture = set.normal;
        material.metalness_roughness_texture.texture = set.roughness;
        material.emissive_texture.texture = set.emission;
        material.height_texture.texture = set.height;
        material.height_depth = set.height_depth;
        return add(material);
    }
    std::uint32_t emitting(std::uint32_t material, glm::vec3 radiance) {
        scene_.materials[material].emissive = radiance;
        return material;
    }
    /// @param cutoff  low for thin things, or filtered alpha would eat them away in the distance
    std::uint32_t cut_out(std::uint32_t material, float cutoff) {
        scene_.materials[material].alpha_cutoff = cutoff;
        scene_.materials[material].alpha_mode = AlphaMode::mask;
        scene_.materials[material].double_sided = true;
        return material;
    }
    std::uint32_t both_sides(std::uint32_t material) {
        scene_.materials[material].double_sided = true;
        return material;
    }

private:
    std::uint32_t add(const Material& material) {
        scene_.materials.push_back(material);
        return static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

    Scene& scene_;
    std::array<TextureSet, k_pattern_count> textures_;
};

void make_ground(Maker& make, Scheme& to) {
    const glm::vec4 white{1.0f};
    const auto set = [&](Surface surface, std::uint32_t material) {
        to[static_cast<std::size_t>(surface)] = material;
    };
    set(Surface::asphalt, make.textured("asphalt", Pattern::asphalt, white, 0.85f));
    set(Surface::gutter, make.textured("gutter", Pattern::granite, srgb(0.80f, 0.79f, 0.77f), 0.85f));
    set(Surface::kerb, make.textured("kerb", Pattern::granite, white, 0.75f));
    set(Surface::paving, make.textured("paving", Pattern::paving, white, 0.8f));
    set(Surface::paint, make.cut_out(make.textured("road-paint", Pattern::paint, white, 0.7f), 0.5f));
    set(Surface::cover, make.textured("cast-iron-cover", Pattern::cover, white, 0.55f));
    set(Surface::soil, make.plain("soil", srgb(0.33f, 0.26f, 0.20f), 0.95f));
}

/// What shines by night is a tenth of noon's sunlit white, and less: beside lamps of that order, see
/// daylight(), it is as bright as in photographs. By day the same things outshine nature, or nobody would see
/// that they are on.
void make_things(Maker& make, const Evening& evening, Scheme& to) {
    const glm::vec4 white{1.0f};
    const auto set = [&](Surface surface, std::uint32_t material) {
        to[static_cast<std::size_t>(surface)] = material;
    };
    set(Surface::foliage, make.cut_out(make.textured("leaves", Pattern::leaves, white, 0.65f), 0.4f));
    set(Surface::bark, make.textured("bark", Pattern::bark, white, 0.9f));
    set(Surface::iron, make.plain("iron", srgb(0.17f, 0.17f, 0.17f), 0.5f));
    set(Surface::railing, make.cut_out(make.textured("railing", Pattern::railing, white, 0.55f), 0.25f));
    set(Surface::lantern, make.emitting(make.plain("lantern", srgb(0.92f, 0.88f, 0.78f), 0.3f),
                                        evening.between({0.55f, 0.44f, 0.27f}, {0.60f, 0.42f, 0.22f})));
    set(Surface::street_lantern, make.emitting(make.plain("street-lantern", srgb(0.92f, 0.88f, 0.78f), 0.3f),
                                               evening.between(glm::vec3{0.0f}, 0.8f * k_light_2700k)));
    set(Surface::timber, make.textured("timber", Pattern::timber, srgb(0.62f, 0.43f, 0.28f), 0.6f));
    set(Surface::sign, make.textured("signs", Pattern::signs, white, 0.45f));
    set(Surface::pane, make.textured("glass", Pattern::window, white, 0.05f));
    set(Surface::pane_lit, make.emitting(make.textured("glass-lit", Pattern::window_lit, white, 0.05f),
                                         evening.between({0.95f, 0.80f, 0.60f}, {0.24f, 0.19f, 0.13f})));
    set(Surface::pane_blue, make.emitting(make.textured("glass-blue", Pattern::window_lit, white, 0.05f),
                                          evening.between(glm::vec3{0.0f}, {0.030f, 0.060f, 0.17f})));
    set(Surface::shop_pane, make.emitting(make.textured("glass-shop", Pattern::shop, white, 0.05f),
                                          evening.between({0.42f, 0.38f, 0.32f}, {0.26f, 0.21f, 0.14f})));
    set(Surface::shop_pane_dark,
        make.emitting(make.textured("glass-shop-closed", Pattern::shop, white, 0.05f),
                      evening.between({0.42f, 0.38f, 0.32f}, {0.012f, 0.012f, 0.012f})));
    set(Surface::roof, make.textured("roof-tiles", Pattern::gravel, white, 0.9f));
    set(Surface::plain, make.textured("party-wall", Pattern::plaster, srgb(0.78f, 0.72f, 0.64f), 0.95f));
    set(Surface::car_glass, make.plain("car-glass", srgb(0.10f, 0.12f, 0.13f), 0.05f));
    set(Surface::rubber, make.plain("rubber", srgb(0.13f, 0.13f, 0.13f), 0.8f));
    set(Surface::metal, make.plain("metal", srgb(0.78f, 0.78f, 0.80f), 0.3f, 1.0f));
    set(Surface::head_lamp, make.emitting(make.plain("head-lamp", srgb(0.90f, 0.92f, 0.95f), 0.1f),
                                          evening.between(glm::vec3{0.25f}, glm::vec3{0.01f})));
    set(Surface::tail_lamp, make.plain("tail-lamp", srgb(0.62f, 0.07f, 0.06f), 0.15f));
    set(Surface::cloth, make.textured("cloth", Pattern::cloth, white, 0.85f));
    set(Surface::skin, make.plain("skin", white, 0.55f));
}

void make_buildings(Maker& make, Palette& palette) {
    constexpr std::array<std::array<float, 3>, 9> k_plasters{{{0.90f, 0.74f, 0.48f},    // ochre
                                                              {0.94f, 0.87f, 0.72f},    // cream
                                                              {0.90f, 0.74f, 0.66f},    // pale rose
                                                              {0.74f, 0.77f, 0.68f},    // grey-green
                                                              {0.81f, 0.56f, 0.43f},    // terracotta
                                                              {0.92f, 0.90f, 0.85f},    // chalk
                                                              {0.87f, 0.79f, 0.66f},    // sand
                                                              {0.76f, 0.74f, 0.71f},    // stone grey
                                                              {0.70f, 0.75f, 0.78f}}};  // faded blue
    for (std::size_t i = 0; i < k_plasters.size(); ++i) {
        const auto& c = k_plasters[i];
        palette.plasters[i] =
            make.textured("plaster-" + std::to_string(i), Pattern::plaster, srgb(c[0], c[1], c[2]), 0.92f);
    }
    palette.brick = make.textured("brick", Pattern::brick, glm::vec4{1.0f}, 0.9f);
    palette.stone = make.textured("stone", Pattern::stone, glm::vec4{1.0f}, 0.85f);
    palette.trims = {make.textured("trim-cream", Pattern::stucco, srgb(0.95f, 0.91f, 0.82f), 0.85f),
                     make.textured("trim-grey", Pattern::stucco, srgb(0.80f, 0.79f, 0.76f), 0.85f),
                     make.textured("trim-sand", Pattern::stucco, srgb(0.88f, 0.80f, 0.66f), 0.85f)};
    palette.frames = {make.plain("frame-white", srgb(0.88f, 0.87f, 0.83f), 0.45f),
                      make.plain("frame-brown", srgb(0.36f, 0.24f, 0.17f), 0.5f)};
    palette.shutters = {make.textured("shutter-green", Pattern::louvre, srgb(0.25f, 0.40f, 0.31f), 0.6f),
                        make.textured("shutter-brown", Pattern::louvre, srgb(0.48f, 0.32f, 0.21f), 0.6f),
                        make.textured("shutter-blue-grey", Pattern::louvre, srgb(0.52f, 0.60f, 0.62f), 0.6f),
                        make.textured("shutter-chalk", Pattern::louvre, srgb(0.88f, 0.86f, 0.80f), 0.6f)};
    palette.doors = {make.textured("door-brown", Pattern::door, srgb(0.46f, 0.29f, 0.18f), 0.45f),
                     make.textured("door-green", Pattern::door, srgb(0.17f, 0.32f, 0.25f), 0.45f),
                     make.textured("door-red", Pattern::door, srgb(0.46f, 0.15f, 0.12f), 0.45f)};
    palette.shop_frames = {
        make.textured("shop-frame-walnut", Pattern::timber, srgb(0.50f, 0.34f, 0.22f), 0.5f),
        make.textured("shop-frame-green", Pattern::timber, srgb(0.20f, 0.33f, 0.27f), 0.45f),
        make.textured("shop-frame-chalk", Pattern::timber, srgb(0.86f, 0.84f, 0.78f), 0.5f)};
    palette.awnings = {
        make.both_sides(make.textured("awning-striped", Pattern::fabric, glm::vec4{1.0f}, 0.9f)),
        make.both_sides(make.textured("awning-green", Pattern::stucco, srgb(0.24f, 0.42f, 0.30f), 0.9f)),
        make.both_sides(make.textured("awning-ecru", Pattern::stucco, srgb(0.93f, 0.86f, 0.72f), 0.9f))};
    constexpr std::array<std::array<float, 3>, 5> k_bodies{{{0.84f, 0.85f, 0.86f},
                                                            {0.20f, 0.21f, 0.23f},
                                                            {0.58f, 0.10f, 0.09f},
                                                            {0.16f, 0.28f, 0.45f},
                                                            {0.86f, 0.80f, 0.66f}}};
    for (std::size_t i = 0; i < k_bodies.size(); ++i) {
        const auto& c = k_bodies[i];
        palette.bodies[i] = make.plain("car-paint-" + std::to_string(i), srgb(c[0], c[1], c[2]), 0.22f);
    }
}

}  // namespace

Palette add_palette(Scene& scene, const Evening& evening, std::uint64_t seed) {
    Palette palette;
    Maker make{scene, seed};
    make_ground(make, palette.standard);
    make_things(make, evening, palette.standard);
    make_buildings(make, palette);
    const auto set = [&](Surface surface, std::uint32_t material) {
        palette.standard[static_cast<std::size_t>(surface)] = material;
    };
    set(Surface::wall, palette.plasters[0]);
    set(Surface::base, palette.stone);
    set(Surface::trim, palette.trims[0]);
    set(Surface::frame, palette.frames[0]);
    set(Surface::shutter, palette.shutters[0]);
    set(Surface::door, palette.doors[0]);
    set(Surface::awning, palette.awnings[0]);
    set(Surface::shop_frame, palette.shop_frames[0]);
    set(Surface::body, palette.bodies[0]);
    return palette;
}

std::uint32_t add_light_map(Scene& scene, Image image) {
    const std::uint32_t texture = add_texture(scene, std::move(image), ColourSpace::srgb, true);
    scene.textures[texture].sampler.mip = MipFilter::none;
    return texture;
}

Scheme building_scheme(const Palette& palette, Draws& draws, bool brick) {
    Scheme scheme = palette.standard;
    const auto set = [&](Surface surface, std::uint32_t material) {
        scheme[static_cast<std::size_t>(surface)] = material;
    };
    const auto one_of = [&](const auto& choices) {
        return choices[draws.below(static_cast<std::uint32_t>(choices.size()))];
    };
    const std::uint32_t plaster = one_of(palette.plasters);
    set(Surface::wall, brick ? palette.brick : plaster);
    set(Surface::base, brick || draws.chance(0.6f) ? palette.stone : plaster);
    set(Surface::trim, one_of(palette.trims));
    set(Surface::frame, one_of(palette.frames));
    set(Surface::shutter, one_of(palette.shutters));
    set(Surface::door, one_of(palette.doors));
    set(Surface::awning, one_of(palette.awnings));
    set(Surface::shop_frame, one_of(palette.shop_frames));
    return scheme;
}

std::vector<StoredPart> store(Scene& scene, std::vector<Builder::Part> parts) {
    std::vector<StoredPart> stored;
    for (Builder::Part& part : parts) {
        scene.meshes.push_back(std::move(part.mesh));
        stored.push_back({part.surface, static_cast<std::uint32_t>(scene.meshes.size() - 1)});
    }
    return stored;
}

std::uint32_t add_model(Scene& scene, const std::string& name, const std::vector<StoredPart>& parts,
                        const Scheme& scheme) {
    Model model{name, {}};
    for (const StoredPart& part : parts)
        model.parts.push_back({part.mesh, scheme[static_cast<std::size_t>(part.surface)]});
    scene.models.push_back(std::move(model));
    return static_cast<std::uint32_t>(scene.models.size() - 1);
}

}  // namespace rambla::assets::generate
