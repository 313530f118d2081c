#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "assets/bounds.h"
#include "assets/environment.h"

namespace rambla::systems {

/// Everything below is relative to the camera: world axes, origin at the eye, metres. Only packing makes it
/// so; the eye's own place is in FrameView, for what needs to know where in the world a picture was taken.

/// One look at the world. Reversed Z: depth 1 at the near plane, 0 at infinity (orthographic: at the far
/// plane).
struct FrameView {
    glm::mat4 view_from_world{1.0f};  ///< rotation only
    glm::mat4 clip_from_view{1.0f};
    glm::ivec3 eye_cell{0};
    glm::vec3 eye_local_m{0.0f};
    glm::uvec2 size_px{0};      ///< of what is drawn: `samples` times that of what is shown
    std::uint32_t samples = 1;  ///< pixels drawn for one that is shown, across and down
    bool orthographic = false;

    [[nodiscard]] glm::uvec2 shown_px() const { return size_px / samples; }
};

/// How a mesh is drawn: everything that needs another GL state. Index of the key's pipeline field.
struct Pipeline {
    bool double_sided = false;
    bool mirrored = false;      ///< negative determinant: front faces wind clockwise
    std::uint8_t alpha = 0;     ///< assets::AlphaMode
    std::uint8_t topology = 0;  ///< assets::Topology
    bool unlit = false;
    bool skinned = false;  ///< vertices follow Instance::joints instead of its rows
    bool morphed = false;  ///< vertices are changed by Instance::morphs before that
    bool fading = false;   ///< opaque or masked, but blended as Instance::material says, with its own depth
    /// A ball about the instance's origin, as large as its first row is long, without a mesh.
    bool haze = false;

    bool operator==(const Pipeline&) const = default;
};

[[nodiscard]] constexpr std::uint32_t pack(Pipeline p) {
    return (p.haze ? 1024u : 0u) | (p.fading ? 512u : 0u) | (p.morphed ? 256u : 0u) |
           (p.skinned ? 128u : 0u) | (p.topology << 5u) | (p.alpha << 3u) | (p.unlit ? 4u : 0u) |
           (p.double_sided ? 2u : 0u) | (p.mirrored ? 1u : 0u);
}
[[nodiscard]] constexpr Pipeline unpack_pipeline(std::uint32_t bits) {
    return {.double_sided = (bits & 2u) != 0,
            .mirrored = (bits & 1u) != 0,
            .alpha = static_cast<std::uint8_t>((bits >> 3u) & 3u),
            .topology = static_cast<std::uint8_t>((bits >> 5u) & 3u),
            .unlit = (bits & 4u) != 0,
            .skinned = (bits & 128u) != 0,
            .morphed = (bits & 256u) != 0,
            .fading = (bits & 512u) != 0,
            .haze = (bits & 1024u) != 0};
}

/// Of Instance::material: the bits that name the material, and where those begin that say how far the
/// instance has faded, of 255.
inline constexpr std::uint32_t k_instance_material_mask = 0xffffffu;
inline constexpr std::uint32_t k_instance_fade_shift = 24;

/// Instance::material of a material (k_none: the default one) that is so far gone.
/// @param faded  0: all there, 255: nothing left
[[nodiscard]] constexpr std::uint32_t instance_material(std::uint32_t material, std::uint8_t faded) {
    return (material & k_instance_material_mask) |
           (static_cast<std::uint32_t>(faded) << k_instance_fade_shift);
}

/// One drawn thing, as it lies in the instance buffer on the GPU (render/shaders/shared/instance.h mirrors
/// it).
struct Instance {
    glm::vec4 row0{1.0f, 0.0f, 0.0f, 0.0f};  ///< rows of the affine camera-relative world_from_local
    glm::vec4 row1{0.0f, 1.0f, 0.0f, 0.0f};
    glm::vec4 row2{0.0f, 0.0f, 1.0f, 0.0f};
    std::uint32_t material = 0;  ///< see instance_material()
    std::uint32_t object = 0;    ///< entity index, for picking
    std::uint32_t joints = 0;    ///< skinned: row of Frame::joints that is joint 0
    std::uint32_t morphs = 0;    ///< morphed: first of its terms in Frame::morphs
};
static_assert(sizeof(Instance) == 64);

/// Rows of the affine camera-relative map from the space of a skinned mesh to where one joint brings it.
struct JointMatrix {
    glm::vec4 row0{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec4 row1{0.0f, 1.0f, 0.0f, 0.0f};
    glm::vec4 row2{0.0f, 0.0f, 1.0f, 0.0f};
};

/// A morph target and how much of it is added. A list of them ends with weight 0.
struct MorphTerm {
    std::uint32_t target = 0;  ///< counted over the targets of all the scene's meshes
    float weight = 0.0f;
};

/// Neighbours in a sorted queue with equal pipeline, material and mesh: one instanced draw.
struct DrawBatch {
    std::uint32_t pipeline = 0;  ///< pack(Pipeline)
    std::uint32_t material = 0;
    std::uint32_t mesh = 0;            ///< k_none: haze
    std::uint32_t first_instance = 0;  ///< into Frame::instances
    std::uint32_t instance_count = 0;
};

/// What may throw a shadow into the picture: bounds as columns (centres and half extents), and where each is
/// drawn from. Sorted by pipeline, material and mesh; a renderer culls rows per shadow map and merges
/// neighbours.
struct CasterColumns {
    std::vector<float> centre_x, centre_y, centre_z;
    std::vector<float> half_x, half_y, half_z;
    std::vector<std::uint32_t> pipeline, material, mesh, instance;

    [[nodiscard]] std::size_t size() const { return instance.size(); }
};

/// A point or spot light that reaches the picture.
struct FrameLight {
    glm::vec3 position_m{0.0f};
    float radius_m = 0.0f;      ///< its light is zero from here on (window (1 − (d/r)⁴)²)
    glm::vec3 intensity{0.0f};  ///< illuminance · m²
    float cos_outer = -2.0f;    ///< point lights: −2, so that the cone never cuts
    glm::vec3 direction{0.0f, -1.0f, 0.0f};
    float cos_inner = -1.0f;
};

/// Of Frame::texture_demand: nothing that the picture shows is textured with this image.
inline constexpr std::uint8_t k_not_demanded = 255;

/// Pixels that game asks for with this Frame. All but `display` come as they are drawn, FrameView::size_px.
struct CaptureRequest {
    bool display = false;   ///< 8-bit sRGB, what the screen shows, of FrameView::shown_px()
    bool linear = false;    ///< float, scene colour before anything that only displays want, such as bloom
    bool glowing = false;   ///< float, scene colour as tone mapping finds it
    bool objects = false;   ///< Instance::object of the nearest opaque surface
    bool surfaces = false;  ///< places and normals as lighting finds them in the G-buffer
};

/// Counts of what looking and packing did, for the stats of a run.
struct FrameCounts {
    std::uint32_t renderables = 0;
    std::uint32_t visible = 0;
    std::uint32_t casters = 0;
    std::uint32_t lights = 0;
    std::uint32_t visible_lights = 0;
    std::uint32_t broken_bounds = 0;  ///< NaN or infinite: drawn all the same
};

/// All that the renderer may know of one moment: plain data, no pointers into the world, no GL names.
struct Frame {
    std::uint64_t number = 0;
    double time_s = 0.0;
    FrameView view;
    assets::Environment environment;
    std::vector<Instance> instances;
    std::vector<JointMatrix> joints;  ///< of the skins of what is drawn, by renderables that share a skin
    std::vector<MorphTerm> morphs;
    std::vector<DrawBatch>
        opaque;  ///< alpha modes opaque and mask: by pipeline, material, mesh, front to back
    std::vector<DrawBatch> blended;  ///< back to front
    CasterColumns casters;
    std::vector<FrameLight> lights;
    /// Parallel light without shadows: the intensity is the illuminance, place, radius and cone do not count.
    std::vector<FrameLight> directional_lights;
    assets::Bounds visible;  ///< around all that `opaque` and `blended` show; empty if that is nothing
    /// For each of ProcessedScene::images the finest mip level that the picture can need, or k_not_demanded;
    /// empty: nothing is known of that, and textures stay as they are.
    std::vector<std::uint8_t> texture_demand;
    /// Some visible material emits, is light-mapped or unlit: what it sends needs the emission target.
    bool needs_emission = false;
    CaptureRequest capture;
    FrameCounts counts;
    std::shared_ptr<const void>
        hud;  ///< opaque to all but game, which fills it, and render/post/hud, which draws it
};

}  // namespace rambla::systems
