#include "assets/import/gltf_vertices.h"

#include <algorithm>
#include <bit>

namespace rambla::assets::gltf {

namespace {

constexpr std::uint32_t k_exponent = 0x7f800000u;  ///< all ones: infinite or not a number

std::uint32_t exponent_of(float value) {
    return std::bit_cast<std::uint32_t>(value) & k_exponent;
}

/// @return  how many numbers were replaced
template <int N>
std::size_t make_finite(std::vector<glm::vec<N, float>>& values) {
    std::uint32_t largest = 0;
    for (const auto& value : values)
        for (int c = 0; c < N; ++c)
            largest = std::max(largest, exponent_of(value[c]));
    if (largest != k_exponent) return 0;
    std::size_t bad = 0;
    for (auto& value : values)
        for (int c = 0; c < N; ++c)
            if (exponent_of(value[c]) == k_exponent) {
                value[c] = 0.0f;
                ++bad;
            }
    return bad;
}

}  // namespace

int attribute(const Attributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
}

template <int N>
std::vector<glm::vec<N, float>> VertexReader::read(int accessor, const std::string& name,
                                                   const AttributeForm& form) {
    const std::string element = element_ + "." + name;
    const AccessorReader source{document_, accessor, element};
    if (source.components() < form.least_components || source.components() > form.most_components)
        document_.fail(element, std::to_string(source.components()) + " components",
                       std::to_string(form.most_components));
    if (source.count() != vertices_)
        document_.fail(element, std::to_string(source.count()) + " elements",
                       std::to_string(vertices_) + ", as POSITION has");
    document_.spend(element, source.sparse_count());
    auto values = source.read<N>(kept_, form.missing, form.always_normalise);
    if (const std::size_t bad = make_finite<N>(values); bad > 0)
        document_.warn(element, std::to_string(bad) + " values were not finite and became 0");
    return values;
}

template std::vector<glm::vec2> VertexReader::read<2>(int, const std::string&, const AttributeForm&);
template std::vector<glm::vec3> VertexReader::read<3>(int, const std::string&, const AttributeForm&);
template std::vector<glm::vec4> VertexReader::read<4>(int, const std::string&, const AttributeForm&);

}  // namespace rambla::assets::gltf
