#include "game/supersampling.h"

#include <gtest/gtest.h>

namespace rambla::game {
namespace {

using render::AntiAliasing;

render::DeviceInfo device_with(std::int64_t largest_texture_px) {
    render::DeviceInfo device;
    device.limits = {{.name = "GL_MAX_SAMPLES", .value = 4},
                     {.name = "GL_MAX_TEXTURE_SIZE", .value = largest_texture_px}};
    return device;
}

systems::Eye eye_of(glm::uvec2 size_px) {
    systems::Eye eye;
    eye.size_px = size_px;
    return eye;
}

std::uint32_t samples_of(const render::AntiAliasingParameters& parameters, glm::uvec2 size_px = {960, 540}) {
    return sampled(eye_of(size_px), parameters, device_with(16384)).samples;
}

TEST(Supersampling, IsAskedForByItsMethodAlone) {
    for (std::size_t method = 0; method < render::k_anti_aliasing_methods.size(); ++method) {
        const auto which = static_cast<AntiAliasing>(method);
        EXPECT_EQ(samples_of({.method = which, .samples = 4}), which == AntiAliasing::ssaa ? 4u : 1u);
    }
}

TEST(Supersampling, DrawsSixtyFourPixelsForOneOfTheUsualSize) {
    EXPECT_EQ(samples_of({.method = AntiAliasing::ssaa, .samples = 8}), 8u);
}

TEST(Supersampling, OfAnEyeThatWasSampledStartsAnew) {
    systems::Eye eye = eye_of({64, 64});
    eye.samples = 8;
    EXPECT_EQ(sampled(eye, {.method = AntiAliasing::fxaa}, device_with(16384)).samples, 1u);
}

TEST(Supersampling, DrawsAsManyAsFitIntoATextureOfTheDevice) {
    EXPECT_EQ(fitting_samples(8, {4096, 16}, 16384), 4u);
    EXPECT_EQ(fitting_samples(8, {16, 4097}, 16384), 3u);
    EXPECT_EQ(fitting_samples(8, {16, 4097}, 32768), 7u);
    EXPECT_EQ(fitting_samples(2, {4096, 16}, 16384), 2u) << "no more than asked for";
}

TEST(Supersampling, DrawsAsManyAsFitIntoMemory) {
    EXPECT_EQ(fitting_samples(8, {1024, 1024}, 16384), 8u) << "2^26 pixels";
    EXPECT_EQ(fitting_samples(8, {1024, 1025}, 16384), 7u);
    EXPECT_EQ(fitting_samples(8, {3840, 2160}, 16384), 2u);
}

TEST(Supersampling, DrawsOneAtLeast) {
    EXPECT_EQ(fitting_samples(8, {16384, 16384}, 16384), 1u) << "more than memory allows, but what is shown";
    EXPECT_EQ(fitting_samples(8, {9000, 1}, 8192), 1u);
    EXPECT_EQ(fitting_samples(0, {16, 16}, 8192), 1u);
    EXPECT_EQ(fitting_samples(8, {0, 0}, 8192), 8u) << "a window without pixels";
}

}  // namespace
}  // namespace rambla::game
