#pragma once

#include <tiny_gltf.h>

#include <algorithm>
#include <cstdio>
#include <glm/glm.hpp>
#include <limits>
#include <string>

namespace rambla::assets::gltf {

/// Short, for messages: numbers of files may have hundreds of digits.
[[nodiscard]] inline std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// JSON numbers may exceed what a float holds; they are clamped to its range.
[[nodiscard]] inline float finite_float(double value) {
    constexpr double k_largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -k_largest, k_largest));
}

[[nodiscard]] inline float unit_interval(double value) {
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// A number of an extension's object, or `fallback` where there is none.
[[nodiscard]] inline float number_of(const tinygltf::Value& object, const std::string& name, float fallback) {
    if (!object.Has(name) || !object.Get(name).IsNumber()) return fallback;
    return finite_float(object.Get(name).GetNumberAsDouble());
}

/// A whole number of an extension's object, or `fallback` where there is none.
[[nodiscard]] inline int integer_of(const tinygltf::Value& object, const std::string& name, int fallback) {
    if (!object.Has(name) || !object.Get(name).IsInt()) return fallback;
    return object.Get(name).GetNumberAsInt();
}

/// A vector of an extension's object, or `fallback` where there is none of that length.
template <int N>
[[nodiscard]] glm::vec<N, float> vector_of(const tinygltf::Value& object, const std::string& name,
                                           glm::vec<N, float> fallback) {
    if (!object.Has(name) || object.Get(name).ArrayLen() != static_cast<std::size_t>(N)) return fallback;
    glm::vec<N, float> out = fallback;
    for (int c = 0; c < N; ++c)
        if (object.Get(name).Get(c).IsNumber())
            out[c] = finite_float(object.Get(name).Get(c).GetNumberAsDouble());
    return out;
}

}  // namespace rambla::assets::gltf
