#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rambla::assets {

enum class Interpolation : std::uint8_t {
    step,
    linear,       ///< rotations along the shorter arc
    cubic_spline  ///< Hermite, with tangents per second in the file (glTF 2.0, appendix C)
};

enum class AnimatedPath : std::uint8_t { translation, rotation, scale, weights };

/// As glTF writes it.
[[nodiscard]] constexpr const char* name_of(AnimatedPath path) {
    switch (path) {
        case AnimatedPath::rotation:
            return "rotation";
        case AnimatedPath::scale:
            return "scale";
        case AnimatedPath::weights:
            return "weights";
        case AnimatedPath::translation:
            break;
    }
    return "translation";
}

/// One property of one node over time.
struct Channel {
    std::uint32_t node = 0;
    AnimatedPath path = AnimatedPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::uint32_t width =
        3;  ///< floats per value: 3; 4 for rotations (x, y, z, w); morph targets for weights
    std::vector<float> times_s;  ///< of the keys, strictly increasing, ≥ 0, at least one
    std::vector<float>
        values;  ///< times · width; for cubic splines times · 3 · width: in-tangent, value, out-tangent
};

/// An animation: channels that play together. Before its first and after its last key, a channel holds their
/// values.
struct Clip {
    std::string name;
    float duration_s = 0.0f;  ///< time of the last key of all channels
    std::vector<Channel> channels;
};

}  // namespace rambla::assets
