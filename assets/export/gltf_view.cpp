#include "assets/export/gltf_view.h"

#include <algorithm>
#include <cmath>

#include "assets/export/gltf_material.h"

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

/// The inner angle must be the smaller one, and the outer one above 0.
Json cone_json(const Light& light) {
    constexpr float k_narrowest_rad = 1e-6f;
    const float outer = std::max(light.outer_cone_rad, k_narrowest_rad);
    return {{"innerConeAngle", std::min(light.inner_cone_rad, std::nextafter(outer, 0.0f))},
            {"outerConeAngle", outer}};
}

Json light_json(const Light& light) {
    const float scale = power_of_two_above(light.colour);
    Json out{{"color", floats(light.colour / scale)}, {"intensity", light.intensity * scale}};
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
            out["spot"] = cone_json(light);
            break;
    }
    return out;
}

}  // namespace

Json views_json(const Scene& scene, std::set<std::string>& extensions) {
    Json out = Json::object();
    for (const Camera& camera : scene.cameras)
        out["cameras"].push_back(camera_json(camera));
    for (const Light& light : scene.lights)
        out["extensions"]["KHR_lights_punctual"]["lights"].push_back(light_json(light));
    if (!scene.lights.empty()) extensions.insert("KHR_lights_punctual");
    return out;
}

}  // namespace rambla::assets
