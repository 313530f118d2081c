#include "assets/export/gltf.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assets/error.h"
#include "assets/export/gltf_geometry.h"
#include "assets/export/gltf_material.h"
#include "assets/export/image.h"
#include "assets/import/gltf_container.h"

namespace rambla::assets {

namespace {

using Json = nlohmann::json;

Json floats(glm::vec3 v) {
    return Json::array({v.x, v.y, v.z});
}

Json camera_json(const Camera& camera) {
    Json out;
    if (!camera.name.empty()) out["name"] = camera.name;
    if (camera.kind == CameraKind::perspective) {
        out["type"] = "perspective";
        out["perspective"] = {{"yfov", camera.vertical_fov_rad}, {"znear", camera.near_m}};
    } else {
        out["type"] = "orthographic";
        out["orthographic"] = {{"xmag", camera.half_width_m},
                               {"ymag", camera.half_height_m},
                               {"znear", camera.near_m},
                               {"zfar", camera.far_m}};
    }
    return out;
}

Json light_json(const Light& light) {
    Json out{{"color", floats(light.colour)}, {"intensity", light.intensity}};
    if (!light.name.empty()) out["name"] = light.name;
    if (light.range_m > 0.0f && light.kind != LightKind::directional) out["range"] = light.range_m;
    switch (light.kind) {
        case LightKind::directional:
            out["type"] = "directional";
            break;
        case LightKind::point:
            out["type"] = "point";
            break;
        case LightKind::spot:
            out["type"] = "spot";
            out["spot"] = {{"innerConeAngle", light.inner_cone_rad},
                           {"outerConeAngle", light.outer_cone_rad}};
            break;
    }
    return out;
}

/// Collects the document, then writes it as one GLB.
class SceneExport {
public:
    explicit SceneExport(const Scene& scene) : scene_{scene} {}

    std::vector<unsigned char> run() {
        document_["asset"] = {{"version", "2.0"}, {"generator", "Rambla"}};
        export_images();
        document_.update(materials_json(scene_, extensions_));
        export_models();
        for (const Camera& camera : scene_.cameras)
            document_["cameras"].push_back(camera_json(camera));
        for (const Light& light : scene_.lights)
            document_["extensions"]["KHR_lights_punctual"]["lights"].push_back(light_json(light));
        if (!scene_.lights.empty()) extensions_.insert("KHR_lights_punctual");
        for (const Node& node : scene_.nodes)
            document_["nodes"].push_back(node_json(node));
        export_scenes();
        geometry_.finish(document_);
        if (!extensions_.empty()) document_["extensionsUsed"] = extensions_;
        return gltf::join_container(document_.dump(-1, ' ', false, Json::error_handler_t::replace),
                                    geometry_.bytes());
    }

private:
    void export_images() {
        for (const Image& image : scene_.images) {
            Json out{{"bufferView", geometry_.add_bytes(encode_png(image))}, {"mimeType", "image/png"}};
            if (!image.name.empty()) out["name"] = image.name;
            document_["images"].push_back(std::move(out));
        }
    }

    /// glTF has no meshes without primitives: models that show nothing get no mesh.
    void export_models() {
        for (const Model& model : scene_.models) {
            Json primitives = Json::array();
            for (const ModelPart& part : model.parts) {
                const Mesh& mesh = scene_.meshes[part.mesh];
                if (mesh.positions.empty() || mesh.indices.empty()) continue;
                Json primitive = geometry_.primitive(mesh, part.mesh);
                if (part.material != k_none) primitive["material"] = part.material;
                primitives.push_back(std::move(primitive));
            }
            mesh_of_model_.push_back(primitives.empty() ? k_none : mesh_count_++);
            if (primitives.empty()) continue;
            Json mesh{{"primitives", std::move(primitives)}};
            if (!model.name.empty()) mesh["name"] = model.name;
            document_["meshes"].push_back(std::move(mesh));
        }
    }

    Json node_json(const Node& node) const {
        Json out = Json::object();
        if (!node.name.empty()) out["name"] = node.name;
        const Transform& local = node.local;
        const Transform identity;
        if (local.translation_m != identity.translation_m) out["translation"] = floats(local.translation_m);
        if (local.rotation != identity.rotation)
            out["rotation"] = {local.rotation.x, local.rotation.y, local.rotation.z, local.rotation.w};
        if (local.scale != identity.scale) out["scale"] = floats(local.scale);
        if (!node.children.empty()) out["children"] = node.children;
        if (node.model != k_none && mesh_of_model_[node.model] != k_none)
            out["mesh"] = mesh_of_model_[node.model];
        if (node.camera != k_none) out["camera"] = node.camera;
        if (node.light != k_none) out["extensions"]["KHR_lights_punctual"]["light"] = node.light;
        return out;
    }

    void export_scenes() {
        std::vector<std::uint32_t> prototypes;
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
            const auto node = static_cast<std::uint32_t>(i);
            const bool is_root =
                std::find(scene_.roots.begin(), scene_.roots.end(), node) != scene_.roots.end();
            if (scene_.nodes[i].parent == k_none && !is_root) prototypes.push_back(node);
        }
        document_["scene"] = 0;
        Json shown = Json::object();
        if (!scene_.name.empty()) shown["name"] = scene_.name;
        if (!scene_.roots.empty()) shown["nodes"] = scene_.roots;
        document_["scenes"].push_back(std::move(shown));
        if (!prototypes.empty())
            document_["scenes"].push_back({{"name", "prototypes"}, {"nodes", prototypes}});
    }

    const Scene& scene_;
    Json document_;
    std::set<std::string> extensions_;
    GltfGeometry geometry_;
    std::vector<std::uint32_t> mesh_of_model_;
    std::uint32_t mesh_count_ = 0;
};

}  // namespace

void export_gltf(const std::filesystem::path& file, const Scene& scene) {
    if (file.extension() != ".glb")
        throw Error{file.string(), "", "the extension \"" + file.extension().string() + "\"", ".glb"};
    const std::vector<unsigned char> glb = SceneExport{scene}.run();
    if (glb.size() > 0xffffffffull)
        throw Error{file.string(), "", std::to_string(glb.size()) + " bytes",
                    "less than 4 GiB, as GLB allows"};
    write_bytes(file, std::as_bytes(std::span{glb}));
}

}  // namespace rambla::assets
