#pragma once

#include <array>
#include <string>

#include "render/gl/program.h"
#include "render/pass_context.h"
#include "render/passes/surface_detail.h"

namespace rambla::render {

/// Draws the opaque and masked queue into the G-buffer (shaders/gbuffer_layout.glsl): depth, the targets of
/// the chosen layout, and emission when the Frame says that it is needed.
class GBufferPass {
public:
    explicit GBufferPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    /// Masked materials need a discard, which costs early depth; few materials have more than a base colour,
    /// and texture filtering is what this pass costs; emission and light maps need a target; few meshes
    /// deform.
    struct Variant {
        bool masked = false;
        SurfaceDetail detail = SurfaceDetail::colour;
        bool emissive = false;
        bool skinned = false;
        bool morphed = false;
        bool specular = false;
        bool light_mapped = false;
        GBufferLayout layout = GBufferLayout::compact;
    };
    [[nodiscard]] const gl::Program& program(Variant variant);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 128 * k_surface_details> variants_{};
};

/// Value of the shaders' define GBUFFER_WIDE.
[[nodiscard]] std::string gbuffer_define(GBufferLayout layout);

/// For the set-up of a pass that asks gbuffer_read.glsl for positions and normals alone.
void read_geometry(PassBuilder& pass, const FrameResources& resources);
/// Binds the same, from UNIT_PASS on.
void bind_geometry(const PassContext& context, const FrameResources& resources);
/// For one that asks for all that lighting must know, which is everything but emission.
void read_gbuffer(PassBuilder& pass, const FrameResources& resources);
void bind_gbuffer(const PassContext& context, const FrameResources& resources);

/// Whether a material needs the SPECULAR variant of shaders/material.glsl.
[[nodiscard]] bool has_specular_textures(const assets::Material& material);

}  // namespace rambla::render
