#include "assets/import/gltf_transform.h"

#include <cmath>

#include "assets/import/gltf_value.h"
#include "assets/process/tangents.h"

namespace rambla::assets::gltf {

namespace {

/// Largest difference of a recomposed element, relative to the largest element: float rounding and no shear.
constexpr float k_exact = 1e-4f;

float largest_magnitude(const glm::mat3& m) {
    float largest = 0.0f;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(m[c][r]));
    return largest;
}

/// Unit axes of a matrix; a column of length zero gets the direction that completes the others.
glm::mat3 axes(const glm::mat3& linear, glm::vec3 lengths) {
    glm::mat3 out{1.0f};
    int missing = 0;
    for (int c = 0; c < 3; ++c) {
        if (lengths[c] > 0.0f)
            out[c] = linear[c] / lengths[c];
        else
            ++missing;
    }
    if (missing == 0 || missing == 3) return out;
    for (int c = 0; c < 3; ++c) {
        const int next = (c + 1) % 3;
        const int last = (c + 2) % 3;
        if (missing == 1 && lengths[c] == 0.0f) out[c] = glm::cross(out[next], out[last]);
        if (missing == 2 && lengths[c] > 0.0f) {
            out[next] = any_perpendicular(out[c]);
            out[last] = glm::cross(out[c], out[next]);
        }
    }
    return out;
}

std::vector<float> numbers(const Document& document, const std::vector<double>& source, std::size_t count,
                           const std::string& element) {
    std::vector<float> out;
    if (source.empty()) return out;
    if (source.size() != count)
        document.fail(element, std::to_string(source.size()) + " numbers", std::to_string(count));
    for (const double value : source) {
        out.push_back(static_cast<float>(value));
        if (!std::isfinite(out.back()))
            document.fail(element_name(element, out.size() - 1), number_text(value),
                          "a number that a float holds");
    }
    return out;
}

Transform from_matrix(const Document& document, const std::vector<float>& m, const std::string& element) {
    glm::mat4 matrix{1.0f};
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
    const Decomposition result = decompose(matrix);
    if (!result.exact)
        document.warn(element + ".matrix", "shears, which is not supported; the shear is left out");
    return result.transform;
}

}  // namespace

Decomposition decompose(const glm::mat4& matrix) {
    const glm::mat3 linear{matrix};
    glm::vec3 scale{glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])};
    glm::mat3 rotation = axes(linear, scale);
    if (glm::determinant(rotation) < 0.0f) {
        scale.x = -scale.x;
        rotation[0] = -rotation[0];
    }
    Decomposition out;
    out.transform.translation_m = glm::vec3{matrix[3]};
    out.transform.rotation = glm::normalize(glm::quat_cast(rotation));
    out.transform.scale = scale;
    const glm::mat3 again{assets::matrix(out.transform)};
    out.exact = largest_magnitude(again - linear) <= k_exact * std::max(largest_magnitude(linear), 1e-30f);
    return out;
}

std::optional<glm::quat> unit_rotation(glm::vec4 xyzw) {
    const glm::quat rotation{xyzw.w, xyzw.x, xyzw.y, xyzw.z};
    const float length_squared = glm::dot(rotation, rotation);
    constexpr float k_storage_error = 1e-6f;
    if (!(length_squared > 1e-12f) || !std::isfinite(length_squared)) return std::nullopt;
    if (std::abs(length_squared - 1.0f) < k_storage_error) return rotation;
    return rotation / std::sqrt(length_squared);
}

Transform import_transform(const Document& document, const tinygltf::Node& node, const std::string& element) {
    const std::vector<float> m = numbers(document, node.matrix, 16, element + ".matrix");
    if (!m.empty()) return from_matrix(document, m, element);

    Transform out;
    const std::vector<float> t = numbers(document, node.translation, 3, element + ".translation");
    const std::vector<float> r = numbers(document, node.rotation, 4, element + ".rotation");
    const std::vector<float> s = numbers(document, node.scale, 3, element + ".scale");
    if (!t.empty()) out.translation_m = {t[0], t[1], t[2]};
    if (!s.empty()) out.scale = {s[0], s[1], s[2]};
    if (!r.empty()) {
        const std::optional<glm::quat> rotation = unit_rotation({r[0], r[1], r[2], r[3]});
        if (!rotation) document.warn(element + ".rotation", "is no rotation and is left out");
        out.rotation = rotation.value_or(out.rotation);
    }
    return out;
}

}  // namespace rambla::assets::gltf
