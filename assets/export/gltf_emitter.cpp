#include "assets/export/gltf_emitter.h"

namespace rambla::assets {

namespace {

nlohmann::json numbers(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

}  // namespace

nlohmann::json emitters_json(const Scene& scene) {
    nlohmann::json list = nlohmann::json::array();
    for (const Emitter& emitter : scene.emitters) {
        nlohmann::json& out = list.emplace_back();
        if (!emitter.name.empty()) out["name"] = emitter.name;
        if (emitter.material != k_none) out["material"] = emitter.material;
        out["count"] = emitter.count;
        out["lifetime"] = emitter.lifetime_s;
        out["spread"] = emitter.spread_m;
        out["velocity"] = numbers(emitter.velocity_m_s);
        out["velocitySpread"] = emitter.velocity_spread_m_s;
        out["acceleration"] = numbers(emitter.acceleration_m_s2);
        out["startRadius"] = emitter.start_radius_m;
        out["endRadius"] = emitter.end_radius_m;
    }
    return list;
}

}  // namespace rambla::assets
