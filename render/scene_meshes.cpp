#include "render/scene_meshes.h"

#include <cstddef>
#include <glm/gtc/packing.hpp>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {

namespace {

constexpr GLuint k_position_stream = 0;
constexpr GLuint k_attribute_stream = 1;

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

}  // namespace

PackedAttributes pack_attributes(const assets::Mesh& mesh, std::size_t vertex) {
    const glm::vec3 normal = mesh.normals.empty() ? glm::vec3{0.0f, 1.0f, 0.0f} : mesh.normals[vertex];
    return {.normal = glm::packSnorm4x16(glm::vec4{normal, 0.0f}),
            .tangent = mesh.tangents.empty() ? 0 : glm::packSnorm4x16(mesh.tangents[vertex]),
            .uv0 = mesh.uv0.empty() ? glm::vec2{0.0f} : mesh.uv0[vertex],
            .uv1 = mesh.uv1.empty() ? glm::vec2{0.0f} : mesh.uv1[vertex],
            .colour = glm::packHalf4x16(mesh.colours.empty() ? glm::vec4{1.0f} : mesh.colours[vertex])};
}

SceneMeshes upload_meshes(std::span<const assets::Mesh> meshes) {
    std::size_t vertex_count = 0;
    std::size_t index_count = 0;
    for (const assets::Mesh& mesh : meshes) {
        vertex_count += mesh.positions.size();
        index_count += mesh.indices.size();
    }
    std::vector<glm::vec3> positions;
    std::vector<PackedAttributes> attributes;
    std::vector<std::uint32_t> indices;
    positions.reserve(vertex_count);
    attributes.reserve(vertex_count);
    indices.reserve(index_count);

    SceneMeshes result;
    result.ranges.reserve(meshes.size());
    for (const assets::Mesh& mesh : meshes) {
        result.ranges.push_back({.first_index = static_cast<std::uint32_t>(indices.size()),
                                 .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                                 .base_vertex = static_cast<std::int32_t>(positions.size()),
                                 .topology = mesh.topology,
                                 .bounds = mesh.bounds});
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            attributes.push_back(pack_attributes(mesh, v));
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }

    result.positions = gl::Buffer{"positions", positions.size() * sizeof(glm::vec3), positions.data()};
    result.attributes =
        gl::Buffer{"attributes", attributes.size() * sizeof(PackedAttributes), attributes.data()};
    result.indices = gl::Buffer{"indices", indices.size() * sizeof(std::uint32_t), indices.data()};
    result.vertices = gl::VertexArray{"meshes"};
    describe(result.vertices);
    result.vertices.vertex_buffer(k_position_stream, result.positions.name(), sizeof(glm::vec3));
    result.vertices.vertex_buffer(k_attribute_stream, result.attributes.name(), sizeof(PackedAttributes));
    result.vertices.index_buffer(result.indices.name());
    return result;
}

}  // namespace rambla::render
