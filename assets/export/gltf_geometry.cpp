#include "assets/export/gltf_geometry.h"

#include <algorithm>

namespace rambla::assets {

namespace {

using Json = nlohmann::json;

/// The largest 16-bit index would restart a strip and is not allowed.
constexpr std::size_t k_most_short_vertices = 65535;

int mode_of(Topology topology) {
    switch (topology) {
        case Topology::points:
            return 0;
        case Topology::lines:
            return 1;
        case Topology::triangles:
            break;
    }
    return 4;
}

bool is_empty(const Mesh& mesh) {
    return mesh.positions.empty() || mesh.indices.empty();
}

Json target_names(const Mesh& mesh) {
    Json names = Json::array();
    for (const MorphTarget& target : mesh.morphs)
        names.push_back(target.name);
    return names;
}

bool is_named(const MorphTarget& target) {
    return !target.name.empty();
}

}  // namespace

Json GltfGeometry::mesh_of(const Model& model) {
    // All primitives of a mesh of glTF have the same number of targets.
    std::size_t morphs = 0;
    for (const ModelPart& part : model.parts)
        if (const Mesh& mesh = scene_.meshes[part.mesh]; !is_empty(mesh))
            morphs = std::max(morphs, mesh.morphs.size());

    Json out;
    for (const ModelPart& part : model.parts) {
        const Mesh& mesh = scene_.meshes[part.mesh];
        if (is_empty(mesh)) continue;
        Json shown = primitive(part.mesh, morphs);
        if (part.material != k_none) shown["material"] = part.material;
        out["primitives"].push_back(std::move(shown));
        if (mesh.morphs.size() == morphs && std::any_of(mesh.morphs.begin(), mesh.morphs.end(), is_named))
            out["extras"]["targetNames"] = target_names(mesh);
    }
    if (out.is_null()) return out;
    if (!model.name.empty()) out["name"] = model.name;
    if (morphs > 0 && model.morph_weights.size() == morphs) out["weights"] = model.morph_weights;
    return out;
}

Json GltfGeometry::primitive(std::uint32_t index, std::size_t morphs) {
    const std::pair key{index, morphs};
    if (const auto known = primitives_.find(key); known != primitives_.end()) return known->second;
    const Mesh& mesh = scene_.meshes[index];
    Json out{{"attributes", attributes(mesh)}, {"indices", add_indices(mesh)}};
    if (mesh.topology != Topology::triangles) out["mode"] = mode_of(mesh.topology);
    for (std::size_t i = 0; i < morphs; ++i)
        out["targets"].push_back(morph_target(mesh, i));
    primitives_.emplace(key, out);
    return out;
}

Json GltfGeometry::attributes(const Mesh& mesh) {
    Json out;
    out["POSITION"] = add_positions(mesh.positions);
    if (!mesh.normals.empty()) out["NORMAL"] = buffer_.add_vectors(mesh.normals);
    if (!mesh.tangents.empty()) out["TANGENT"] = buffer_.add_vectors(mesh.tangents);
    if (!mesh.uv0.empty()) out["TEXCOORD_0"] = buffer_.add_vectors(mesh.uv0);
    // Sets must be numbered without gaps: a second set alone needs a first one.
    if (!mesh.uv1.empty() && mesh.uv0.empty()) out["TEXCOORD_0"] = buffer_.add_zeros(mesh.uv1.size(), "VEC2");
    if (!mesh.uv1.empty()) out["TEXCOORD_1"] = buffer_.add_vectors(mesh.uv1);
    if (!mesh.colours.empty()) out["COLOR_0"] = buffer_.add_vectors(mesh.colours);
    if (!mesh.joints.empty()) out["JOINTS_0"] = add_joints(mesh);
    if (!mesh.weights.empty()) out["WEIGHTS_0"] = buffer_.add_vectors(mesh.weights);
    return out;
}

/// A target that the mesh does not have, or that moves nothing, is one of zeros: glTF has no empty ones.
Json GltfGeometry::morph_target(const Mesh& mesh, std::size_t index) {
    static const MorphTarget k_nothing;
    const MorphTarget& target = index < mesh.morphs.size() ? mesh.morphs[index] : k_nothing;
    Json out = Json::object();
    if (!target.positions.empty()) out["POSITION"] = add_positions(target.positions);
    if (!target.normals.empty()) out["NORMAL"] = buffer_.add_vectors(target.normals);
    if (!target.tangents.empty()) out["TANGENT"] = buffer_.add_vectors(target.tangents);
    if (out.empty()) {
        const std::size_t zeros = buffer_.add_zeros(mesh.positions.size(), "VEC3");
        buffer_.set_range(zeros, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f});
        out["POSITION"] = zeros;
    }
    return out;
}

std::size_t GltfGeometry::add_positions(const std::vector<glm::vec3>& positions) {
    const std::size_t accessor = buffer_.add_vectors(positions);
    Bounds bounds;
    for (const glm::vec3& position : positions)
        bounds.expand(position);
    buffer_.set_range(accessor, {bounds.min.x, bounds.min.y, bounds.min.z},
                      {bounds.max.x, bounds.max.y, bounds.max.z});
    return accessor;
}

/// Joints without weight must be 0 (glTF 2.0, section 3.7.3.3).
std::size_t GltfGeometry::add_joints(const Mesh& mesh) {
    std::vector<glm::u16vec4> joints = mesh.joints;
    for (std::size_t v = 0; v < mesh.weights.size(); ++v)
        for (int i = 0; i < 4; ++i)
            if (mesh.weights[v][i] == 0.0f) joints[v][i] = 0;
    return buffer_.add(std::as_bytes(std::span{joints}), joints.size(),
                       {GltfBuffer::Component::u16, "VEC4", GltfBuffer::Target::vertices});
}

std::size_t GltfGeometry::add_indices(const Mesh& mesh) {
    const bool is_short = mesh.positions.size() <= k_most_short_vertices;
    const std::vector<std::uint16_t> shorts(is_short ? mesh.indices.begin() : mesh.indices.end(),
                                            mesh.indices.end());
    const auto bytes = is_short ? std::as_bytes(std::span{shorts}) : std::as_bytes(std::span{mesh.indices});
    return buffer_.add(bytes, mesh.indices.size(),
                       {is_short ? GltfBuffer::Component::u16 : GltfBuffer::Component::u32, "SCALAR",
                        GltfBuffer::Target::indices});
}

}  // namespace rambla::assets
