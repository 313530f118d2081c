#include "assets/generate/haze.h"

#include "assets/generate/node.h"

namespace rambla::assets::generate {

namespace {

/// Adds both; the material gets the emitter's name. @return  the emitter's index
std::uint32_t add(Scene& scene, Emitter emitter, Material material) {
    material.name = emitter.name;
    emitter.material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.emitters.push_back(std::move(emitter));
    return static_cast<std::uint32_t>(scene.emitters.size() - 1);
}

Material haze(float albedo, float optical_depth) {
    Material material;
    material.base_colour = {albedo, albedo, albedo, 1.0f};
    material.metalness = 0.0f;
    material.optical_depth = optical_depth;
    return material;
}

}  // namespace

std::uint32_t add_glow(Scene& scene, const std::string& name, glm::vec3 radiance, float radius_m,
                       float optical_depth) {
    Material material = haze(0.0f, optical_depth);
    material.base_colour.w = 0.0f;
    material.emissive = radiance;
    Emitter emitter;
    emitter.name = name;
    emitter.start_radius_m = emitter.end_radius_m = radius_m;
    return add(scene, std::move(emitter), std::move(material));
}

std::uint32_t add_smoke(Scene& scene) {
    Emitter emitter;
    emitter.name = "smoke";
    emitter.count = 32;  // so many that each begins before the one below has left
    emitter.lifetime_s = 7.0f;
    emitter.spread_m = 0.05f;
    emitter.velocity_m_s = {0.1f, 0.55f, 0.0f};
    emitter.velocity_spread_m_s = 0.1f;
    emitter.acceleration_m_s2 = {0.12f, -0.04f, 0.03f};
    emitter.start_radius_m = 0.22f;
    emitter.end_radius_m = 1.0f;
    return add(scene, std::move(emitter), haze(0.6f, 0.55f));
}

std::uint32_t add_vapour(Scene& scene) {
    Emitter emitter;
    emitter.name = "vapour";
    emitter.count = 8;
    emitter.lifetime_s = 4.0f;
    emitter.spread_m = 0.25f;
    emitter.velocity_m_s = {0.05f, 0.35f, 0.0f};
    emitter.velocity_spread_m_s = 0.06f;
    emitter.acceleration_m_s2 = {0.03f, -0.03f, 0.0f};
    emitter.start_radius_m = 0.2f;
    emitter.end_radius_m = 0.7f;
    return add(scene, std::move(emitter), haze(0.8f, 0.3f));
}

void add_emitter_node(Scene& scene, std::uint32_t emitter, std::uint32_t parent, glm::vec3 at_m,
                      const glm::quat& rotation) {
    Transform local;
    local.translation_m = at_m;
    local.rotation = glm::conjugate(rotation);
    scene.nodes[add_node(scene, scene.emitters[emitter].name, parent, local)].emitter = emitter;
}

}  // namespace rambla::assets::generate
