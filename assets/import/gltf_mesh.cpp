#include "assets/import/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "assets/import/gltf_accessor.h"
#include "assets/import/gltf_topology.h"
#include "assets/process/tangents.h"

namespace rambla::assets::gltf {

namespace {

constexpr std::array<const char*, 6> k_attributes{"POSITION",   "NORMAL",     "TANGENT",
                                                  "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"};

/// What makes two primitives the same geometry: accessors, topology, and the UV set that tangents are made
/// for.
using GeometryKey = std::array<int, k_attributes.size() + 3>;

constexpr int k_no_tangents = -1;

int attribute(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

/// Tangents are worth their memory only where a normal texture needs them, their time only where the file has
/// none.
int tangent_uv_set(const tinygltf::Primitive& primitive, const Scene& scene) {
    if (attribute(primitive, "TANGENT") >= 0 && attribute(primitive, "NORMAL") >= 0) return k_no_tangents;
    if (primitive.material < 0 || static_cast<std::size_t>(primitive.material) >= scene.materials.size())
        return k_no_tangents;
    const TextureSlot& slot = scene.materials[static_cast<std::size_t>(primitive.material)].normal_texture;
    return slot.texture == k_none ? k_no_tangents : static_cast<int>(slot.uv_set);
}

GeometryKey key_of(const tinygltf::Primitive& primitive, int tangents_for) {
    GeometryKey key{primitive.mode, primitive.indices, tangents_for};
    for (std::size_t i = 0; i < k_attributes.size(); ++i)
        key[i + 3] = attribute(primitive, k_attributes[i]);
    return key;
}

/// Reads one primitive into a mesh.
class PrimitiveImport {
public:
    PrimitiveImport(Document& document, const tinygltf::Primitive& primitive, std::string element)
        : document_{document}, primitive_{primitive}, element_{std::move(element)} {}

    Mesh run(int tangents_for) {
        const AccessorReader positions = reader("POSITION", 3, 3);
        vertex_count_ = positions.count();
        read_topology();
        keep_referenced_vertices();
        mesh_.positions = positions.read<3>(kept_);
        make_finite(mesh_.positions, "POSITION");
        read_texture_coordinates();
        read_colours();
        read_normals_and_tangents();
        if (mesh_.topology == Topology::triangles && mesh_.normals.empty()) compute_flat_normals(mesh_);
        if (tangents_for != k_no_tangents && mesh_.topology == Topology::triangles && mesh_.tangents.empty())
            compute_tangents(mesh_, static_cast<std::uint32_t>(tangents_for));
        for (const glm::vec3& position : mesh_.positions)
            mesh_.bounds.expand(position);
        return std::move(mesh_);
    }

private:
    std::string attribute_name(const char* name) const { return element_ + ".attributes." + name; }

    AccessorReader reader(const char* name, int least_components, int most_components) {
        AccessorReader found{document_, attribute(primitive_, name), attribute_name(name)};
        if (found.components() < least_components || found.components() > most_components)
            document_.fail(attribute_name(name), std::to_string(found.components()) + " components",
                           std::to_string(most_components));
        if (vertex_count_ > 0 && found.count() != vertex_count_)
            document_.fail(attribute_name(name), std::to_string(found.count()) + " elements",
                           std::to_string(vertex_count_) + ", as POSITION has");
        return found;
    }

    bool has(const char* name) const { return attribute(primitive_, name) >= 0; }

    void read_topology() {
        std::vector<std::uint32_t> indices;
        const std::string element = element_ + ".indices";
        if (primitive_.indices >= 0) {
            const AccessorReader source{document_, primitive_.indices, element};
            document_.spend(element, source.count());
            indices = source.read_indices();
            for (std::size_t i = 0; i < indices.size(); ++i)
                if (indices[i] >= vertex_count_)
                    document_.fail(element,
                                   "index " + std::to_string(indices[i]) + " at " + std::to_string(i),
                                   "below " + std::to_string(vertex_count_) + ", the number of vertices");
        } else {
            document_.spend(element_, vertex_count_);
            indices.resize(vertex_count_);
            std::iota(indices.begin(), indices.end(), 0u);
        }
        const PrimitiveMode mode = primitive_mode(document_, primitive_.mode, element_ + ".mode");
        const std::size_t given = indices.size();
        mesh_.topology = topology_of(mode);
        mesh_.indices = to_list(mode, std::move(indices));
        if (is_ragged(mode, given)) document_.warn(element_, "incomplete last element was dropped");
    }

    /// Primitives often share one large vertex buffer; each then takes only what it shows.
    void keep_referenced_vertices() {
        const bool most_are_used = mesh_.indices.size() >= vertex_count_ / 2;
        if (most_are_used || mesh_.indices.empty()) {
            document_.spend(element_, vertex_count_);
            return;
        }
        kept_ = mesh_.indices;
        std::sort(kept_.begin(), kept_.end());
        kept_.erase(std::unique(kept_.begin(), kept_.end()), kept_.end());
        document_.spend(element_, kept_.size());
        for (std::uint32_t& index : mesh_.indices)
            index = static_cast<std::uint32_t>(std::lower_bound(kept_.begin(), kept_.end(), index) -
                                               kept_.begin());
    }

    template <class Vector>
    void make_finite(std::vector<Vector>& values, const char* name) {
        std::size_t bad = 0;
        for (Vector& value : values)
            for (int c = 0; c < Vector::length(); ++c)
                if (!std::isfinite(value[c])) {
                    value[c] = 0.0f;
                    ++bad;
                }
        if (bad > 0)
            document_.warn(attribute_name(name),
                           std::to_string(bad) + " values were not finite and became 0");
    }

    void read_texture_coordinates() {
        if (has("TEXCOORD_0")) {
            mesh_.uv0 = reader("TEXCOORD_0", 2, 2).read<2>(kept_);
            make_finite(mesh_.uv0, "TEXCOORD_0");
        }
        if (has("TEXCOORD_1")) {
            mesh_.uv1 = reader("TEXCOORD_1", 2, 2).read<2>(kept_);
            make_finite(mesh_.uv1, "TEXCOORD_1");
        }
    }

    void read_colours() {
        if (!has("COLOR_0")) return;
        mesh_.colours = reader("COLOR_0", 3, 4).read<4>(kept_, 1.0f, true);
        make_finite(mesh_.colours, "COLOR_0");
    }

    /// glTF 2.0, section 3.7.2.1: without normals, given tangents are ignored.
    void read_normals_and_tangents() {
        if (mesh_.topology != Topology::triangles || !has("NORMAL")) return;
        mesh_.normals = reader("NORMAL", 3, 3).read<3>(kept_);
        make_finite(mesh_.normals, "NORMAL");
        for (glm::vec3& normal : mesh_.normals)
            normal = unit_or(normal, {0.0f, 1.0f, 0.0f});
        if (!has("TANGENT")) return;
        mesh_.tangents = reader("TANGENT", 4, 4).read<4>(kept_);
        make_finite(mesh_.tangents, "TANGENT");
        for (std::size_t i = 0; i < mesh_.tangents.size(); ++i) {
            glm::vec4& tangent = mesh_.tangents[i];
            const glm::vec3 direction = unit_or(glm::vec3{tangent}, any_perpendicular(mesh_.normals[i]));
            tangent = {direction, tangent.w < 0.0f ? -1.0f : 1.0f};
        }
    }

    /// Vectors that are unit length to storage accuracy keep their bits.
    static glm::vec3 unit_or(glm::vec3 v, glm::vec3 fallback) {
        const float length_squared = glm::dot(v, v);
        constexpr float k_storage_error = 1e-4f;
        if (std::abs(length_squared - 1.0f) < k_storage_error) return v;
        return length_squared > 1e-12f && std::isfinite(length_squared) ? v / std::sqrt(length_squared)
                                                                        : fallback;
    }

    Document& document_;
    const tinygltf::Primitive& primitive_;
    std::string element_;
    std::uint64_t vertex_count_ = 0;
    std::vector<std::uint32_t> kept_;  ///< vertices to read, ascending; empty means all
    Mesh mesh_;
};

}  // namespace

void import_meshes(Document& document, Scene& scene) {
    std::map<GeometryKey, std::uint32_t> known;
    const std::vector<tinygltf::Mesh>& meshes = document.model.meshes;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        Model model{.name = meshes[m].name, .parts = {}};
        for (std::size_t p = 0; p < meshes[m].primitives.size(); ++p) {
            const tinygltf::Primitive& primitive = meshes[m].primitives[p];
            const std::string element = element_name("meshes", m, element_name(".primitives", p));
            if (attribute(primitive, "POSITION") < 0) {
                document.warn(element, "has no POSITION and is not shown");
                continue;
            }
            std::uint32_t material = k_none;
            if (primitive.material >= 0)
                material = document.checked(primitive.material, scene.materials.size(), element + ".material",
                                            "material");
            const int tangents_for = tangent_uv_set(primitive, scene);
            const auto [place, is_new] = known.try_emplace(key_of(primitive, tangents_for),
                                                           static_cast<std::uint32_t>(scene.meshes.size()));
            if (is_new) {
                scene.meshes.push_back(PrimitiveImport{document, primitive, element}.run(tangents_for));
                scene.meshes.back().name = meshes[m].name;
            }
            if (!scene.meshes[place->second].indices.empty())
                model.parts.push_back({place->second, material});
        }
        scene.models.push_back(std::move(model));
    }
}

}  // namespace rambla::assets::gltf
