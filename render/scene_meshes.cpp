#include "render/scene_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/packing.hpp>
#include <string_view>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

namespace {

constexpr GLuint k_position_stream = 0;
constexpr GLuint k_attribute_stream = 1;
constexpr GLuint k_skin_stream = 2;

void describe(gl::VertexArray& vertices) {
    const auto attribute = [&](GLuint location, GLint components, GLenum type, bool normalised,
                               std::size_t offset) {
        vertices.attribute({.location = location,
                            .binding = k_attribute_stream,
                            .components = components,
                            .type = type,
                            .normalised = normalised,
                            .offset = static_cast<GLuint>(offset)});
    };
    vertices.attribute({.location = ATTRIBUTE_POSITION, .binding = k_position_stream});
    attribute(ATTRIBUTE_NORMAL, 3, GL_SHORT, true, offsetof(PackedAttributes, normal));
    attribute(ATTRIBUTE_TANGENT, 4, GL_SHORT, true, offsetof(PackedAttributes, tangent));
    attribute(ATTRIBUTE_UV0, 2, GL_FLOAT, false, offsetof(PackedAttributes, uv0));
    attribute(ATTRIBUTE_UV1, 2, GL_FLOAT, false, offsetof(PackedAttributes, uv1));
    attribute(ATTRIBUTE_COLOUR, 4, GL_HALF_FLOAT, false, offsetof(PackedAttributes, colour));
}

gl::VertexArray vertex_array(const SceneMeshes& meshes, std::string_view name) {
    gl::VertexArray vertices{name};
    describe(vertices);
    vertices.vertex_buffer(k_position_stream, meshes.positions.name(), sizeof(glm::vec3));
    vertices.vertex_buffer(k_attribute_stream, meshes.attributes.name(), sizeof(PackedAttributes));
    vertices.index_buffer(meshes.indices.name());
    return vertices;
}

void add_skins(SceneMeshes& meshes) {
    gl::VertexArray& vertices = meshes.skinned_vertices;
    vertices.attribute({.location = ATTRIBUTE_JOINTS,
                        .binding = k_skin_stream,
                        .components = 4,
                        .type = GL_UNSIGNED_SHORT,
                        .integer = true,
                        .offset = offsetof(PackedSkin, joints)});
    vertices.attribute({.location = ATTRIBUTE_WEIGHTS,
                        .binding = k_skin_stream,
                        .components = 4,
                        .type = GL_UNSIGNED_SHORT,
                        .normalised = true,
                        .offset = offsetof(PackedSkin, weights)});
    vertices.vertex_buffer(k_skin_stream, meshes.skins.name(), sizeof(PackedSkin));
}

}  // namespace

PackedAttributes pack_attributes(const assets::Mesh& mesh, std::size_t vertex) {
    const glm::vec3 normal = mesh.normals.empty() ? glm::vec3{0.0f, 1.0f, 0.0f} : mesh.normals[vertex];
    return {.normal = glm::packSnorm4x16(glm::vec4{normal, 0.0f}),
            .tangent = mesh.tangents.empty() ? 0 : glm::packSnorm4x16(mesh.tangents[vertex]),
            .uv0 = mesh.uv0.empty() ? glm::vec2{0.0f} : mesh.uv0[vertex],
            .uv1 = mesh.uv1.empty() ? glm::vec2{0.0f} : mesh.uv1[vertex],
            .colour = glm::packHalf4x16(mesh.colours.empty() ? glm::vec4{1.0f} : mesh.colours[vertex])};
}

PackedSkin pack_skin(const assets::Mesh& mesh, std::size_t vertex) {
    const glm::u16vec4 joints = mesh.joints[vertex];
    const glm::vec4 weights = glm::max(mesh.weights[vertex], glm::vec4{0.0f});
    const float sum = weights.x + weights.y + weights.z + weights.w;
    std::array<std::uint32_t, 4> shares{65535, 0, 0, 0};
    if (sum > 0.0f && std::isfinite(sum)) {
        std::uint32_t left = 65535;
        std::uint32_t largest = 0;
        for (std::uint32_t i = 0; i < 4; ++i) {
            // Rounded down, so that something is left over rather than missing.
            shares[i] =
                std::min(static_cast<std::uint32_t>(65535.0f * (weights[static_cast<int>(i)] / sum)), left);
            left -= shares[i];
            if (shares[i] > shares[largest]) largest = i;
        }
        shares[largest] += left;
    }
    const auto packed = [](auto&& value) {
        std::uint64_t bits = 0;
        for (unsigned i = 0; i < 4; ++i)
            bits |= static_cast<std::uint64_t>(value(i)) << (16u * i);
        return bits;
    };
    return {packed([&](unsigned i) { return joints[static_cast<int>(i)]; }),
            packed([&](unsigned i) { return shares[i]; })};
}

SceneMeshes upload_meshes(std::span<const assets::ProcessedMesh> meshes) {
    constexpr std::array<glm::vec3, 4> k_corners{{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}};
    constexpr std::array<std::uint32_t, 6> k_quad{0, 1, 2, 2, 1, 3};
    std::size_t vertex_count = k_corners.size();
    std::size_t index_count = k_quad.size();
    std::vector<std::uint32_t> order(meshes.size());
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        vertex_count += meshes[i].mesh.positions.size();
        index_count += meshes[i].mesh.indices.size();
        order[i] = i;
    }
    std::stable_partition(order.begin(), order.end(),
                          [&](std::uint32_t i) { return !meshes[i].mesh.weights.empty(); });
    std::vector<glm::vec3> positions;
    std::vector<PackedAttributes> attributes;
    std::vector<PackedSkin> skins;
    std::vector<std::uint32_t> indices;
    positions.reserve(vertex_count);
    attributes.reserve(vertex_count);
    indices.reserve(index_count);

    SceneMeshes result;
    result.ranges.resize(meshes.size());
    for (const std::uint32_t number : order) {
        const assets::Mesh& mesh = meshes[number].mesh;
        result.ranges[number] = {.first_index = static_cast<std::uint32_t>(indices.size()),
                                 .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                                 .base_vertex = static_cast<std::int32_t>(positions.size()),
                                 .topology = mesh.topology};
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            attributes.push_back(pack_attributes(mesh, v));
        for (std::size_t v = 0; v < mesh.weights.size(); ++v)
            skins.push_back(pack_skin(mesh, v));
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    result.quad = {.first_index = static_cast<std::uint32_t>(indices.size()),
                   .index_count = static_cast<std::uint32_t>(k_quad.size()),
                   .base_vertex = static_cast<std::int32_t>(positions.size())};
    positions.insert(positions.end(), k_corners.begin(), k_corners.end());
    attributes.resize(positions.size());
    indices.insert(indices.end(), k_quad.begin(), k_quad.end());

    result.positions = gl::Buffer{"positions", positions.size() * sizeof(glm::vec3), positions.data()};
    result.attributes =
        gl::Buffer{"attributes", attributes.size() * sizeof(PackedAttributes), attributes.data()};
    result.indices = gl::Buffer{"indices", indices.size() * sizeof(std::uint32_t), indices.data()};
    result.vertices = vertex_array(result, "meshes");
    if (skins.empty()) return result;
    result.skins = gl::Buffer{"skins", skins.size() * sizeof(PackedSkin), skins.data()};
    result.skinned_vertices = vertex_array(result, "skinned meshes");
    add_skins(result);
    return result;
}

}  // namespace rambla::render
