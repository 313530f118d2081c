#include "support/sample_scenes.h"

namespace rambla::assets::test {

namespace {

Image checker() {
    Image image{.name = "checker", .width = 2, .height = 2, .format = PixelFormat::rgba8, .texels = {}};
    for (const int value : {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 9, 8, 7, 255})
        image.texels.push_back(static_cast<std::byte>(value));
    return image;
}

void set_bounds(Scene& scene) {
    for (Mesh& mesh : scene.meshes)
        for (const glm::vec3& position : mesh.positions)
            mesh.bounds.expand(position);
}

/// Two triangles that bend between two joints and have two morph targets.
Mesh skinned_mesh() {
    Mesh mesh;
    mesh.name = "sail";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.1f}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.joints = {{0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
    mesh.weights = {{0.75f, 0.25f, 0, 0}, {0.5f, 0.5f, 0, 0}, {1, 0, 0, 0}, {0.875f, 0.125f, 0, 0}};
    mesh.morphs.resize(2);
    mesh.morphs[0].name = "wide";
    mesh.morphs[0].positions.assign(4, {0.5f, 0, 0});
    mesh.morphs[0].normals.assign(4, {0, 0.1f, 0});
    mesh.morphs[0].tangents.assign(4, {0, 0, 0.2f});
    mesh.morphs[1].name = "deep";
    mesh.morphs[1].positions = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}};
    mesh.morphs[1].normals.assign(4, {0, 0, 0});
    mesh.morphs[1].tangents.assign(4, {0, 0, 0});
    mesh.indices = {0, 1, 2, 2, 1, 3};
    return mesh;
}

Mesh triangle(float size) {
    Mesh mesh;
    mesh.name = "leaf";
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    return mesh;
}

std::vector<Channel> all_channels() {
    const float half = 0.70710678f;
    return {{.node = 1,
             .path = AnimatedPath::translation,
             .interpolation = Interpolation::linear,
             .width = 3,
             .times_s = {0.0f, 0.5f, 1.25f},
             .values = {0, 0, 0, 1, 2, 3, 0.1f, 0.2f, 0.3f}},
            {.node = 1,
             .path = AnimatedPath::rotation,
             .interpolation = Interpolation::linear,
             .width = 4,
             .times_s = {0.0f, 1.0f},
             .values = {0, 0, 0, 1, 0, half, 0, half}},
            {.node = 2,
             .path = AnimatedPath::scale,
             .interpolation = Interpolation::step,
             .width = 3,
             .times_s = {0.0f, 0.5f, 1.25f},
             .values = {1, 1, 1, 2, 2, 2, 1, 0.5f, 1}},
            {.node = 2,
             .path = AnimatedPath::translation,
             .interpolation = Interpolation::cubic_spline,
             .width = 3,
             .times_s = {0.0f, 2.0f},
             .values = {0, 0, 0, 0, 1, 0, 0.5f, 0, 0, 0, 0, 0.25f, 0, 2, 0, 0, 0, 0}}};
}

}  // namespace

Scene standing_scene() {
    Scene scene;
    scene.name = "all";
    scene.images = {checker()};
    scene.textures = {{.name = "c", .image = 0, .colour_space = ColourSpace::srgb, .sampler = {}},
                      {.name = "n",
                       .image = 0,
                       .colour_space = ColourSpace::linear,
                       .sampler = {.wrap_u = WrapMode::mirrored_repeat,
                                   .wrap_v = WrapMode::clamp_to_edge,
                                   .magnify = Filter::nearest,
                                   .minify = Filter::nearest,
                                   .mip = MipFilter::linear}}};
    scene.time = TimeOfDay{1195};
    Material material;
    material.name = "brick";
    material.base_colour = {0.1f, 0.2f, 0.3f, 0.4f};
    material.metalness = 0.7f;
    material.roughness = 0.6f;
    material.emissive = {8.0f, 2.0f, 0.0f};
    material.alpha_mode = AlphaMode::mask;
    material.alpha_cutoff = 0.3f;
    material.double_sided = true;
    material.base_colour_texture = {
        .texture = 0, .uv_set = 1, .offset = {0.5f, 0.25f}, .scale = {2, 3}, .rotation_rad = 0.5f};
    material.normal_texture.texture = 1;
    material.normal_scale = 0.5f;
    material.height_texture = {.texture = 1, .scale = {2, 2}};
    material.height_depth = 0.0625f;
    material.light_map_texture = {.texture = 0, .uv_set = 1, .scale = {0.5f, 0.5f}};
    material.light_map_strength = 17.5f;
    Material plain;
    plain.unlit = true;
    plain.alpha_mode = AlphaMode::blend;
    Material glass;
    glass.ior = 1.33f;
    glass.specular = 0.5f;
    glass.specular_colour = {0.25f, 2.0f, 0.1f};
    glass.specular_texture.texture = 1;
    glass.specular_colour_texture = {.texture = 0, .uv_set = 1, .offset = {0.5f, 0.0f}};
    glass.transmission = 0.7f;
    glass.transmission_texture.texture = 1;
    scene.materials = {material, plain, glass};
    Mesh mesh;
    mesh.name = "house";
    mesh.positions = {{0, 0, 0.1f}, {1, 0, 0}, {0, 1, 1.0f / 3.0f}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, -1});
    mesh.uv0 = {{0, 0}, {1, 0}, {0, 1}};
    mesh.uv1 = {{0.5f, 0}, {1, 0.1f}, {0, 1}};
    mesh.colours.assign(3, {0.1f, 0.2f, 0.3f, 1.0f});
    mesh.indices = {0, 1, 2};
    Mesh lines;
    lines.name = "house";
    lines.topology = Topology::lines;
    lines.positions = {{0, 0, 0}, {1, 1, 1}};
    lines.indices = {0, 1};
    scene.meshes = {mesh, lines};
    scene.models = {{.name = "house", .parts = {{0, 0}, {1, 1}, {0, 1}}}};
    Camera ortho;
    ortho.kind = CameraKind::orthographic;
    ortho.far_m = 50.0f;
    scene.cameras = {Camera{}, ortho};
    scene.lights = {{.name = "sun", .kind = LightKind::directional, .intensity = 3.0f},
                    {.name = "lamp",
                     .kind = LightKind::spot,
                     .colour = {1, 0.5f, 0.25f},
                     .intensity = 40,
                     .range_m = 12,
                     .inner_cone_rad = 0.25f,
                     .outer_cone_rad = 0.5f}};
    Material smoke;
    smoke.name = "smoke";
    smoke.optical_depth = 0.75f;
    scene.materials.push_back(smoke);
    scene.emitters = {{.name = "glow",
                       .material = static_cast<std::uint32_t>(scene.materials.size() - 1),
                       .start_radius_m = 0.5f,
                       .end_radius_m = 0.5f},
                      {.name = "fountain",
                       .material = static_cast<std::uint32_t>(scene.materials.size() - 1),
                       .count = 12,
                       .lifetime_s = 2.5f,
                       .spread_m = 0.1f,
                       .velocity_m_s = {0.5f, 6, -0.25f},
                       .velocity_spread_m_s = 0.3f,
                       .acceleration_m_s2 = {0, -9.81f, 0},
                       .start_radius_m = 0.05f,
                       .end_radius_m = 0.4f}};
    scene.nodes.resize(4);
    scene.nodes[0].name = "root";
    scene.nodes[0].emitter = 1;
    scene.nodes[0].children = {1, 2};
    scene.nodes[0].local.translation_m = {1, 2, 3};
    scene.nodes[1] = {
        .name = "mirrored", .parent = 0, .children = {}, .local = {}, .model = 0, .camera = 0, .light = 0};
    scene.nodes[1].local.scale = {-1, 2, 1};
    scene.nodes[1].local.rotation = glm::normalize(glm::quat{0.5f, 0.1f, 0.7f, -0.2f});
    scene.nodes[2] = {
        .name = "lamp", .parent = 0, .children = {}, .local = {}, .model = k_none, .camera = 1, .light = 1};
    scene.nodes[3] = {.name = "prototype", .parent = k_none, .children = {}, .local = {}, .model = 0};
    scene.roots = {0};
    set_bounds(scene);
    return scene;
}

Scene moving_scene() {
    Scene scene;
    scene.name = "moving";
    scene.materials.resize(1);
    scene.meshes = {skinned_mesh(), triangle(2.0f), triangle(1.0f)};
    scene.models = {{.name = "sail", .parts = {{0, 0}}, .morph_weights = {0.25f, 0.0f}},
                    {.name = "leaf", .parts = {{1, 0}}},
                    {.name = "far leaf", .parts = {{2, 0}}}};
    scene.nodes.resize(5);
    scene.nodes[0].name = "sail";
    scene.nodes[0].model = 0;
    scene.nodes[0].skeleton = 0;
    scene.nodes[0].morph_weights = {0.5f, 0.5f};
    scene.nodes[1].name = "mast";
    scene.nodes[1].children = {2};
    scene.nodes[2].name = "top";
    scene.nodes[2].parent = 1;
    scene.nodes[2].local.translation_m = {0, 1, 0};
    scene.nodes[3].name = "leaf";
    scene.nodes[3].model = 1;
    scene.nodes[3].coarser = {4};
    scene.nodes[3].screen_coverage = {0.5f, 0.125f};
    scene.nodes[4].name = "far leaf";
    scene.nodes[4].model = 2;
    glm::mat4 lowered{1.0f};
    lowered[3] = {0, -1, 0, 1};
    scene.skeletons = {{.name = "rig", .joints = {1, 2}, .joint_from_mesh = {glm::mat4{1.0f}, lowered}}};
    std::vector<Channel> channels = all_channels();
    channels.push_back({.node = 0,
                        .path = AnimatedPath::weights,
                        .interpolation = Interpolation::linear,
                        .width = 2,
                        .times_s = {0.0f, 1.0f},
                        .values = {0, 1, 1, 0}});
    scene.clips = {{.name = "sway", .duration_s = 2.0f, .channels = channels}};
    scene.roots = {0, 1, 3};
    set_bounds(scene);
    return scene;
}

}  // namespace rambla::assets::test
