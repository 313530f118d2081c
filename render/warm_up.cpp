#include "render/warm_up.h"

#include <algorithm>
#include <compare>
#include <map>
#include <set>

#include "assets/environment.h"

namespace rambla::render {

namespace {

/// Two of the tiles that lighting divides the screen into: a lamp reaches one of them. No powers of two:
/// with those, llvmpipe compiled shaders that no later frame used.
constexpr glm::uvec2 k_size_px{120, 56};
constexpr float k_near_m = 0.1f;
constexpr float k_light_distance_m = 2.0f;
constexpr float k_light_radius_m = 0.3f;

/// What picks programs and state, but for the settings.
struct Look {
    std::uint32_t material = 0;
    bool skinned = false;
    bool morphed = false;

    auto operator<=>(const Look&) const = default;
};

/// For each look in use the mesh with the fewest indices: what is drawn does not matter, only with which
/// state.
std::map<Look, std::uint32_t> smallest_meshes(const assets::Scene& scene) {
    std::map<Look, std::uint32_t> chosen;
    for (const assets::Model& model : scene.models) {
        for (const assets::ModelPart& part : model.parts) {
            if (part.mesh == assets::k_none) continue;
            const assets::Mesh& mesh = scene.meshes[part.mesh];
            const bool skinned = !mesh.weights.empty() && !scene.skeletons.empty();
            const Look look{part.material, skinned, !mesh.morphs.empty()};
            const auto [entry, is_new] = chosen.try_emplace(look, part.mesh);
            const std::size_t known = scene.meshes[entry->second].indices.size();
            if (!is_new && mesh.indices.size() < known) entry->second = part.mesh;
        }
    }
    return chosen;
}

/// Moves a mesh so that it stands before the eye, scaled to a metre.
systems::Instance instance_of(const assets::Mesh& mesh, std::uint32_t material) {
    const glm::vec3 half = mesh.bounds.empty() ? glm::vec3{1.0f} : mesh.bounds.half_extents();
    const glm::vec3 centre = mesh.bounds.empty() ? glm::vec3{0.0f} : mesh.bounds.centre();
    const float scale = 0.5f / std::max({half.x, half.y, half.z, 1e-3f});
    const glm::vec3 shift = glm::vec3{0.0f, 0.0f, -k_light_distance_m} - scale * centre;
    systems::Instance instance;
    instance.row0 = {scale, 0.0f, 0.0f, shift.x};
    instance.row1 = {0.0f, scale, 0.0f, shift.y};
    instance.row2 = {0.0f, 0.0f, scale, shift.z};
    instance.material = systems::instance_material(material, 0);
    return instance;
}

/// Joints that all bring the mesh to where its instance is.
std::uint32_t add_joints(systems::Frame& frame, const assets::Mesh& mesh, const systems::Instance& instance) {
    std::uint16_t most = 0;
    for (const glm::u16vec4& joints : mesh.joints)
        most = std::max({most, joints.x, joints.y, joints.z, joints.w});
    const auto first = static_cast<std::uint32_t>(frame.joints.size());
    frame.joints.resize(first + most + 1u, {instance.row0, instance.row1, instance.row2});
    return first;
}

void add_caster(systems::CasterColumns& casters, const systems::DrawBatch& batch) {
    casters.centre_x.push_back(0.0f);
    casters.centre_y.push_back(0.0f);
    casters.centre_z.push_back(-k_light_distance_m);
    casters.half_x.push_back(0.5f);
    casters.half_y.push_back(0.5f);
    casters.half_z.push_back(0.5f);
    casters.pipeline.push_back(batch.pipeline);
    casters.material.push_back(batch.material);
    casters.mesh.push_back(batch.mesh);
    casters.instance.push_back(batch.first_instance);
}

/// A ball of each material that emitters use.
void add_haze(systems::Frame& frame, const assets::Scene& scene) {
    std::set<std::uint32_t> materials;
    for (const assets::Emitter& emitter : scene.emitters)
        if (emitter.material != assets::k_none) materials.insert(emitter.material);
    for (const std::uint32_t material : materials) {
        const systems::Pipeline pipeline{.alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend),
                                         .haze = true};
        frame.blended.push_back({.pipeline = systems::pack(pipeline),
                                 .material = material,
                                 .mesh = assets::k_none,
                                 .first_instance = static_cast<std::uint32_t>(frame.instances.size()),
                                 .instance_count = 1});
        systems::Instance& ball = frame.instances.emplace_back();
        ball.row2.w = -k_light_distance_m;
        ball.material = systems::instance_material(material, 0);
    }
}

/// The last opaque thing once more, as what fades.
void add_fading(systems::Frame& frame) {
    systems::DrawBatch batch = frame.opaque.back();
    systems::Instance instance = frame.instances.back();
    systems::Pipeline pipeline = systems::unpack_pipeline(batch.pipeline);
    pipeline.fading = true;
    batch.pipeline = systems::pack(pipeline);
    batch.first_instance = static_cast<std::uint32_t>(frame.instances.size());
    instance.material = systems::instance_material(batch.material, 128);
    frame.instances.push_back(instance);
    frame.blended.push_back(batch);
}

systems::Frame warm_up_frame(const assets::Scene& scene, std::span<const std::uint32_t> fading) {
    systems::Frame frame;
    frame.view.size_px = k_size_px;
    frame.view.clip_from_view = glm::mat4{0.0f};
    frame.view.clip_from_view[0].x = 1.0f;  // 90° both ways, reversed infinite depth
    frame.view.clip_from_view[1].y = 1.0f;
    frame.view.clip_from_view[2].w = -1.0f;
    frame.view.clip_from_view[3].z = k_near_m;
    frame.environment = assets::noon();
    frame.lights.push_back({.position_m = {-0.4f, 0.0f, -k_light_distance_m}, .radius_m = k_light_radius_m});
    frame.visible = {glm::vec3{-0.5f, -0.5f, -0.5f - k_light_distance_m},
                     glm::vec3{0.5f, 0.5f, 0.5f - k_light_distance_m}};
    frame.morphs.push_back({});
    for (const auto& [look, mesh] : smallest_meshes(scene)) {
        const std::uint32_t index = look.material;
        const assets::Material material =
            index < scene.materials.size() ? scene.materials[index] : assets::Material{};
        const systems::Pipeline pipeline{.double_sided = true,
                                         .alpha = static_cast<std::uint8_t>(assets::drawn_as(material)),
                                         .topology = static_cast<std::uint8_t>(scene.meshes[mesh].topology),
                                         .unlit = material.unlit,
                                         .skinned = look.skinned,
                                         .morphed = look.morphed};
        const systems::DrawBatch batch{.pipeline = systems::pack(pipeline),
                                       .material = index,
                                       .mesh = mesh,
                                       .first_instance = static_cast<std::uint32_t>(frame.instances.size()),
                                       .instance_count = 1};
        systems::Instance instance = instance_of(scene.meshes[mesh], index);
        if (look.skinned) instance.joints = add_joints(frame, scene.meshes[mesh], instance);
        frame.instances.push_back(instance);
        if (assets::drawn_as(material) == assets::AlphaMode::blend) {
            frame.blended.push_back(batch);
        } else {
            frame.opaque.push_back(batch);
            add_caster(frame.casters, batch);
            if (std::find(fading.begin(), fading.end(), index) != fading.end()) add_fading(frame);
        }
    }
    add_haze(frame, scene);
    return frame;
}

/// Less than a cut, and more than rest.
constexpr float k_step_m = 0.01f;

/// Temporal anti-aliasing has programs for pictures in which the camera moves, things do, or both. Without a
/// past it counts as moved, and so does every thing that stays before an eye that moves.
void add_moving_frames(std::vector<FrameInput>& inputs) {
    inputs.push_back(inputs.back());
    inputs.back().frame.view.eye_local_m.x += k_step_m;
    inputs.push_back(inputs.back());
    for (systems::Instance& instance : inputs.back().frame.instances)
        instance.row0.w += k_step_m;
    for (systems::JointMatrix& joint : inputs.back().frame.joints)
        joint.row0.w += k_step_m;
}

}  // namespace

std::vector<FrameInput> warm_up_frames(const assets::Scene& scene, const Settings& settings,
                                       std::span<const std::uint32_t> fading) {
    std::vector<FrameInput> inputs;
    systems::Frame frame = warm_up_frame(scene, fading);
    if (settings.anti_aliasing.method == AntiAliasing::ssaa) frame.view.samples = 2;
    const LightingParameters& lighting = settings.lighting;
    // Solids are drawn in another state where the eye is inside.
    if (lighting.path == LightingPath::volumes && lighting.volume == LightVolume::solid)
        frame.lights.push_back({.radius_m = k_light_radius_m});
    for (const bool emissive : {false, true}) {
        constexpr std::size_t k_ways = 4;  // with and without a shadow, with and without lamps
        for (std::size_t i = 0; i < k_ways; ++i) {
            FrameInput input;
            input.frame = frame;
            input.frame.needs_emission = emissive;
            if (i >= 2) input.frame.lights.clear();
            input.settings = settings;
            input.settings.shadows.method = i % 3 == 0 ? ShadowMethod::off : ShadowMethod::focused;
            input.settings.shadows.size_texels = 256;
            input.settings.shadows.taps = i == 1 ? ShadowTaps::four : ShadowTaps::sixteen;
            inputs.push_back(std::move(input));
        }
    }
    if (settings.anti_aliasing.method == AntiAliasing::taa) add_moving_frames(inputs);
    return inputs;
}

}  // namespace rambla::render
