#include "scene_equality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mesh_equality.h"

namespace rambla::assets::test {

namespace {

void expect_equal(const Material& a, const Material& b);
void expect_equal(const Texture& a, const Texture& b);
void expect_equal(const Image& a, const Image& b);
void expect_equal(const Camera& a, const Camera& b);
void expect_equal(const Light& a, const Light& b);
void expect_equal(const Emitter& a, const Emitter& b);
void expect_equal(const Node& a, const Node& b);
void expect_equal(const Skeleton& a, const Skeleton& b);
void expect_equal(const Channel& a, const Channel& b);
void expect_equal(const Clip& a, const Clip& b);

template <class T>
void expect_all_equal(const std::vector<T>& a, const std::vector<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        expect_equal(a[i], b[i]);
}

void expect_equal(const TextureSlot& a, const TextureSlot& b) {
    EXPECT_EQ(a.texture, b.texture);
    if (a.texture == k_none) return;
    EXPECT_EQ(a.uv_set, b.uv_set);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.rotation_rad, b.rotation_rad);
}

void expect_equal(const Material& a, const Material& b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.base_colour, b.base_colour);
    EXPECT_EQ(a.metalness, b.metalness);
    EXPECT_EQ(a.roughness, b.roughness);
    EXPECT_EQ(a.normal_scale, b.normal_scale);
    EXPECT_EQ(a.occlusion_strength, b.occlusion_strength);
    EXPECT_EQ(a.emissive, b.emissive);
    EXPECT_EQ(a.ior, b.ior);
    EXPECT_EQ(a.specular, b.specular);
    EXPECT_EQ(a.specular_colour, b.specular_colour);
    EXPECT_EQ(a.transmission, b.transmission);
    EXPECT_EQ(a.height_depth, b.height_depth);
    EXPECT_EQ(a.optical_depth, b.optical_depth);
    EXPECT_EQ(a.light_map_strength, b.light_map_strength);
    EXPECT_EQ(a.alpha_mode, b.alpha_mode);
    if (a.alpha_mode == AlphaMode::mask) {
        EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
    }
    EXPECT_EQ(a.double_sided, b.double_sided);
    EXPECT_EQ(a.unlit, b.unlit);
    std::vector<TextureSlot> slots;
    for_each_texture_slot(a, [&](const TextureSlot& slot) { slots.push_back(slot); });
    std::size_t index = 0;
    for_each_texture_slot(b, [&](const TextureSlot& slot) { expect_equal(slots[index++], slot); });
}

void expect_equal(const Texture& a, const Texture& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.image, b.image);
    EXPECT_EQ(a.colour_space, b.colour_space);
    EXPECT_EQ(a.sampler, b.sampler);
}

void expect_equal(const Image& a, const Image& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.format, b.format);
    EXPECT_TRUE(a.texels == b.texels);
}

void expect_equal_influences(const Mesh& a, const Mesh& b) {
    ASSERT_EQ(a.joints.size(), b.joints.size());
    ASSERT_EQ(a.weights.size(), b.weights.size());
    // One division by a sum that floats rounded.
    constexpr float k_rounding = 1e-6f;
    for (std::size_t v = 0; v < a.weights.size(); ++v)
        for (int i = 0; i < 4; ++i) {
            ASSERT_NEAR(a.weights[v][i], b.weights[v][i], k_rounding) << v;
            if (a.weights[v][i] > 0.0f) {
                ASSERT_EQ(a.joints[v][i], b.joints[v][i]) << v;
            }
        }
}

void expect_equal(const Mesh& a, const Mesh& b) {
    SCOPED_TRACE(a.name);
    expect_equal_geometry(a, b);
    expect_equal_influences(a, b);
}

/// Meshes correspond one to one where models show them.
void expect_equal_models(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.models.size(), b.models.size());
    std::map<std::uint32_t, std::uint32_t> back_of;
    std::map<std::uint32_t, std::uint32_t> first_of;
    for (std::size_t i = 0; i < a.models.size(); ++i) {
        const Model& first = a.models[i];
        const Model& back = b.models[i];
        EXPECT_EQ(first.name, back.name);
        EXPECT_EQ(first.morph_weights, back.morph_weights);
        ASSERT_EQ(first.parts.size(), back.parts.size());
        for (std::size_t p = 0; p < first.parts.size(); ++p) {
            EXPECT_EQ(first.parts[p].material, back.parts[p].material);
            const auto [place, is_new] = back_of.try_emplace(first.parts[p].mesh, back.parts[p].mesh);
            EXPECT_EQ(place->second, back.parts[p].mesh);
            EXPECT_EQ(first_of.try_emplace(back.parts[p].mesh, first.parts[p].mesh).first->second,
                      first.parts[p].mesh);
            if (is_new) expect_equal(a.meshes[first.parts[p].mesh], b.meshes[back.parts[p].mesh]);
        }
    }
}

void expect_equal(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.near_m, b.near_m);
    if (a.kind == CameraKind::perspective) {
        EXPECT_EQ(a.vertical_fov_rad, b.vertical_fov_rad);
        return;
    }
    EXPECT_EQ(a.half_height_m, b.half_height_m);
    EXPECT_EQ(a.half_width_m, b.half_width_m);
    EXPECT_EQ(a.far_m, b.far_m);
}

void expect_equal(const Light& a, const Light& b) {
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.colour * a.intensity, b.colour * b.intensity);
    if (a.kind != LightKind::directional) {
        EXPECT_EQ(a.range_m, b.range_m);
    }
    if (a.kind != LightKind::spot) return;
    EXPECT_EQ(a.inner_cone_rad, b.inner_cone_rad);
    EXPECT_EQ(a.outer_cone_rad, b.outer_cone_rad);
}

void expect_equal(const Emitter& a, const Emitter& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.lifetime_s, b.lifetime_s);
    EXPECT_EQ(a.spread_m, b.spread_m);
    EXPECT_EQ(a.velocity_m_s, b.velocity_m_s);
    EXPECT_EQ(a.velocity_spread_m_s, b.velocity_spread_m_s);
    EXPECT_EQ(a.acceleration_m_s2, b.acceleration_m_s2);
    EXPECT_EQ(a.start_radius_m, b.start_radius_m);
    EXPECT_EQ(a.end_radius_m, b.end_radius_m);
}

void expect_equal(const Node& a, const Node& b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_EQ(a.children, b.children);
    EXPECT_EQ(a.local.translation_m, b.local.translation_m);
    EXPECT_EQ(a.local.rotation, b.local.rotation);
    EXPECT_EQ(a.local.scale, b.local.scale);
    EXPECT_EQ(a.model, b.model);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(a.light, b.light);
    EXPECT_EQ(a.emitter, b.emitter);
    EXPECT_EQ(a.skeleton, b.skeleton);
    EXPECT_EQ(a.morph_weights, b.morph_weights);
    EXPECT_EQ(a.coarser, b.coarser);
    EXPECT_EQ(a.screen_coverage, b.screen_coverage);
}

void expect_equal(const Skeleton& a, const Skeleton& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.joints, b.joints);
    EXPECT_EQ(a.joint_from_mesh, b.joint_from_mesh);
}

void expect_equal(const Channel& a, const Channel& b) {
    EXPECT_EQ(a.node, b.node);
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.interpolation, b.interpolation);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.times_s, b.times_s);
    EXPECT_EQ(a.values, b.values);
}

void expect_equal(const Clip& a, const Clip& b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.duration_s, b.duration_s);
    expect_all_equal(a.channels, b.channels);
}

}  // namespace

void expect_equal(const Scene& scene, const Scene& back) {
    EXPECT_EQ(scene.name, back.name);
    EXPECT_EQ(scene.roots, back.roots);
    EXPECT_EQ(scene.time, back.time);
    expect_all_equal(scene.images, back.images);
    expect_all_equal(scene.textures, back.textures);
    expect_all_equal(scene.materials, back.materials);
    expect_equal_models(scene, back);
    expect_all_equal(scene.cameras, back.cameras);
    expect_all_equal(scene.lights, back.lights);
    expect_all_equal(scene.emitters, back.emitters);
    expect_all_equal(scene.nodes, back.nodes);
    std::vector<Skeleton> skeletons = scene.skeletons;
    std::erase_if(skeletons, [](const Skeleton& skeleton) { return skeleton.joints.empty(); });
    expect_all_equal(skeletons, back.skeletons);
    std::vector<Clip> clips = scene.clips;
    std::erase_if(clips, [](const Clip& clip) { return clip.channels.empty(); });
    expect_all_equal(clips, back.clips);
}

}  // namespace rambla::assets::test
