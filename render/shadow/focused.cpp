#include "render/shadow/focused.h"

#include <algorithm>

#include "render/jitter.h"
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/sun_shadow.h"
#include "systems/look/cull_kernel.h"

namespace rambla::render {
namespace {

/// Last share of the shadow distance, over which shadows fade.
constexpr float k_fade_share = 0.1f;
/// Pixels show what lies up to that far beyond the picture's rim where it is shifted by a jitter; the map
/// does not follow the jitter, or resting shadows would not rest.
constexpr float k_jitter_border_px = 0.5f;
/// A caster's depth is that of its texel's centre: half a texel aside, for surfaces that nearly face the sun.
constexpr float k_towards_sun_texels = 0.5f;

shared::SunShadow constants(const shadow::SunFit& fit, const ShadowParameters& parameters) {
    const glm::mat4 map_from_clip{glm::vec4{0.5f, 0.0f, 0.0f, 0.0f}, glm::vec4{0.0f, 0.5f, 0.0f, 0.0f},
                                  glm::vec4{0.0f, 0.0f, 1.0f, 0.0f}, glm::vec4{0.5f, 0.5f, 0.0f, 1.0f}};
    const auto size = static_cast<float>(parameters.size_texels);
    const float texel_m = std::max(fit.texel_m.x, fit.texel_m.y);
    // Of the filters in shadow_lookup.glsl.
    const float reach_texels = parameters.taps == ShadowTaps::sixteen ? 2.0f : 1.0f;
    const float fade_m = k_fade_share * parameters.distance_m;
    return {.map_from_world = map_from_clip * fit.clip_from_world,
            .size_texels = {size, size, 1.0f / size, 1.0f / size},
            .bias_m = {parameters.bias_texels * reach_texels * texel_m, k_towards_sun_texels * texel_m, 0.0f,
                       0.0f},
            .fade = {parameters.distance_m - fade_m, 1.0f / fade_m, 0.0f, 0.0f}};
}

}  // namespace

FocusedShadowPass::FocusedShadowPass(gl::ProgramRegistry& programs) : programs_{programs} {
    for (const bool masked : {false, true})
        static_cast<void>(program(masked, false, false));
}

const gl::Program& FocusedShadowPass::program(bool masked, bool skinned, bool morphed) {
    const std::size_t index = (masked ? 1u : 0u) | (skinned ? 2u : 0u) | (morphed ? 4u : 0u);
    if (variants_[index] == nullptr) {
        variants_[index] = &programs_.get({.name = masked ? "shadow map, masked" : "shadow map",
                                           .vertex = "shadow_map.vert.glsl",
                                           .fragment = masked ? "shadow_mask.frag.glsl" : "",
                                           .compute = {},
                                           .defines = {{"ALPHA_MASK", masked ? "1" : "0"},
                                                       {"SKINNED", skinned ? "1" : "0"},
                                                       {"MORPHED", morphed ? "1" : "0"}}});
    }
    return *variants_[index];
}

void FocusedShadowPass::cull_casters(const systems::CasterColumns& casters, const shadow::SunFit& fit) {
    // All but the plane towards the sun: casters before it are clamped to it.
    constexpr std::size_t k_plane_depth_one = 4;
    systems::CullVolume volume = systems::frustum_volume(fit.clip_from_world);
    if (volume.plane_count == volume.planes.size()) {
        volume.planes[k_plane_depth_one] = volume.planes[--volume.plane_count];
    }
    visible_.resize(casters.size());
    systems::cull({casters.centre_x, casters.centre_y, casters.centre_z, casters.half_x, casters.half_y,
                   casters.half_z},
                  {&volume, 1}, visible_);
    rows_.clear();
    for (std::uint32_t row = 0; row < visible_.size(); ++row) {
        if (visible_[row] != 0) rows_.push_back(row);
    }
}

void FocusedShadowPass::add(RenderGraph& graph, FrameResources& resources) {
    const ShadowParameters& parameters = resources.settings.shadows;
    const assets::Environment& environment = resources.frame.environment;
    const bool sun = glm::dot(environment.sun_illuminance, glm::vec3{1.0f}) > 0.0f;
    if (parameters.method == ShadowMethod::off || !sun) return;

    const auto size = static_cast<std::uint32_t>(parameters.size_texels);
    const systems::FrameView& view = resources.frame.view;
    const bool jittered = resources.temporal != nullptr;
    const shadow::SunFit fit =
        shadow::fit_sun_map({.view = jittered ? widened(view, k_jitter_border_px) : view,
                             .direction_to_sun = environment.direction_to_sun,
                             .distance_m = parameters.distance_m,
                             .receivers = resources.frame.visible,
                             .size_texels = size},
                            resources.frame.casters);
    if (fit.empty) return;
    cull_casters(resources.frame.casters, fit);
    if (rows_.empty()) return;

    casters_.clear(DrawKind::depth_only);
    casters_.add(resources.scene, resources.frame.casters, rows_);
    casters_.upload(resources.stream);
    resources.sun_shadow = resources.stream.upload_value(constants(fit, parameters));
    const gl::BufferRange matrix = resources.stream.upload_value(fit.clip_from_world);
    graph.add_pass(
        "sun shadow map",
        [&](PassBuilder& pass) {
            const TextureHandle map = pass.create_texture(
                "sun shadow map", {.format = GL_DEPTH_COMPONENT32F, .size = glm::uvec2{size}});
            resources.shadow_map = pass.write_depth(map, LoadOp::clear);
        },
        [this, &resources, matrix](PassContext&) {
            matrix.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_GREATER);
            glDepthMask(GL_TRUE);
            glEnable(GL_DEPTH_CLAMP);
            resources.counts += casters_.draw(
                resources.scene, [this](systems::Pipeline pipeline, std::uint32_t) -> const gl::Program& {
                    return program(pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask),
                                   pipeline.skinned, pipeline.morphed);
                });
            glDisable(GL_DEPTH_CLAMP);
        });
}

}  // namespace rambla::render
