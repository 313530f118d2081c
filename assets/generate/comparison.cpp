#include "assets/generate/comparison.h"

#include <cmath>
#include <numbers>

#include "assets/generate/node.h"

namespace rambla::assets::generate {

namespace {

constexpr float k_ground_half_m = 200.0f;

/// Ambient light is one radiance from everywhere, apart from the sky that is seen: houses that hide all of
/// the sky leave surfaces in the light of ground_radiance alone. Below the horizon the renderer lets the
/// sky's colour pass into it.
Environment comparison_light() {
    constexpr float k_sun_illuminance = 3.0f;
    constexpr glm::vec3 k_sun_colour{1.0f, 0.96f, 0.90f};
    constexpr glm::vec3 k_sky{0.5f, 0.6f, 0.8f};
    return {.direction_to_sun = -glm::normalize(glm::vec3{-0.5f, -1.0f, -0.3f}),
            .sun_illuminance = k_sun_illuminance * k_sun_colour,
            .sky_zenith_radiance = k_sky,
            .sky_horizon_radiance = k_sky,
            .ground_radiance = glm::vec3{0.35f},
            .sky_visibility = 0.0f};
}

CameraKey camera_in_frame(int frame) {
    const double angle = std::numbers::pi * frame / k_comparison_frames;
    return {static_cast<float>(frame / 60.0),
            glm::vec3{glm::dvec3{130.0 * std::cos(angle), 70.0, 130.0 * std::sin(angle)}}, glm::vec3{0.0f}};
}

}  // namespace

Place comparison_place(const std::string& name) {
    Place place;
    place.scene.name = name;
    place.environment = comparison_light();
    for (int frame = 0; frame < k_comparison_frames; ++frame)
        place.walk.push_back(camera_in_frame(frame));
    place.walk_fov_rad = static_cast<float>(std::numbers::pi / 3.0);
    place.walk_near_m = 0.5f;

    Builder builder;
    constexpr float h = k_ground_half_m;
    builder.face(Surface::plain, {-h, 0.0f, h}, {h, 0.0f, h}, {h, 0.0f, -h}, {-h, 0.0f, -h});
    const std::uint32_t node = add_node(place.scene, "ground", k_none, {});
    place.scene.nodes[node].model = add_plain_model(
        place.scene, "ground", builder, add_plain_material(place.scene, "ground", glm::vec3{0.35f}));
    place.scene.roots.push_back(node);
    return place;
}

std::uint32_t add_plain_material(Scene& scene, const std::string& name, glm::vec3 albedo) {
    Material material;
    material.name = name;
    material.base_colour = {albedo, 1.0f};
    material.metalness = 0.0f;
    material.roughness = 0.8f;
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t add_plain_model(Scene& scene, const std::string& name, Builder& builder,
                              std::uint32_t material) {
    Model model{name, {}};
    for (Builder::Part& part : builder.take(name)) {
        scene.meshes.push_back(std::move(part.mesh));
        model.parts.push_back({static_cast<std::uint32_t>(scene.meshes.size() - 1), material});
    }
    scene.models.push_back(std::move(model));
    return static_cast<std::uint32_t>(scene.models.size() - 1);
}

}  // namespace rambla::assets::generate
