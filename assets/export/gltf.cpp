#include "assets/export/gltf.h"

#include <nlohmann/json.hpp>

#include "assets/error.h"
#include "assets/export/gltf_animation.h"
#include "assets/export/gltf_buffer.h"
#include "assets/export/gltf_emitter.h"
#include "assets/export/gltf_geometry.h"
#include "assets/export/gltf_material.h"
#include "assets/export/gltf_view.h"
#include "assets/export/image.h"
#include "assets/import/gltf_container.h"

namespace rambla::assets {

namespace {

using Json = nlohmann::json;

Json floats(glm::vec3 v) {
    return Json::array({v.x, v.y, v.z});
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
        export_skeletons();
        document_.update(views_json(scene_, extensions_));
        if (!scene_.emitters.empty()) document_["extras"]["ramblaEmitters"] = emitters_json(scene_);
        for (const Node& node : scene_.nodes)
            document_["nodes"].push_back(node_json(node));
        export_clips();
        export_scenes();
        buffer_.finish(document_);
        if (!extensions_.empty()) document_["extensionsUsed"] = extensions_;
        return gltf::join_container(document_.dump(-1, ' ', false, Json::error_handler_t::replace),
                                    buffer_.bytes());
    }

private:
    void export_images() {
        for (const Image& image : scene_.images) {
            Json out{{"bufferView", buffer_.add_bytes(encode_png(image))}, {"mimeType", "image/png"}};
            if (!image.name.empty()) out["name"] = image.name;
            document_["images"].push_back(std::move(out));
        }
    }

    void export_models() {
        GltfGeometry geometry{scene_, buffer_};
        for (const Model& model : scene_.models)
            mesh_of_model_.push_back(append("meshes", geometry.mesh_of(model)));
    }

    void export_skeletons() {
        for (const Skeleton& skeleton : scene_.skeletons)
            skin_of_skeleton_.push_back(
                append("skins", skeleton.joints.empty() ? Json{} : animation_.skin_of(skeleton)));
    }

    void export_clips() {
        std::vector<bool> has_mesh;
        for (const Node& node : scene_.nodes)
            has_mesh.push_back(mesh_of(node) != k_none);
        for (const Clip& clip : scene_.clips)
            append("animations", animation_.animation_of(clip, has_mesh));
    }

    /// @return  index of the element in the document's array, k_none for null, which is left out
    std::uint32_t append(const char* array, Json element) {
        if (element.is_null()) return k_none;
        document_[array].push_back(std::move(element));
        return static_cast<std::uint32_t>(document_[array].size() - 1);
    }

    std::uint32_t mesh_of(const Node& node) const {
        return node.model == k_none ? k_none : mesh_of_model_[node.model];
    }

    Json node_json(const Node& node) {
        Json out = Json::object();
        if (!node.name.empty()) out["name"] = node.name;
        const Transform& local = node.local;
        const Transform identity;
        if (local.translation_m != identity.translation_m) out["translation"] = floats(local.translation_m);
        if (local.rotation != identity.rotation)
            out["rotation"] = {local.rotation.x, local.rotation.y, local.rotation.z, local.rotation.w};
        if (local.scale != identity.scale) out["scale"] = floats(local.scale);
        if (!node.children.empty()) out["children"] = node.children;
        if (const std::uint32_t mesh = mesh_of(node); mesh != k_none) {
            out["mesh"] = mesh;
            if (!node.morph_weights.empty()) out["weights"] = node.morph_weights;
            if (node.skeleton != k_none && skin_of_skeleton_[node.skeleton] != k_none)
                out["skin"] = skin_of_skeleton_[node.skeleton];
        }
        if (node.camera != k_none) out["camera"] = node.camera;
        if (node.light != k_none) out["extensions"]["KHR_lights_punctual"]["light"] = node.light;
        if (node.emitter != k_none) out["extras"]["ramblaEmitter"] = node.emitter;
        if (!node.coarser.empty()) {
            extensions_.insert("MSFT_lod");
            out["extensions"]["MSFT_lod"]["ids"] = node.coarser;
            if (!node.screen_coverage.empty()) out["extras"]["MSFT_screencoverage"] = node.screen_coverage;
        }
        return out;
    }

    void export_scenes() {
        // Coarser levels stand in no scene: whoever ignores the extension would show them all at once.
        std::vector<bool> placed(scene_.nodes.size(), false);
        for (const std::uint32_t root : scene_.roots)
            placed[root] = true;
        for (const Node& node : scene_.nodes)
            for (const std::uint32_t level : node.coarser)
                placed[level] = true;
        std::vector<std::uint32_t> prototypes;
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i)
            if (scene_.nodes[i].parent == k_none && !placed[i])
                prototypes.push_back(static_cast<std::uint32_t>(i));
        document_["scene"] = 0;
        Json shown = Json::object();
        if (!scene_.name.empty()) shown["name"] = scene_.name;
        if (!scene_.roots.empty()) shown["nodes"] = scene_.roots;
        if (scene_.time) shown["extras"]["ramblaTime"] = to_text(*scene_.time);
        document_["scenes"].push_back(std::move(shown));
        if (!prototypes.empty())
            document_["scenes"].push_back({{"name", "prototypes"}, {"nodes", prototypes}});
    }

    const Scene& scene_;
    Json document_;
    std::set<std::string> extensions_;
    GltfBuffer buffer_;
    GltfAnimation animation_{buffer_};
    std::vector<std::uint32_t> mesh_of_model_;
    std::vector<std::uint32_t> skin_of_skeleton_;
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
