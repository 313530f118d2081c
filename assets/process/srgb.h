#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace rambla::assets {

/// Linear light from an sRGB value, both in [0, 1]. IEC 61966-2-1:1999.
[[nodiscard]] inline float linear_from_srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

/// The inverse. Values outside of [0, 1] are clamped.
[[nodiscard]] inline float srgb_from_linear(float light) {
    if (!(light > 0.0f)) return 0.0f;
    if (light >= 1.0f) return 1.0f;
    return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

/// linear_from_srgb of every byte.
[[nodiscard]] inline const std::array<float, 256>& linear_from_srgb_bytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        return values;
    }();
    return table;
}

/// The nearest of 256 steps; what is not in [0, 1] is clamped, NaN is 0.
[[nodiscard]] inline std::uint8_t byte_from_unit(float value) {
    if (!(value > 0.0f)) return 0;
    return value >= 1.0f ? 255 : static_cast<std::uint8_t>(value * 255.0f + 0.5f);
}

}  // namespace rambla::assets
