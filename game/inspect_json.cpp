#include "game/inspect_json.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "assets/mesh_columns.h"
#include "assets/scene.h"
#include "game/inspect_surface.h"

namespace rambla::game {
namespace {

using Json = nlohmann::json;
using namespace assets;

constexpr const char* k_schema = "rambla.inspect/1";

/// Calls `row` with each element, and gives its JSON object the element's index.
template <class T, class Row>
Json rows(const std::vector<T>& elements, Row&& row) {
    Json list = Json::array();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        list.push_back(row(elements[i], i));
        list.back()["index"] = i;
    }
    return list;
}

template <class... T>
std::uint64_t bytes_of(const std::vector<T>&... columns) {
    return (std::uint64_t{0} + ... + (columns.size() * sizeof(T)));
}

std::uint64_t bytes_of(const Mesh& mesh) {
    std::uint64_t bytes = bytes_of(mesh.indices);
    for_each_column(mesh, [&](const auto& column) { bytes += bytes_of(column); });
    return bytes;
}

const char* name_of(Topology topology) {
    switch (topology) {
        case Topology::points:
            return "points";
        case Topology::lines:
            return "lines";
        case Topology::triangles:
            break;
    }
    return "triangles";
}

std::size_t corners(Topology topology) {
    return topology == Topology::points ? 1 : topology == Topology::lines ? 2 : 3;
}

std::size_t triangles_of(const Mesh& mesh) {
    return mesh.topology == Topology::triangles ? mesh.indices.size() / 3 : 0;
}

Json attributes_of(const Mesh& mesh) {
    Json names = Json::array({"position"});
    if (!mesh.normals.empty()) names.push_back("normal");
    if (!mesh.tangents.empty()) names.push_back("tangent");
    if (!mesh.uv0.empty()) names.push_back("uv0");
    if (!mesh.uv1.empty()) names.push_back("uv1");
    if (!mesh.colours.empty()) names.push_back("colour");
    if (!mesh.joints.empty()) names.push_back("joints");
    if (!mesh.weights.empty()) names.push_back("weights");
    return names;
}

Json mesh_row(const Mesh& mesh) {
    Json morphs = Json::array();
    for (const MorphTarget& target : mesh.morphs)
        morphs.push_back(target.name);
    Json bounds = nullptr;
    if (!mesh.bounds.empty()) bounds = {{"min", numbers(mesh.bounds.min)}, {"max", numbers(mesh.bounds.max)}};
    return {{"name", mesh.name},
            {"topology", name_of(mesh.topology)},
            {"vertices", mesh.positions.size()},
            {"elements", mesh.indices.size() / corners(mesh.topology)},
            {"attributes", attributes_of(mesh)},
            {"morph_targets", morphs},
            {"bounds_m", bounds},
            {"bytes", bytes_of(mesh)}};
}

Json model_row(const Scene& scene, const Model& model) {
    Json parts = Json::array();
    std::size_t triangles = 0;
    for (const ModelPart& part : model.parts) {
        parts.push_back({{"mesh", part.mesh}, {"material", index_or_null(part.material)}});
        triangles += triangles_of(scene.meshes[part.mesh]);
    }
    return {{"name", model.name},
            {"parts", parts},
            {"triangles", triangles},
            {"morph_weights", model.morph_weights}};
}

Json node_row(const Node& node) {
    return {{"name", node.name},
            {"parent", index_or_null(node.parent)},
            {"children", node.children},
            {"translation_m", numbers(node.local.translation_m)},
            {"rotation_xyzw",
             {node.local.rotation.x, node.local.rotation.y, node.local.rotation.z, node.local.rotation.w}},
            {"scale", numbers(node.local.scale)},
            {"model", index_or_null(node.model)},
            {"skeleton", index_or_null(node.skeleton)},
            {"camera", index_or_null(node.camera)},
            {"light", index_or_null(node.light)},
            {"emitter", index_or_null(node.emitter)},
            {"morph_weights", node.morph_weights},
            {"coarser", node.coarser},
            {"screen_coverage", node.screen_coverage}};
}

const char* name_of(Interpolation interpolation) {
    switch (interpolation) {
        case Interpolation::step:
            return "step";
        case Interpolation::cubic_spline:
            return "cubic spline";
        case Interpolation::linear:
            break;
    }
    return "linear";
}

Json clip_row(const Clip& clip) {
    std::set<std::uint32_t> nodes;
    std::set<std::string> interpolations;
    std::set<std::string> paths;
    std::size_t keys = 0;
    for (const Channel& channel : clip.channels) {
        nodes.insert(channel.node);
        interpolations.insert(name_of(channel.interpolation));
        paths.insert(name_of(channel.path));
        keys += channel.times_s.size();
    }
    return {{"name", clip.name}, {"duration_s", clip.duration_s},
            {"keys", keys},      {"channels", clip.channels.size()},
            {"nodes", nodes},    {"interpolations", interpolations},
            {"paths", paths}};
}

Json skeleton_row(const Scene& scene, const Skeleton& skeleton) {
    Json names = Json::array();
    for (const std::uint32_t joint : skeleton.joints)
        names.push_back(scene.nodes[joint].name);
    return {{"name", skeleton.name},
            {"joint_count", skeleton.joints.size()},
            {"joints", skeleton.joints},
            {"joint_names", names}};
}

Json camera_row(const Camera& camera) {
    if (camera.kind == CameraKind::perspective)
        return {{"name", camera.name},
                {"kind", "perspective"},
                {"vertical_fov_deg", glm::degrees(camera.vertical_fov_rad)},
                {"near_m", camera.near_m}};
    return {{"name", camera.name},
            {"kind", "orthographic"},
            {"half_width_m", camera.half_width_m},
            {"half_height_m", camera.half_height_m},
            {"near_m", camera.near_m},
            {"far_m", camera.far_m}};
}

Json emitter_row(const Emitter& emitter) {
    return {{"name", emitter.name},
            {"material", index_or_null(emitter.material)},
            {"particles", emitter.count},
            {"lifetime_s", emitter.lifetime_s},
            {"spread_m", emitter.spread_m},
            {"velocity_m_s", numbers(emitter.velocity_m_s)},
            {"velocity_spread_m_s", emitter.velocity_spread_m_s},
            {"acceleration_m_s2", numbers(emitter.acceleration_m_s2)},
            {"start_radius_m", emitter.start_radius_m},
            {"end_radius_m", emitter.end_radius_m}};
}

Json light_row(const Light& light) {
    Json row{{"name", light.name}, {"colour", numbers(light.colour)}, {"intensity", light.intensity}};
    if (light.range_m > 0.0f) row["range_m"] = light.range_m;
    row["kind"] = light.kind == LightKind::directional ? "directional"
                  : light.kind == LightKind::spot      ? "spot"
                                                       : "point";
    if (light.kind == LightKind::spot) {
        row["inner_cone_deg"] = glm::degrees(light.inner_cone_rad);
        row["outer_cone_deg"] = glm::degrees(light.outer_cone_rad);
    }
    return row;
}

/// Triangles count as often as nodes show them; memory counts once.
Json totals_of(const GltfWithFacts& gltf) {
    const Scene& scene = gltf.scene;
    std::uint64_t triangles = 0;
    for (const Node& node : scene.nodes)
        if (node.model != k_none)
            for (const ModelPart& part : scene.models[node.model].parts)
                triangles += triangles_of(scene.meshes[part.mesh]);
    std::uint64_t vertices = 0;
    std::uint64_t mesh_bytes = 0;
    for (const Mesh& mesh : scene.meshes) {
        vertices += mesh.positions.size();
        mesh_bytes += bytes_of(mesh);
    }
    std::uint64_t image_bytes = 0;
    for (const Image& image : scene.images)
        image_bytes += image.texels.size();
    std::uint64_t clip_bytes = 0;
    for (const Clip& clip : scene.clips)
        for (const Channel& channel : clip.channels)
            clip_bytes += bytes_of(channel.times_s, channel.values);
    std::uint64_t encoded_image_bytes = 0;
    for (const ImageFacts& image : gltf.facts.images)
        encoded_image_bytes += image.encoded_bytes;
    return {{"triangles_of_all_nodes", triangles},
            {"vertices", vertices},
            {"document_bytes", gltf.facts.document_bytes},
            {"buffer_bytes", gltf.facts.buffer_bytes},
            {"encoded_image_bytes", encoded_image_bytes},
            {"mesh_bytes", mesh_bytes},
            {"image_bytes", image_bytes},
            {"clip_bytes", clip_bytes},
            {"memory_bytes", mesh_bytes + image_bytes + clip_bytes}};
}

}  // namespace

Json inspection(const std::filesystem::path& file, const GltfWithFacts& gltf,
                const std::vector<std::string>& warnings) {
    const Scene& scene = gltf.scene;
    const GltfFacts& facts = gltf.facts;
    return {{"schema", k_schema},
            {"file", file.string()},
            {"kind", "glTF"},
            {"version", facts.version},
            {"generator", facts.generator},
            {"extensions_used", facts.extensions_used},
            {"extensions_required", facts.extensions_required},
            {"extensions_ignored", facts.extensions_ignored},
            {"default_scene", index_or_null(facts.default_scene)},
            {"shown_nodes", scene.roots},
            {"totals", totals_of(gltf)},
            {"scenes", rows(facts.scenes,
                            [](const SceneFacts& s, std::size_t) {
                                return Json{{"name", s.name}, {"roots", s.roots}};
                            })},
            {"nodes", rows(scene.nodes, [](const Node& n, std::size_t) { return node_row(n); })},
            {"models", rows(scene.models, [&](const Model& m, std::size_t) { return model_row(scene, m); })},
            {"meshes", rows(scene.meshes, [](const Mesh& m, std::size_t) { return mesh_row(m); })},
            {"materials", rows(scene.materials,
                               [&](const Material& m, std::size_t i) {
                                   return inspected_material(m, facts.material_extensions[i]);
                               })},
            {"textures",
             rows(scene.textures, [](const Texture& t, std::size_t) { return inspected_texture(t); })},
            {"images",
             rows(scene.images,
                  [&](const Image&, std::size_t i) { return inspected_image(scene, i, facts.images[i]); })},
            {"skeletons",
             rows(scene.skeletons, [&](const Skeleton& s, std::size_t) { return skeleton_row(scene, s); })},
            {"clips", rows(scene.clips, [](const Clip& c, std::size_t) { return clip_row(c); })},
            {"cameras", rows(scene.cameras, [](const Camera& c, std::size_t) { return camera_row(c); })},
            {"lights", rows(scene.lights, [](const Light& l, std::size_t) { return light_row(l); })},
            {"emitters", rows(scene.emitters, [](const Emitter& e, std::size_t) { return emitter_row(e); })},
            {"warnings", warnings}};
}

Json inspection(const std::filesystem::path& file, const ImageWithFacts& picture) {
    const PictureFacts& facts = picture.facts;
    return {{"schema", k_schema},
            {"file", file.string()},
            {"kind", "picture"},
            {"encoding", facts.format},
            {"width_px", facts.width},
            {"height_px", facts.height},
            {"channels", facts.channels},
            {"sample", facts.sample},
            {"format", inspected_format(picture.image)},
            {"file_bytes", facts.file_bytes},
            {"bytes", picture.image.texels.size()}};
}

}  // namespace rambla::game
