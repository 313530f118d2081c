#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "assets/process/compress.h"
#include "unit/assets/trace_support.h"

namespace rambla::assets::test {
namespace {

/// Bytes of one channel of a picture, row 0 first; others are 7.
Image picture(std::uint32_t width, std::uint32_t height, const std::vector<int>& values,
              std::size_t channel = 3) {
    Image image;
    image.width = width;
    image.height = height;
    image.texels.assign(4 * values.size(), std::byte{7});
    for (std::size_t i = 0; i < values.size(); ++i)
        image.texels[4 * i + channel] = static_cast<std::byte>(values[i]);
    return image;
}

/// A texture of 4×4 texels or, of floats, of one.
TextureData stored(TexelFormat format, std::vector<std::byte> bytes) {
    const std::uint32_t side = format == TexelFormat::rgba32f ? 1 : 4;
    TextureData data;
    data.format = format;
    data.levels = {{side, side, 0, bytes.size(), 0.0f}};
    data.bytes = std::move(bytes);
    return data;
}

constexpr Sampler k_nearest{.magnify = Filter::nearest, .minify = Filter::nearest, .mip = MipFilter::none};

TEST(AlphaTexture, TexelsLieWhereImagesHaveThem) {
    const AlphaTexture texture = alpha_texture(picture(2, 2, {0, 51, 102, 255}), k_nearest);
    EXPECT_FLOAT_EQ(static_cast<float>(sampled_alpha(texture, {0.25, 0.25})), 0.0f);
    EXPECT_FLOAT_EQ(static_cast<float>(sampled_alpha(texture, {0.75, 0.25})), 0.2f);
    EXPECT_FLOAT_EQ(static_cast<float>(sampled_alpha(texture, {0.25, 0.75})), 0.4f);
    EXPECT_FLOAT_EQ(static_cast<float>(sampled_alpha(texture, {0.99, 0.51})), 1.0f);
}

TEST(AlphaTexture, WrapsLikeASampler) {
    Sampler sampler = k_nearest;
    const Image row = picture(4, 1, {0, 51, 102, 255});
    const auto at = [&](WrapMode mode, double u) {
        sampler.wrap_u = mode;
        return static_cast<int>(std::lround(255.0 * sampled_alpha(alpha_texture(row, sampler), {u, 0.5})));
    };
    EXPECT_EQ(at(WrapMode::repeat, 1.3), 51);
    EXPECT_EQ(at(WrapMode::repeat, -0.1), 255);
    EXPECT_EQ(at(WrapMode::repeat, -7.1), 255);
    EXPECT_EQ(at(WrapMode::mirrored_repeat, 1.1), 255);
    EXPECT_EQ(at(WrapMode::mirrored_repeat, 1.4), 102);
    EXPECT_EQ(at(WrapMode::mirrored_repeat, -0.3), 51);
    EXPECT_EQ(at(WrapMode::mirrored_repeat, 2.3), 51);
    EXPECT_EQ(at(WrapMode::clamp_to_edge, 3.0), 255);
    EXPECT_EQ(at(WrapMode::clamp_to_edge, -3.0), 0);
    EXPECT_EQ(at(WrapMode::repeat, 1e300), at(WrapMode::repeat, 1e300)) << "no trap, whatever it is";
}

TEST(AlphaTexture, IsFilteredBetweenTexelCentres) {
    const AlphaTexture texture = alpha_texture(picture(2, 2, {0, 255, 0, 255}), {});
    EXPECT_NEAR(sampled_alpha(texture, {0.25, 0.6}), 0.0, 1e-6);
    EXPECT_NEAR(sampled_alpha(texture, {0.5, 0.6}), 0.5, 1e-6);
    EXPECT_NEAR(sampled_alpha(texture, {0.625, 0.6}), 0.75, 1e-6);
    EXPECT_NEAR(sampled_alpha(texture, {1.0, 0.6}), 0.5, 1e-6) << "repeats";
}

TEST(AlphaTexture, FootprintsChooseLevels) {
    AlphaTexture texture = alpha_texture(picture(4, 4, std::vector<int>(16, 0)), {});
    texture.levels.push_back({2, 2, std::vector<float>(4, 0.25f)});
    texture.levels.push_back({1, 1, {1.0f}});
    const auto at = [&](double texels) {
        return sampled_alpha(texture, {0.3, 0.3}, texels);
    };
    EXPECT_EQ(at(0.0), 0.0);
    EXPECT_EQ(at(1.0), 0.0);
    EXPECT_NEAR(at(std::sqrt(2.0)), 0.125, 1e-12);
    EXPECT_NEAR(at(2.0), 0.25, 1e-12);
    EXPECT_NEAR(at(4.0), 1.0, 1e-12);
    EXPECT_NEAR(at(1e9), 1.0, 1e-12);
    EXPECT_NEAR(at(std::numeric_limits<double>::infinity()), 1.0, 1e-12);
    texture.sampler.mip = MipFilter::nearest;
    EXPECT_NEAR(at(1.4), 0.0, 1e-12);
    EXPECT_NEAR(at(1.5), 0.25, 1e-12);
    texture.sampler.mip = MipFilter::none;
    EXPECT_NEAR(at(1e9), 0.0, 1e-12);
}

TEST(AlphaTexture, IsReadFromBlocksAndThroughSwizzles) {
    const Image image = picture(4, 4, {0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255});
    TextureData data =
        stored(TexelFormat::bc3, compressed(image, TexelFormat::bc3, CompressionEffort::good).bytes);
    EXPECT_NEAR(sampled_alpha(alpha_texture(data, k_nearest), {0.1, 0.1}), 0.0, 1e-6);
    EXPECT_NEAR(sampled_alpha(alpha_texture(data, k_nearest), {0.9, 0.1}), 1.0, 1e-6);

    const Image red = picture(4, 4, {0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255}, 0);
    data = stored(TexelFormat::bc4, compressed(red, TexelFormat::bc4, CompressionEffort::good).bytes);
    data.swizzle[3] = ChannelSource::red;
    EXPECT_NEAR(sampled_alpha(alpha_texture(data, k_nearest), {0.1, 0.1}), 0.0, 1e-6);
    data.swizzle[3] = ChannelSource::one;
    EXPECT_NEAR(sampled_alpha(alpha_texture(data, k_nearest), {0.1, 0.1}), 1.0, 1e-6);
    data.swizzle[3] = ChannelSource::zero;
    EXPECT_NEAR(sampled_alpha(alpha_texture(data, k_nearest), {0.9, 0.1}), 0.0, 1e-6);

    const std::array<float, 4> texel{0.1f, 0.2f, 0.3f, 0.4f};
    std::vector<std::byte> bytes(sizeof(texel));
    std::memcpy(bytes.data(), texel.data(), sizeof(texel));
    const TextureData floats = stored(TexelFormat::rgba32f, std::move(bytes));
    EXPECT_FLOAT_EQ(static_cast<float>(sampled_alpha(alpha_texture(floats, k_nearest), {0.1, 0.1})), 0.4f);
}

TEST(AlphaTexture, WhatIsMissingIsRefused) {
    TextureData data = stored(TexelFormat::rgba8, std::vector<std::byte>(64));
    EXPECT_NO_THROW(static_cast<void>(alpha_texture(data, {})));
    data.levels.push_back({2, 2, 0, 16, 0.0f});
    data.first_stored = 1;
    EXPECT_THROW(static_cast<void>(alpha_texture(data, {})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(alpha_texture(TextureData{}, {})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(alpha_texture(Image{}, {})), std::invalid_argument);
    Image image = picture(2, 2, {0, 0, 0, 0});
    image.texels.pop_back();
    EXPECT_THROW(static_cast<void>(alpha_texture(image, {})), std::invalid_argument);
}

// By the matrices of KHR_texture_transform: T · R · S, R = [cos sin; −sin cos].
TEST(AlphaTexture, CoordinatesAreTransformedAsTheExtensionSays) {
    TextureSlot slot{.offset = {0.5f, 0.25f}, .scale = {2.0f, 4.0f}, .rotation_rad = 0.3f};
    const double c = std::cos(static_cast<double>(0.3f)), s = std::sin(static_cast<double>(0.3f));
    const glm::dvec2 uv = transformed_uv(slot, {0.1, 0.2});
    EXPECT_NEAR(uv.x, c * 0.2 + s * 0.8 + 0.5, 1e-12);
    EXPECT_NEAR(uv.y, -s * 0.2 + c * 0.8 + 0.25, 1e-12);
}

/// A square with holes: transparent where u < ½.
TracedWorld half_square(TraceMaterial material = {}) {
    TracedWorld world;
    world.scene.textures.push_back(alpha_texture(picture(2, 1, {100, 200}), k_nearest));
    material.masked = true;
    material.texture = 0;
    world.place(facing_square(), moved({0, 0, -1}), world.material(material));
    world.place(facing_square(), moved({0, 0, -2}));
    return world;
}

std::uint32_t seen_at(const TracedWorld& world, double x) {
    const Tracer tracer{world.scene};
    const TraceRay ray{.origin_m = {x, 0.3, 0}, .t_max = 1.5};
    EXPECT_EQ(tracer.first_hit(ray).has_value(), tracer.is_stopped(ray));
    return tracer.first_hit({.origin_m = {x, 0.3, 0}})->instance;
}

TEST(TraceMask, HolesLetRaysThrough) {
    EXPECT_EQ(seen_at(half_square(), -0.3), 1u);
    EXPECT_EQ(seen_at(half_square(), 0.3), 0u);
    EXPECT_EQ(seen_at(half_square({.cutoff = 0.3f}), -0.3), 0u);
    EXPECT_EQ(seen_at(half_square({.cutoff = 0.9f}), 0.3), 1u);
    TracedWorld opaque = half_square();
    opaque.scene.materials[0].masked = false;
    EXPECT_EQ(seen_at(opaque, -0.3), 0u);
}

TEST(TraceMask, FactorsAndVertexColoursMultiply) {
    EXPECT_EQ(seen_at(half_square({.alpha = 0.5f}), 0.3), 1u) << "200/255 · 0.5 is below the cutoff";
    EXPECT_EQ(seen_at(half_square({.alpha = 1.5f}), -0.3), 0u) << "100/255 · 1.5 is not";
    TracedWorld world = half_square();
    Mesh coloured = facing_square();
    coloured.colours = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};  // alpha is (1 + x)/2
    world.scene.instances[0].mesh = world.mesh(std::move(coloured));
    EXPECT_EQ(seen_at(world, 0.2), 1u) << "200/255 · 0.6 is below the cutoff";
    EXPECT_EQ(seen_at(world, 0.4), 0u) << "200/255 · 0.7 is not";
}

TEST(TraceMask, SlotsChooseAndMoveCoordinates) {
    TextureSlot shifted{.offset = {0.5f, 0.0f}};
    EXPECT_EQ(seen_at(half_square({.slot = shifted}), -0.3), 0u);
    EXPECT_EQ(seen_at(half_square({.slot = shifted}), 0.3), 1u);
    TextureSlot second{.uv_set = 1};
    TracedWorld world = half_square({.slot = second});
    EXPECT_EQ(seen_at(world, 0.3), 1u) << "without a second set everything is at (0, 0)";
    Mesh swapped = facing_square();
    swapped.uv1 = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    world.scene.instances[0].mesh = world.mesh(std::move(swapped));
    EXPECT_EQ(seen_at(world, -0.3), 0u);
}

TEST(TraceMask, PicturesReadTheLevelThatTheirPixelsSpan) {
    TracedWorld world;
    AlphaTexture texture = alpha_texture(picture(64, 64, std::vector<int>(64 * 64, 0)), {});
    texture.levels.push_back({32, 32, std::vector<float>(32 * 32, 1.0f)});
    world.scene.textures.push_back(texture);
    const std::uint32_t mask = world.material({.masked = true, .texture = 0});
    world.place(facing_square(), moved({0, 0, -4}) * scaled({10, 10, 1}), mask);
    const Tracer tracer{world.scene};
    // A pixel spans 2·4·tan(½)/n m of 20 m, that is 64/20 texels a metre: 14/n texels.
    const auto shown = [&](std::uint32_t n) {
        return trace_picture(tracer, pinhole({n, n})).hits[n / 2 * n + n / 2].exists();
    };
    EXPECT_FALSE(shown(16)) << "0.9 texels: the finest level, which is all hole";
    EXPECT_TRUE(shown(8)) << "1.75 texels: four fifths of the way to the next level";
}

}  // namespace
}  // namespace rambla::assets::test
