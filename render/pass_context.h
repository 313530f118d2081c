#pragma once

#include <span>

#include "render/draw.h"
#include "render/gl/buffer.h"
#include "render/gl/texture.h"
#include "render/graph/graph.h"
#include "render/passes/light_bins.h"
#include "render/scene_store.h"
#include "render/settings.h"
#include "render/temporal_history.h"
#include "systems/frame.h"

namespace rambla::render {

/// Samplers that passes share; the graph's textures have none of their own.
struct PassSamplers {
    gl::Sampler nearest;  ///< clamped
    gl::Sampler linear;   ///< clamped
    gl::Sampler
        depth_compare;  ///< linear, clamped, GL_GEQUAL: 1 where the reference is not behind (reversed Z)
};

/// Tiles of the screen by what lighting them takes (render/shaders/tiles.glsl); made by LightListsPass.
struct TileLists {
    BufferHandle
        draws{};  ///< an indirect draw per class, how tiles divide the screen, and their lights' ranges
    BufferHandle classes{};  ///< the tiles of each class
    BufferHandle entries{};  ///< rows of the Frame's lights

    [[nodiscard]] bool valid() const { return draws.valid(); }
};
/// For the set-up of a pass that draws tiles.
void read_tiles(PassBuilder& pass, const TileLists& lists);
/// Binds the lists from BINDING_PASS_STORAGE on, and the draws.
void bind_tiles(const PassContext& context, const TileLists& lists);
/// Draws a quad for each tile of a class, shared::k_tile_class_…; the vertex shader is tile.vert.glsl.
void draw_tiles(std::uint32_t tile_class);

/// Over all pixels of a picture, in the one texel of the texture's last level, or at the head of the buffer:
/// x: ln(δ + luminance), y: pixels that are no numbers; sums or means.
struct LuminanceSums {
    TextureHandle texture{};
    BufferHandle buffer{};  ///< instead of the texture
    bool means = false;
    BufferHandle histogram{};  ///< shared::k_luminance_bins counts; only where curves are estimated

    [[nodiscard]] bool valid() const { return texture.valid() || buffer.valid(); }
};

/// What one frame's passes share. Lives until the graph has run, so callbacks may capture it by reference.
/// The frame uniforms, instances, materials and lights are bound already (shared/bindings.h).
///
/// A pass is a class that makes its programs in its constructor, `explicit Pass(gl::ProgramRegistry&)`, and
/// one `void add(RenderGraph&, FrameResources&)` per frame, which reads the handles it needs from here and
/// writes back those of what it made. A handle that no pass made is invalid: test valid() before depending on
/// something optional.
struct FrameResources {
    const systems::Frame& frame;
    const systems::FrameView&
        view;  ///< as it is drawn: the Frame's, shifted by the jitter where there is any
    const Settings& settings;
    const SceneStore& scene;
    const PassSamplers& samplers;
    gl::StreamBuffer& stream;
    const DrawList& opaque;   ///< shaded: frame.opaque
    const DrawList& blended;  ///< blended: frame.blended, back to front
    DrawCounts& counts;       ///< each pass adds what it drew
    float exposure = 1.0f;    ///< pre-exposure factor, as in the frame uniforms
    bool cut = false;         ///< FrameInput::cut, or there is no frame before

    const TemporalFrame* temporal = nullptr;  ///< only with temporal anti-aliasing
    gl::BufferRange temporal_constants{};     ///< shared::TemporalConstants of it

    std::span<const BoundedLight>
        bounded_lights{};  ///< those of the Frame's lights that can touch the picture
    TileLists tiles{};     ///< only where lighting goes by tiles, and some light touches the picture

    TextureHandle depth{};        ///< GL_DEPTH_COMPONENT32F, reversed
    TextureHandle solid_depth{};  ///< the same before what fades has written its own
    TextureHandle albedo{};       ///< G-buffer: what it holds is said in gbuffer_layout.glsl
    TextureHandle normal{};       ///< G-buffer
    TextureHandle surface{};      ///< G-buffer
    TextureHandle emission{};     ///< G-buffer; only when frame.needs_emission
    TextureHandle position{};     ///< G-buffer; only in the wide layout
    TextureHandle tangent{};      ///< G-buffer; only in the wide layout
    TextureHandle motion{};   ///< GL_RG16F, pixels (motion.glsl); only where something moved, for `temporal`
    TextureHandle objects{};  ///< GL_R32UI: Instance::object + 1, 0 for none; only where asked for
    TextureHandle
        read_positions{};           ///< GL_RGBA32F: what lighting reads of the G-buffer; only where asked for
    TextureHandle read_normals{};   ///< GL_RGBA32F: the same
    TextureHandle shadow_map{};     ///< sun, depth, 1 nearest to the sun
    gl::BufferRange sun_shadow{};   ///< shared::SunShadow of shadow_map
    TextureHandle shadow_result{};  ///< sun, GL_R8: 1 lit, 0 in shadow; invalid when shadows are off
    TextureHandle scene_colour{};   ///< of scene_colour_format(): pre-exposed linear light
    LuminanceSums luminance{};      ///< of scene_colour; only where something asks for it
    BufferHandle
        adapted_exposure{};   ///< shared::AdaptedExposure, which scene_colour has not in it; as luminance
    TextureHandle display{};  ///< tone-mapped, sRGB-encoded GL_RGBA8, alpha: luma; input of anti-aliasing
    /// What is shown, of FrameView::shown_px(): anti-aliasing (or tone mapping, without it) writes it, then
    /// the HUD.
    TextureHandle backbuffer{};

    /// Of all that is drawn but the backbuffer.
    [[nodiscard]] glm::uvec2 size_px() const { return frame.view.size_px; }
};

/// OpenGL's name for how scene colour is stored.
[[nodiscard]] constexpr GLenum scene_colour_format(const ToneParameters& tone) {
    return tone.format == SceneColourFormat::r11g11b10f ? GL_R11F_G11F_B10F : GL_RGBA16F;
}

}  // namespace rambla::render
