#include "assets/import/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "assets/import/gltf_emitter.h"
#include "assets/import/gltf_files.h"
#include "assets/import/gltf_lod.h"
#include "assets/import/gltf_morph.h"
#include "assets/import/gltf_transform.h"
#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

Camera import_camera(const Document& document, const tinygltf::Camera& source, const std::string& element) {
    constexpr float k_nearest_m = 1e-5f;
    Camera camera;
    camera.name = source.name;
    if (source.type == "orthographic") {
        const tinygltf::OrthographicCamera& view = source.orthographic;
        camera.kind = CameraKind::orthographic;
        camera.half_width_m = std::abs(finite_float(view.xmag));
        camera.half_height_m = std::abs(finite_float(view.ymag));
        camera.near_m = std::max(finite_float(view.znear), 0.0f);
        camera.far_m = finite_float(view.zfar);
        if (!(camera.half_width_m > 0.0f && camera.half_height_m > 0.0f && camera.far_m > camera.near_m))
            document.fail(element + ".orthographic", "a view of no volume",
                          "xmag, ymag > 0 and zfar > znear");
        return camera;
    }
    camera.vertical_fov_rad = finite_float(source.perspective.yfov);
    camera.near_m = std::max(finite_float(source.perspective.znear), k_nearest_m);
    const std::string yfov = element + ".perspective.yfov";
    constexpr float k_widest_rad = 3.0f;
    if (!(camera.vertical_fov_rad > 0.0f))
        document.fail(yfov, number_text(source.perspective.yfov), "between 0 and pi");
    if (camera.vertical_fov_rad > k_widest_rad) {
        document.warn(yfov, number_text(source.perspective.yfov) + " is too wide and became 3");
        camera.vertical_fov_rad = k_widest_rad;
    }
    return camera;
}

Light import_light(const Document& document, const tinygltf::Light& source, const std::string& element) {
    Light light;
    light.name = source.name;
    if (source.type == "directional")
        light.kind = LightKind::directional;
    else if (source.type == "spot")
        light.kind = LightKind::spot;
    else if (source.type != "point")
        document.fail(element + ".type", in_quotes(source.type), "directional, point or spot");
    if (source.color.size() == 3)
        for (int c = 0; c < 3; ++c)
            light.colour[c] = std::max(finite_float(source.color[static_cast<std::size_t>(c)]), 0.0f);
    light.intensity = std::max(finite_float(source.intensity), 0.0f);
    light.range_m = std::max(finite_float(source.range), 0.0f);
    if (light.kind == LightKind::spot) {
        light.outer_cone_rad =
            std::clamp(finite_float(source.spot.outerConeAngle), 0.0f, glm::half_pi<float>());
        if (source.spot.innerConeAngle > source.spot.outerConeAngle)
            document.warn(element + ".spot.innerConeAngle",
                          number_text(source.spot.innerConeAngle) + " is not below outerConeAngle, " +
                              number_text(source.spot.outerConeAngle) + ", and is clamped");
        light.inner_cone_rad =
            std::clamp(finite_float(source.spot.innerConeAngle), 0.0f, light.outer_cone_rad);
    }
    return light;
}

std::uint32_t light_of(const Document& document, const tinygltf::Node& node, const std::string& element) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    if (found == node.extensions.end() || !found->second.Has("light")) return k_none;
    return document.checked(integer_of(found->second, "light", -1), document.model.lights.size(),
                            element + ".extensions.KHR_lights_punctual.light", "light");
}

Node import_node(const Document& document, const Scene& scene, std::size_t index) {
    const tinygltf::Node& source = document.model.nodes[index];
    const std::string element = element_name("nodes", index);
    Node node;
    node.name = source.name;
    node.local = import_transform(document, source, element);
    if (source.mesh >= 0)
        node.model = document.checked(source.mesh, scene.models.size(), element + ".mesh", "mesh");
    if (source.camera >= 0)
        node.camera = document.checked(source.camera, scene.cameras.size(), element + ".camera", "camera");
    node.light = light_of(document, source, element);
    node.emitter = emitter_of(document, scene, source, element);
    if (!source.weights.empty()) {
        const std::size_t targets = node.model == k_none ? 0 : scene.models[node.model].morph_weights.size();
        node.morph_weights = morph_weights(document, source.weights, targets, element + ".weights");
    }
    for (std::size_t c = 0; c < source.children.size(); ++c)
        node.children.push_back(document.checked(source.children[c], document.model.nodes.size(),
                                                 element + element_name(".children", c), "node"));
    return node;
}

void link_parents(const Document& document, Scene& scene) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (std::size_t c = 0; c < scene.nodes[i].children.size(); ++c) {
            Node& child = scene.nodes[scene.nodes[i].children[c]];
            if (child.parent != k_none)
                document.fail(element_name("nodes", i, element_name(".children", c)),
                              "node " + std::to_string(scene.nodes[i].children[c]) +
                                  ", which has the parent " + std::to_string(child.parent),
                              "a node without another parent");
            child.parent = static_cast<std::uint32_t>(i);
        }
}

/// With one parent each, or one node that they are a level of, nodes are on a loop or below one exactly if no
/// other node reaches them.
void refuse_loops(const Document& document, const Scene& scene, const std::vector<bool>& is_level) {
    std::vector<std::uint32_t> open;
    std::vector<bool> reached(scene.nodes.size(), false);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].parent == k_none && !is_level[i]) open.push_back(static_cast<std::uint32_t>(i));
    while (!open.empty()) {
        const Node& node = scene.nodes[open.back()];
        reached[open.back()] = true;
        open.pop_back();
        open.insert(open.end(), node.children.begin(), node.children.end());
        open.insert(open.end(), node.coarser.begin(), node.coarser.end());
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost != reached.end())
        document.fail(element_name("nodes", static_cast<std::size_t>(lost - reached.begin())),
                      "a loop of children or levels of detail", "a tree");
}

/// glTF knows no sky. Extras are anybody's: what is no time is left out, not an error.
void read_time(const Document& document, const tinygltf::Scene& source, const std::string& element,
               Scene& scene) {
    if (!source.extras.IsObject() || !source.extras.Has("ramblaTime")) return;
    const tinygltf::Value& text = source.extras.Get("ramblaTime");
    if (text.IsString()) scene.time = time_from_text(text.Get<std::string>());
    if (!scene.time)
        document.warn(element + ".extras.ramblaTime", "is neither \"noon\" nor HH:MM, and is left out");
}

void read_roots(const Document& document, Scene& scene) {
    const tinygltf::Model& model = document.model;
    if (model.scenes.empty()) return;
    const std::uint32_t chosen =
        document.checked(std::max(model.defaultScene, 0), model.scenes.size(), "scene", "scene");
    const tinygltf::Scene& source = model.scenes[chosen];
    if (!source.name.empty()) scene.name = source.name;
    read_time(document, source, element_name("scenes", chosen), scene);
    std::vector<bool> listed(scene.nodes.size(), false);
    for (std::size_t i = 0; i < source.nodes.size(); ++i) {
        const std::string element = element_name("scenes", chosen, element_name(".nodes", i));
        const std::uint32_t root = document.checked(source.nodes[i], scene.nodes.size(), element, "node");
        if (scene.nodes[root].parent != k_none || listed[root])
            document.fail(element, "node " + std::to_string(root) + ", a child or a repetition", "a root");
        listed[root] = true;
        scene.roots.push_back(root);
    }
}

/// Everything that stands on its own, in a document without scenes.
void find_roots(Scene& scene, const std::vector<bool>& is_level) {
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].parent == k_none && !is_level[i])
            scene.roots.push_back(static_cast<std::uint32_t>(i));
}

}  // namespace

void import_nodes(const Document& document, Scene& scene) {
    const tinygltf::Model& model = document.model;
    for (std::size_t i = 0; i < model.cameras.size(); ++i)
        scene.cameras.push_back(import_camera(document, model.cameras[i], element_name("cameras", i)));
    for (std::size_t i = 0; i < model.lights.size(); ++i)
        scene.lights.push_back(import_light(document, model.lights[i],
                                            element_name("extensions.KHR_lights_punctual.lights", i)));
    scene.nodes.reserve(model.nodes.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        scene.nodes.push_back(import_node(document, scene, i));
    link_parents(document, scene);
    read_roots(document, scene);
    const std::vector<bool> is_level = import_levels(document, scene);
    refuse_loops(document, scene, is_level);
    if (model.scenes.empty()) find_roots(scene, is_level);
}

}  // namespace rambla::assets::gltf
