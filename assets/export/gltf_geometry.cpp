#include "assets/export/gltf_geometry.h"

namespace rambla::assets {

namespace {

using Json = nlohmann::json;

// Numbers of the glTF format, which are those of OpenGL.
constexpr int k_unsigned_short = 5123;
constexpr int k_unsigned_int = 5125;
constexpr int k_float = 5126;
constexpr int k_vertices = 34962;
constexpr int k_indices = 34963;
constexpr int k_no_target = 0;

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

}  // namespace

std::size_t GltfGeometry::add_view(std::span<const std::byte> bytes, int target) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4, 0);
    Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target != k_no_target) view["target"] = target;
    views_.push_back(std::move(view));
    const auto* const first = reinterpret_cast<const unsigned char*>(bytes.data());
    bytes_.insert(bytes_.end(), first, first + bytes.size());
    return views_.size() - 1;
}

std::size_t GltfGeometry::add_bytes(std::span<const std::byte> bytes) {
    return add_view(bytes, k_no_target);
}

template <class Vector>
std::size_t GltfGeometry::add_vectors(const std::vector<Vector>& values) {
    accessors_.push_back({{"bufferView", add_view(std::as_bytes(std::span{values}), k_vertices)},
                          {"componentType", k_float},
                          {"count", values.size()},
                          {"type", "VEC" + std::to_string(Vector::length())}});
    return accessors_.size() - 1;
}

std::size_t GltfGeometry::add_indices(const Mesh& mesh) {
    const bool is_short = mesh.positions.size() <= k_most_short_vertices;
    const std::vector<std::uint16_t> shorts(is_short ? mesh.indices.begin() : mesh.indices.end(),
                                            mesh.indices.end());
    const auto bytes = is_short ? std::as_bytes(std::span{shorts}) : std::as_bytes(std::span{mesh.indices});
    accessors_.push_back({{"bufferView", add_view(bytes, k_indices)},
                          {"componentType", is_short ? k_unsigned_short : k_unsigned_int},
                          {"count", mesh.indices.size()},
                          {"type", "SCALAR"}});
    return accessors_.size() - 1;
}

Json GltfGeometry::primitive(const Mesh& mesh, std::uint32_t key) {
    if (const auto known = primitives_.find(key); known != primitives_.end()) return known->second;
    Json attributes;
    attributes["POSITION"] = add_vectors(mesh.positions);
    Bounds bounds;
    for (const glm::vec3& position : mesh.positions)
        bounds.expand(position);
    accessors_.back()["min"] = {bounds.min.x, bounds.min.y, bounds.min.z};
    accessors_.back()["max"] = {bounds.max.x, bounds.max.y, bounds.max.z};
    if (!mesh.normals.empty()) attributes["NORMAL"] = add_vectors(mesh.normals);
    if (!mesh.tangents.empty()) attributes["TANGENT"] = add_vectors(mesh.tangents);
    if (!mesh.uv0.empty()) attributes["TEXCOORD_0"] = add_vectors(mesh.uv0);
    // Sets must be numbered without gaps: a second set alone needs a first one.
    if (!mesh.uv1.empty() && mesh.uv0.empty())
        attributes["TEXCOORD_0"] = add_vectors(std::vector<glm::vec2>(mesh.uv1.size(), glm::vec2{0.0f}));
    if (!mesh.uv1.empty()) attributes["TEXCOORD_1"] = add_vectors(mesh.uv1);
    if (!mesh.colours.empty()) attributes["COLOR_0"] = add_vectors(mesh.colours);
    Json out{{"attributes", std::move(attributes)}, {"indices", add_indices(mesh)}};
    if (mesh.topology != Topology::triangles) out["mode"] = mode_of(mesh.topology);
    primitives_.emplace(key, out);
    return out;
}

void GltfGeometry::finish(Json& document) const {
    if (!accessors_.empty()) document["accessors"] = accessors_;
    if (!views_.empty()) document["bufferViews"] = views_;
    if (!bytes_.empty()) document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
}

}  // namespace rambla::assets
