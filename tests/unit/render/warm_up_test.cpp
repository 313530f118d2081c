#include "render/warm_up.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>

#include "render/passes/light_hull.h"
#include "render/renderer.h"
#include "support/quick_process.h"

namespace rambla::render {
namespace {

/// A scene with every kind of material and topology.
assets::Scene all_kinds() {
    assets::Scene scene;
    scene.images.push_back(
        {.name = "grey", .width = 1, .height = 1, .texels = std::vector(4, std::byte{128})});
    scene.textures.emplace_back().image = 0;
    for (const assets::Topology topology :
         {assets::Topology::triangles, assets::Topology::lines, assets::Topology::points}) {
        assets::Mesh& mesh = scene.meshes.emplace_back();
        mesh.topology = topology;
        mesh.positions = {{-1.0f, -1.0f, 0.0f}, {1.0f, -1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
        mesh.indices = topology == assets::Topology::lines ? std::vector<std::uint32_t>{0, 1}
                                                           : std::vector<std::uint32_t>{0, 1, 2};
        for (const glm::vec3& position : mesh.positions)
            mesh.bounds.expand(position);
    }
    // Three ways to deform: by joints, by morph targets, by both.
    scene.skeletons.emplace_back();
    for (const unsigned ways : {1u, 2u, 3u}) {
        assets::Mesh mesh = scene.meshes[0];
        if ((ways & 1u) != 0) {
            mesh.joints.assign(3, {0, 3, 0, 0});
            mesh.weights.assign(3, {0.5f, 0.5f, 0, 0});
        }
        if ((ways & 2u) != 0) mesh.morphs.resize(1);
        scene.meshes.push_back(std::move(mesh));
    }
    assets::Model& model = scene.models.emplace_back();
    const auto add = [&](const assets::Material& material, std::uint32_t mesh) {
        model.parts.push_back({.mesh = mesh, .material = static_cast<std::uint32_t>(scene.materials.size())});
        scene.materials.push_back(material);
    };
    for (const auto mode : {assets::AlphaMode::opaque, assets::AlphaMode::mask, assets::AlphaMode::blend}) {
        for (const bool unlit : {false, true}) {
            for (const std::uint32_t texture : {assets::k_none, 0u}) {
                assets::Material material;
                material.alpha_mode = mode;
                material.unlit = unlit;
                material.normal_texture.texture = texture;
                add(material, 0);
            }
        }
    }
    for (const auto mode : {assets::AlphaMode::opaque, assets::AlphaMode::mask, assets::AlphaMode::blend}) {
        assets::Material material;
        material.alpha_mode = mode;
        material.specular_texture.texture = 0;
        add(material, 0);
    }
    for (const auto mode : {assets::AlphaMode::opaque, assets::AlphaMode::mask, assets::AlphaMode::blend}) {
        assets::Material material;
        material.alpha_mode = mode;
        material.height_texture.texture = 0;
        material.height_depth = 0.01f;
        add(material, 0);
    }
    for (const auto mode : {assets::AlphaMode::opaque, assets::AlphaMode::mask, assets::AlphaMode::blend}) {
        assets::Material material;
        material.alpha_mode = mode;
        material.metalness = 0.0f;
        material.light_map_texture.texture = 0;
        add(material, 0);
    }
    add({}, 1);
    add({}, 2);
    model.parts.push_back({.mesh = 0, .material = assets::k_none});
    for (const std::uint32_t mesh : {3u, 4u, 5u})
        model.parts.push_back({.mesh = mesh, .material = 0});
    return scene;
}

TEST(WarmUp, DrawsEveryMaterialOnceForEachWayToDeform) {
    const assets::Scene scene = all_kinds();
    for (const FrameInput& input : warm_up_frames(scene, {})) {
        EXPECT_EQ(input.frame.opaque.size() + input.frame.blended.size(), scene.materials.size() + 1 + 3);
        EXPECT_EQ(input.frame.blended.size(), 7u);
        EXPECT_EQ(input.frame.casters.size(), input.frame.opaque.size());
    }
}

TEST(WarmUp, DrawsWhatFadesAndHazeToo) {
    assets::Scene scene = all_kinds();
    const std::size_t blended = warm_up_frames(scene, {}).front().frame.blended.size();
    // Of the materials, 0 is opaque, 4 masked and 8 transparent, which is blended anyway. 0 deforms in four
    // ways.
    const std::vector<std::uint32_t> fading{0, 4, 8, assets::k_none};
    const systems::Frame frame = warm_up_frames(scene, {}, fading).front().frame;
    EXPECT_EQ(frame.blended.size(), blended + 4 + 1 + 1);
    for (const systems::DrawBatch& batch : frame.blended) {
        const systems::Instance& instance = frame.instances[batch.first_instance];
        const bool faded = instance.material >> systems::k_instance_fade_shift != 0;
        EXPECT_EQ(systems::unpack_pipeline(batch.pipeline).fading, faded);
    }
    scene.emitters.emplace_back().material = 0;
    const systems::Frame hazy = warm_up_frames(scene, {}).front().frame;
    ASSERT_EQ(hazy.blended.size(), blended + 1);
    EXPECT_TRUE(systems::unpack_pipeline(hazy.blended.back().pipeline).haze);
}

TEST(WarmUp, IsForTheSettingsThatFramesWillHave) {
    const assets::Scene scene = all_kinds();
    constexpr std::size_t k_ways = k_lighting_paths.size() + 1;  // the last one: volumes that are solid
    for (std::size_t way = 0; way < k_ways; ++way) {
        const bool solid = way + 1 == k_ways;
        const std::size_t path = solid ? static_cast<std::size_t>(LightingPath::volumes) : way;
        auto texts = std::make_shared<std::atomic<int>>(0);
        RenderThreadOptions options;
        options.gl_errors_throw = true;
        options.shaders = [texts](const std::string& name) {
            ++*texts;
            return embedded_shader(name);
        };
        options.compile_for.lighting.path = static_cast<LightingPath>(path);
        options.compile_for.lighting.prepass = path % 2 == 1;
        options.compile_for.lighting.volume = solid ? LightVolume::solid : LightVolume::quad;
        options.compile_for.gbuffer.layout = GBufferLayout::wide;
        options.compile_for.brdf.model = Brdf::blinn;
        options.compile_for.detail.grade = static_cast<DetailGrade>(path % k_detail_grades.size());
        Renderer renderer{options};
        renderer.upload(scene, *tests::quick_process(scene));
        const int compiled = *texts;
        FrameInput input = warm_up_frames(scene, {}).front();
        input.settings = options.compile_for;
        const std::vector<systems::FrameLight> lamps = input.frame.lights;
        ASSERT_FALSE(lamps.empty());
        for (const bool emissive : {false, true}) {
            for (const bool lit : {false, true}) {
                input.frame.needs_emission = emissive;
                input.frame.lights = lit ? lamps : std::vector<systems::FrameLight>{};
                renderer.draw(input);
            }
        }
        EXPECT_EQ(*texts, compiled) << k_lighting_paths[path] << (solid ? ", solid" : "");
    }
}

TEST(WarmUp, LeavesNoProgramOfTemporalAntiAliasingToBeCompiledLater) {
    auto texts = std::make_shared<std::atomic<int>>(0);
    RenderThreadOptions options;
    options.gl_errors_throw = true;
    options.shaders = [texts](const std::string& path) {
        ++*texts;
        return embedded_shader(path);
    };
    options.compile_for.anti_aliasing.method = AntiAliasing::taa;
    const assets::Scene scene = all_kinds();
    Renderer renderer{options};
    renderer.upload(scene, *tests::quick_process(scene));
    const int compiled = *texts;
    FrameInput input = warm_up_frames(scene, {}).front();
    input.settings = options.compile_for;
    std::vector<FrameOutput> outputs;
    for (const bool camera : {false, true}) {
        for (const bool things : {false, true}) {
            renderer.draw(input);  // both at rest
            if (camera) input.frame.view.eye_local_m.y += 0.1f;
            for (systems::Instance& instance : input.frame.instances)
                instance.row1.w += (things ? 0.2f : 0.0f) - (camera ? 0.1f : 0.0f);
            for (systems::JointMatrix& joint : input.frame.joints)
                joint.row1.w += (things ? 0.2f : 0.0f) - (camera ? 0.1f : 0.0f);
            renderer.draw(input);
            renderer.take_finished(outputs, true);
            const std::vector<systems::PassTiming>& passes = outputs.back().feedback.passes;
            EXPECT_EQ(std::any_of(passes.begin(), passes.end(),
                                  [](const auto& pass) { return pass.name == "motion vectors"; }),
                      things);
        }
    }
    EXPECT_EQ(*texts, compiled) << "some motion compiles a program in the middle of a walk";
}

TEST(WarmUp, DrawsSolidVolumesFromOutsideAndFromInside) {
    Settings settings;
    settings.lighting.path = LightingPath::volumes;
    settings.lighting.volume = LightVolume::solid;
    const FrameInput input = warm_up_frames(all_kinds(), settings).front();
    std::array<int, 2> lights{};
    for (std::uint32_t i = 0; i < input.frame.lights.size(); ++i)
        ++lights[reaches_near_plane(input.frame.view, light_hull(input.frame.lights[i], i)) ? 1 : 0];
    EXPECT_EQ(lights, (std::array{1, 1}));
}

TEST(WarmUp, LeavesNoProgramToBeCompiledLater) {
    auto texts = std::make_shared<std::atomic<int>>(0);
    RenderThreadOptions options;
    options.gl_errors_throw = true;
    options.shaders = [texts](const std::string& path) {
        ++*texts;
        return embedded_shader(path);
    };
    const assets::Scene scene = all_kinds();
    Renderer renderer{options};
    renderer.upload(scene, *tests::quick_process(scene));
    const int compiled = *texts;
    EXPECT_GT(compiled, 0);

    FrameInput input = warm_up_frames(scene, {}).front();
    const std::vector<systems::FrameLight> lamps = input.frame.lights;
    ASSERT_FALSE(lamps.empty());
    for (const bool emissive : {false, true}) {
        for (const auto method : {ShadowMethod::off, ShadowMethod::focused}) {
            for (const auto taps : {ShadowTaps::four, ShadowTaps::sixteen}) {
                input.frame.needs_emission = emissive;
                input.settings.shadows = {.method = method, .size_texels = 256, .taps = taps};
                for (const bool lit : {false, true}) {
                    input.frame.lights = lit ? lamps : std::vector<systems::FrameLight>{};
                    renderer.draw(input);
                }
            }
        }
    }
    EXPECT_EQ(*texts, compiled) << "some choice of settings compiles a program in the middle of a walk";
    std::vector<FrameOutput> outputs;
    renderer.take_finished(outputs, true);
    EXPECT_EQ(outputs.size(), 16u) << "frames of the warm-up are nobody's";
}

}  // namespace
}  // namespace rambla::render
