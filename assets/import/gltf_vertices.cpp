#include "assets/import/gltf_vertices.h"

#include <algorithm>
#include <bit>
#include <span>

namespace rambla::assets::gltf {

namespace {

constexpr std::uint32_t k_exponent = 0x7f800000u;  ///< all ones: infinite or not a number

std::uint32_t exponent_of(float value) {
    return std::bit_cast<std::uint32_t>(value) & k_exponent;
}

/// @return  how many numbers were replaced
std::size_t make_finite(std::span<float> values) {
    std::uint32_t largest = 0;
    for (const float value : values)
        largest = std::max(largest, exponent_of(value));
    if (largest != k_exponent) return 0;
    std::size_t bad = 0;
    for (float& value : values)
        if (exponent_of(value) == k_exponent) {
            value = 0.0f;
            ++bad;
        }
    return bad;
}

/// The components of all vectors in a row.
template <int N>
std::span<float> numbers_of(std::span<glm::vec<N, float>> vectors) {
    static_assert(sizeof(glm::vec<N, float>) == N * sizeof(float));
    if (vectors.empty()) return {};
    return {&vectors[0][0], N * vectors.size()};
}

}  // namespace

int attribute(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
}

template <int N>
std::vector<glm::vec<N, float>> VertexReader::read(int accessor, const std::string& name,
                                                   const AttributeForm& form, const Rule<N>& rule) {
    const std::string element = element_ + "." + name;
    const AccessorReader source{document_, accessor, element};
    if (source.components() < form.least_components || source.components() > form.most_components)
        document_.fail(element, std::to_string(source.components()) + " components",
                       std::to_string(form.most_components));
    if (source.count() != vertices_)
        document_.fail(element, std::to_string(source.count()) + " elements",
                       std::to_string(vertices_) + ", as POSITION has");
    document_.spend(element, source.sparse_count());
    std::size_t bad = 0;
    auto values = source.read<N>(kept_, form.missing, form.always_normalise,
                                 [&](std::span<glm::vec<N, float>> piece, std::size_t first) {
                                     if (rule.holds && rule.holds(piece)) return;
                                     bad += make_finite(numbers_of<N>(piece));
                                     if (rule.enforce) rule.enforce(piece, first);
                                 });
    if (bad > 0) document_.warn(element, std::to_string(bad) + " values were not finite and became 0");
    return values;
}

template std::vector<glm::vec2> VertexReader::read<2>(int, const std::string&, const AttributeForm&,
                                                      const Rule<2>&);
template std::vector<glm::vec3> VertexReader::read<3>(int, const std::string&, const AttributeForm&,
                                                      const Rule<3>&);
template std::vector<glm::vec4> VertexReader::read<4>(int, const std::string&, const AttributeForm&,
                                                      const Rule<4>&);

}  // namespace rambla::assets::gltf
