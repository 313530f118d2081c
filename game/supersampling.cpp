#include "game/supersampling.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <limits>

namespace rambla::game {
namespace {

std::uint32_t largest_texture_px(const render::DeviceInfo& device) {
    for (const render::DeviceLimit& limit : device.limits)
        if (limit.name == "GL_MAX_TEXTURE_SIZE") return static_cast<std::uint32_t>(limit.value);
    return std::numeric_limits<std::uint32_t>::max();
}

void warn_once(std::uint32_t asked, std::uint32_t samples, glm::uvec2 shown_px) {
    static std::atomic<bool> warned{false};
    if (warned.exchange(true)) return;
    spdlog::warn("{0}x{0} samples of {1}x{2} pixels are too many: {3}x{3} are drawn", asked, shown_px.x,
                 shown_px.y, samples);
}

}  // namespace

std::uint32_t fitting_samples(std::uint32_t asked, glm::uvec2 shown_px, std::uint32_t largest_texture_px) {
    const auto fits = [&](std::uint64_t samples) {
        const std::uint64_t width = samples * shown_px.x;
        const std::uint64_t height = samples * shown_px.y;
        return std::max(width, height) <= largest_texture_px && width * height <= k_most_drawn_px;
    };
    std::uint32_t samples = std::max(asked, 1u);
    while (samples > 1 && !fits(samples))
        --samples;
    return samples;
}

systems::Eye sampled(systems::Eye eye, const render::AntiAliasingParameters& parameters,
                     const render::DeviceInfo& device) {
    eye.samples = 1;
    if (parameters.method != render::AntiAliasing::ssaa) return eye;
    const auto asked = static_cast<std::uint32_t>(parameters.samples);
    eye.samples = fitting_samples(asked, eye.size_px, largest_texture_px(device));
    if (eye.samples < asked) warn_once(asked, eye.samples, eye.size_px);
    return eye;
}

}  // namespace rambla::game
