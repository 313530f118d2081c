#include "assets/import/gltf_mesh.h"

#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>
#include <map>
#include <numeric>

#include "assets/import/gltf_accessor.h"
#include "assets/import/gltf_influence.h"
#include "assets/import/gltf_morph.h"
#include "assets/import/gltf_topology.h"
#include "assets/import/gltf_unit.h"
#include "assets/import/gltf_vertices.h"
#include "assets/process/tangents.h"

namespace rambla::assets::gltf {

namespace {

/// What makes two primitives the same geometry: accessors, topology, and the UV set that tangents are made
/// for.
using GeometryKey = std::vector<int>;

/// Tangents are worth their memory only where normals or heights of a texture need them, their time only
/// where the file has none.
int tangent_uv_set(const tinygltf::Primitive& primitive, const Scene& scene) {
    if (attribute(primitive.attributes, "TANGENT") >= 0 && attribute(primitive.attributes, "NORMAL") >= 0)
        return k_no_tangents;
    if (primitive.material < 0 || static_cast<std::size_t>(primitive.material) >= scene.materials.size())
        return k_no_tangents;
    const Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
    for (const TextureSlot& slot : {material.normal_texture, material.height_texture})
        if (slot.texture != k_none) return static_cast<int>(slot.uv_set);
    return k_no_tangents;
}

/// Only what is read counts: exporters repeat geometry with attributes of their own.
void append_known(GeometryKey& key, const Attributes& attributes) {
    for (const char* name : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"})
        key.push_back(attribute(attributes, name));
    for (int set = 0;; ++set) {
        const int joints = attribute(attributes, "JOINTS_" + std::to_string(set));
        if (joints < 0) break;
        key.insert(key.end(), {joints, attribute(attributes, "WEIGHTS_" + std::to_string(set))});
    }
    key.push_back(-1);
}

GeometryKey key_of(const tinygltf::Primitive& primitive, int tangents_for) {
    GeometryKey key{primitive.mode, primitive.indices, tangents_for};
    append_known(key, primitive.attributes);
    for (const Attributes& target : primitive.targets)
        append_known(key, target);
    return key;
}

/// Reads one primitive into a mesh.
class PrimitiveImport {
public:
    PrimitiveImport(Document& document, const tinygltf::Primitive& primitive, std::string element)
        : document_{document},
          primitive_{primitive},
          element_{std::move(element)},
          vertex_count_{AccessorReader{document_, attribute(primitive_.attributes, "POSITION"),
                                       element_ + ".attributes.POSITION"}
                            .count()},
          reader_{document_, element_, vertex_count_} {}

    Mesh run() {
        read_topology();
        keep_referenced_vertices();
        mesh_.positions = read<3>("POSITION");
        if (has("TEXCOORD_0")) mesh_.uv0 = read<2>("TEXCOORD_0", k_texture_coordinates);
        if (has("TEXCOORD_1")) mesh_.uv1 = read<2>("TEXCOORD_1", k_texture_coordinates);
        if (has("COLOR_0")) mesh_.colours = read<4>("COLOR_0", k_colours);
        read_normals_and_tangents();
        if (is_skinned(primitive_.attributes)) read_influences(reader_, primitive_.attributes, mesh_);
        read_morphs(reader_, primitive_, mesh_);
        return std::move(mesh_);
    }

private:
    static constexpr AttributeForm k_texture_coordinates{.least_components = 2, .most_components = 2};
    static constexpr AttributeForm k_colours{
        .least_components = 3, .most_components = 4, .missing = 1.0f, .always_normalise = true};
    static constexpr AttributeForm k_tangents{.least_components = 4, .most_components = 4};

    bool has(const char* name) const { return attribute(primitive_.attributes, name) >= 0; }

    template <int N>
    std::vector<glm::vec<N, float>> read(const char* name, const AttributeForm& form = {},
                                         const Rule<N>& rule = {}) {
        return reader_.read<N>(attribute(primitive_.attributes, name), std::string{"attributes."} + name,
                               form, rule);
    }

    void read_topology() {
        std::vector<std::uint32_t> indices;
        const std::string element = element_ + ".indices";
        if (primitive_.indices >= 0) {
            const AccessorReader source{document_, primitive_.indices, element};
            document_.spend(element, source.count());
            IndexColumn column = source.read_indices();
            check_range(column, element);
            indices = std::move(column.indices);
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

    void check_range(const IndexColumn& column, const std::string& element) const {
        const auto& [indices, largest] = column;
        if (indices.empty() || largest < vertex_count_) return;
        const auto place = std::find(indices.begin(), indices.end(), largest) - indices.begin();
        document_.fail(element, "index " + std::to_string(largest) + " at " + std::to_string(place),
                       "below " + std::to_string(vertex_count_) + ", the number of vertices");
    }

    /// Primitives often share one large vertex buffer; each then takes only what it shows.
    void keep_referenced_vertices() {
        const bool most_are_used = mesh_.indices.size() >= vertex_count_ / 2;
        if (most_are_used || mesh_.indices.empty()) {
            document_.spend(element_, vertex_count_);
            return;
        }
        std::vector<std::uint32_t> kept = mesh_.indices;
        std::sort(kept.begin(), kept.end());
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        document_.spend(element_, kept.size());
        for (std::uint32_t& index : mesh_.indices)
            index =
                static_cast<std::uint32_t>(std::lower_bound(kept.begin(), kept.end(), index) - kept.begin());
        reader_.keep(std::move(kept));
    }

    /// glTF 2.0, section 3.7.2.1: without normals, given tangents are ignored.
    void read_normals_and_tangents() {
        if (mesh_.topology != Topology::triangles || !has("NORMAL")) return;
        const Rule<3> unit{are_unit<glm::vec3>, [](std::span<glm::vec3> normals, std::size_t) {
                               make_unit(normals, [&](std::size_t i) { normals[i] = {0.0f, 1.0f, 0.0f}; });
                           }};
        mesh_.normals = read<3>("NORMAL", {}, unit);
        if (!has("TANGENT")) return;
        const Rule<4> unit_with_sign{
            [](std::span<const glm::vec4> tangents) { return are_unit(tangents) && are_signs(tangents); },
            [&](std::span<glm::vec4> tangents, std::size_t first) {
                make_unit(tangents, [&](std::size_t i) {
                    tangents[i] = {any_perpendicular(mesh_.normals[first + i]), tangents[i].w};
                });
                make_signs(tangents);
            }};
        mesh_.tangents = read<4>("TANGENT", k_tangents, unit_with_sign);
    }

    Document& document_;
    const tinygltf::Primitive& primitive_;
    std::string element_;
    std::uint64_t vertex_count_ = 0;
    VertexReader reader_;
    Mesh mesh_;
};

/// A mesh of the scene to be: the primitive that it comes from, and what became of it.
struct PlannedMesh {
    const tinygltf::Mesh* source = nullptr;
    std::size_t primitive = 0;
    std::string element;
    Mesh mesh;
    std::vector<std::string> warnings;
    std::exception_ptr failure;

    void read(Document& document) {
        const WarningHold hold{warnings};
        try {
            mesh = PrimitiveImport{document, source->primitives[primitive], element}.run();
            mesh.name = source->name;
            for (std::size_t t = 0; t < mesh.morphs.size(); ++t)
                mesh.morphs[t].name = morph_name(*source, t);
        } catch (const std::exception&) {
            failure = std::current_exception();
        }
    }
};

/// Plans which meshes there are, reads them, on all threads if it is worth it, and reports in the order of
/// the document. Only which of them names a file that asks for too much is left to chance.
class MeshesImport {
public:
    MeshesImport(Document& document, Scene& scene) : document_{document}, scene_{scene} {}

    std::vector<MissingColumns> run() {
        for (std::size_t m = 0; m < document_.model.meshes.size(); ++m)
            scene_.models.push_back(model(m));
        const auto read = [&](std::size_t i) {
            planned_[i].read(document_);
        };
        if (is_small()) {
            for (std::size_t i = 0; i < planned_.size(); ++i)
                read(i);
        } else {
            tbb::parallel_for(std::size_t{0}, planned_.size(), read);
        }
        for (PlannedMesh& planned : planned_) {
            for (const std::string& warning : planned.warnings)
                spdlog::warn("{}", warning);
            if (planned.failure) std::rethrow_exception(planned.failure);
            scene_.meshes.push_back(std::move(planned.mesh));
        }
        for (Model& made : scene_.models)
            std::erase_if(made.parts,
                          [&](const ModelPart& part) { return scene_.meshes[part.mesh].indices.empty(); });
        return std::move(missing_);
    }

private:
    /// A millisecond's work at most: what other threads save of it is less than the wait for one that a busy
    /// machine gives no time.
    bool is_small() const {
        constexpr std::uint64_t k_small_bytes = 8 << 20;
        std::uint64_t bytes = 0;
        for (const tinygltf::Buffer& buffer : document_.model.buffers)
            bytes += buffer.data.size();
        return bytes <= k_small_bytes;
    }

    Model model(std::size_t index) {
        const tinygltf::Mesh& source = document_.model.meshes[index];
        const std::string element = element_name("meshes", index);
        const std::size_t targets = morph_count(document_, source, element);
        Model made{.name = source.name,
                   .parts = {},
                   .morph_weights = morph_weights(document_, source.weights, targets, element + ".weights")};
        for (std::size_t p = 0; p < source.primitives.size(); ++p)
            add_part(made, source, p, element + element_name(".primitives", p));
        return made;
    }

    void add_part(Model& made, const tinygltf::Mesh& source, std::size_t index, const std::string& element) {
        const tinygltf::Primitive& primitive = source.primitives[index];
        if (attribute(primitive.attributes, "POSITION") < 0) {
            document_.warn(element, "has no POSITION and is not shown");
            return;
        }
        std::uint32_t material = k_none;
        if (primitive.material >= 0)
            material = document_.checked(primitive.material, scene_.materials.size(), element + ".material",
                                         "material");
        const int tangents_for = tangent_uv_set(primitive, scene_);
        const auto [place, is_new] =
            known_.try_emplace(key_of(primitive, tangents_for), static_cast<std::uint32_t>(planned_.size()));
        if (is_new) {
            planned_.push_back({.source = &source,
                                .primitive = index,
                                .element = element,
                                .mesh = {},
                                .warnings = {},
                                .failure = {}});
            missing_.push_back({tangents_for});
        }
        made.parts.push_back({place->second, material});
    }

    Document& document_;
    Scene& scene_;
    std::map<GeometryKey, std::uint32_t> known_;
    std::vector<PlannedMesh> planned_;
    std::vector<MissingColumns> missing_;
};

void complete(Mesh& mesh, const MissingColumns& missing) {
    if (mesh.topology == Topology::triangles) {
        if (mesh.normals.empty()) compute_flat_normals(mesh);
        if (missing.tangents_for_uv_set != k_no_tangents && mesh.tangents.empty())
            compute_tangents(mesh, static_cast<std::uint32_t>(missing.tangents_for_uv_set));
    }
    for (const glm::vec3& position : mesh.positions)
        mesh.bounds.expand(position);
}

}  // namespace

std::vector<MissingColumns> import_meshes(Document& document, Scene& scene) {
    return MeshesImport{document, scene}.run();
}

void complete_meshes(Scene& scene, std::span<const MissingColumns> missing) {
    tbb::parallel_for(std::size_t{0}, missing.size(),
                      [&](std::size_t i) { complete(scene.meshes[i], missing[i]); });
}

}  // namespace rambla::assets::gltf
