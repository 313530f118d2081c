// What processing makes of a scene, as it is drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/support.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::only_sun;
using tests::Picture;
using tests::Stage;

/// Mip levels of one colour each: red, green, blue, then grey.
assets::TextureData coloured_levels(std::uint32_t side) {
    assets::TextureData texture;
    texture.name = "levels";
    for (std::uint32_t size = side; size > 0; size /= 2) {
        const std::size_t channel = texture.levels.size();
        texture.levels.push_back({.width = size,
                                  .height = size,
                                  .offset = texture.bytes.size(),
                                  .size = std::size_t{4} * size * size,
                                  .rms_error = 0.0f});
        for (std::uint32_t i = 0; i < size * size; ++i)
            for (std::size_t c = 0; c < 4; ++c)
                texture.bytes.push_back(
                    std::byte{c == 3 || channel > 2 || c == channel ? std::uint8_t{255} : std::uint8_t{0}});
    }
    return texture;
}

TEST(ProcessedTextures, AreDrawnWithTheMipLevelsThatTheyHave) {
    constexpr std::uint32_t k_side = 64;
    Stage stage;
    assets::Material m = matte();
    m.unlit = true;
    m.base_colour_texture = stage.texture(k_side, k_side, std::vector<glm::u8vec4>(k_side * k_side));
    stage.scene.textures[0].sampler.mip = assets::MipFilter::nearest;
    stage.place(stage.square(), stage.material(m));
    stage.process = [](const assets::Scene& scene) {
        auto processed = std::make_shared<assets::ProcessedScene>(*tests::quick_process(scene));
        processed->images.at(0) = coloured_levels(k_side);
        return processed;
    };
    const glm::uvec2 size = stage.frame.view.size_px;
    for (const int level : {0, 1, 2}) {
        // The square's two metres take k_side >> level pixels.
        const float pixels_per_m = static_cast<float>(k_side >> level) / 2.0f;
        stage.look_flat({0, 0, 5}, {0, 0, 0}, static_cast<float>(size.y) / 2.0f / pixels_per_m, {0, 1, 0});
        const glm::vec3 middle = stage.draw().radiance(size.x / 2 + 2, size.y / 2 + 2);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(middle[c], c == level ? 1.0f : 0.0f, 1e-2f) << "level " << level << " channel " << c;
    }
}

/// A lit square with noise of every kind in its textures, which vary slowly enough for blocks.
void add_textured_square(Stage& stage, assets::AlphaMode alpha) {
    constexpr std::uint32_t k_side = 64;
    const auto waves = [](float scale_x, float scale_y, float phase) {
        return [=](std::uint32_t i) {
            const auto x = static_cast<float>(i % k_side);
            const auto y = static_cast<float>(i / k_side);
            return 0.5f + 0.4f * std::sin(scale_x * x + scale_y * y + phase);
        };
    };
    const auto byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(255.0f * share));
    };
    const auto r = waves(0.2f, 0.1f, 0.0f);
    const auto g = waves(-0.1f, 0.25f, 1.0f);
    std::vector<glm::u8vec4> colours, surfaces, normals;
    for (std::uint32_t i = 0; i < k_side * k_side; ++i) {
        const bool gap = alpha != assets::AlphaMode::opaque && i % k_side < 16;
        colours.emplace_back(byte(r(i)), byte(r(i)), byte(0.9f * r(i)), gap ? 0 : 255);
        surfaces.emplace_back(0, byte(g(i)), byte(0.2f * r(i)), 255);
        const glm::vec3 n = glm::normalize(glm::vec3{r(i) - 0.5f, g(i) - 0.5f, 0.3f});
        normals.emplace_back(byte(0.5f + 0.5f * n.x), byte(0.5f + 0.5f * n.y), byte(0.5f + 0.5f * n.z), 255);
    }
    assets::Material m = matte();
    m.alpha_mode = alpha;
    m.metalness = 1.0f;
    m.base_colour_texture = stage.texture(k_side, k_side, colours, assets::ColourSpace::srgb);
    m.metalness_roughness_texture = stage.texture(k_side, k_side, surfaces);
    m.normal_texture = stage.texture(k_side, k_side, normals);
    stage.place(stage.square(), stage.material(m));
}

double mean_difference(const Picture& a, const Picture& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.linear.size(); ++i)
        sum += glm::length(glm::vec3{a.linear[i] - b.linear[i]});
    return sum / static_cast<double>(a.linear.size());
}

TEST(ProcessedTextures, OfBlocksAreDrawnAsTheTexelsThatTheyWereMadeOf) {
    for (const assets::AlphaMode alpha : {assets::AlphaMode::opaque, assets::AlphaMode::mask}) {
        Stage stage;
        add_textured_square(stage, alpha);
        stage.look_flat({0, 0, 5}, {0, 0, 0}, 1.0f);
        stage.frame.environment = only_sun({0.3f, 0.5f, 1});
        const Picture plain = stage.draw();
        std::shared_ptr<assets::ProcessedScene> processed;
        stage.process = [&](const assets::Scene& scene) {
            assets::ProcessParameters parameters;
            parameters.textures.compression = assets::Compression::good;
            processed = std::make_shared<assets::ProcessedScene>(assets::process(scene, parameters));
            return processed;
        };
        const Picture blocks = stage.draw();
        std::vector<assets::TexelFormat> formats;
        for (const assets::TextureData& image : processed->images)
            formats.push_back(image.format);
        std::sort(formats.begin(), formats.end());
        using enum assets::TexelFormat;
        const std::vector<assets::TexelFormat> expected{alpha == assets::AlphaMode::mask ? bc3 : bc1, bc5,
                                                        bc5};
        EXPECT_EQ(formats, expected);
        // Blocks keep 5 or 6 bits of each colour: errors of one or two hundredths of white are theirs.
        EXPECT_LT(mean_difference(plain, blocks), 0.02);
        // And each part of what makes them right matters.
        const auto difference_with = [&](auto&& change) {
            stage.process = [&](const assets::Scene&) {
                auto changed = std::make_shared<assets::ProcessedScene>(*processed);
                change(*changed);
                return changed;
            };
            return mean_difference(plain, stage.draw());
        };
        EXPECT_GT(difference_with([](assets::ProcessedScene& scene) {
                      for (assets::TextureData& image : scene.images)
                          image.normal_map = false;
                  }),
                  0.04)
            << "z is not 1";
        EXPECT_GT(difference_with([](assets::ProcessedScene& scene) {
                      for (assets::TextureData& image : scene.images)
                          if (!image.normal_map) image.swizzle = assets::k_no_swizzle;
                  }),
                  0.04)
            << "roughness and metalness lie in red and green";
    }
}

/// A floor seen from above, and a board over it that the sun shines past.
struct Shade {
    explicit Shade(assets::AlphaMode alpha) {
        stage.look_flat({0, 30, 0}, {0, 0, 0}, 10.0f, {0, 0, -1});
        const glm::mat4 flat = glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0});
        stage.place(stage.square(), stage.material(matte()),
                    flat * glm::scale(glm::mat4{1.0f}, glm::vec3{9.0f}));
        assets::Material m = matte();
        m.alpha_mode = alpha;
        stage.place(stage.square(), stage.material(m), glm::translate(glm::mat4{1.0f}, {0, 2, 0}) * flat);
        stage.frame.environment = only_sun({-2, 1, 0});
        stage.settings.shadows.size_texels = 512;
    }
    /// Where the board's shadow falls, as a share of the lit floor.
    float shadow() {
        const Picture picture = stage.draw();
        const auto at = [&](float x) {
            return picture
                .radiance(static_cast<std::uint32_t>((x + 10.0f) * 0.05f * picture.size.x),
                          picture.size.y / 2 + 2)
                .x;
        };
        return at(4.0f) / at(-6.0f);
    }
    Stage stage;
};

TEST(ProcessedMeshes, OpaqueOnesCastTheirShadowMeshesAndMaskedOnesThemselves) {
    const auto without_shadow_meshes = [](const assets::Scene& scene) {
        auto processed = std::make_shared<assets::ProcessedScene>(*tests::quick_process(scene));
        for (assets::ProcessedMesh& mesh : processed->meshes)
            mesh.shadow.levels[0].count = 0;
        return processed;
    };
    for (const assets::AlphaMode alpha : {assets::AlphaMode::opaque, assets::AlphaMode::mask}) {
        Shade shade{alpha};
        EXPECT_NEAR(shade.shadow(), 0.0f, 1e-3f);
        shade.stage.process = without_shadow_meshes;
        EXPECT_NEAR(shade.shadow(), alpha == assets::AlphaMode::opaque ? 1.0f : 0.0f, 1e-3f);
    }
}

}  // namespace
