#pragma once

#include <array>
#include <cstdint>

#include "render/gl/program.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Light of sun, sky, lamps and emission on the G-buffer's surfaces. Makes `scene_colour`, which is left
/// undefined where nothing is seen: the sky pass fills exactly those pixels. With `volumes`, local lights are
/// left to LightVolumesPass; with `forward`, all of it to ForwardPass.
class LightingPass {
public:
    explicit LightingPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    /// Numbers as in local_lights.glsl.
    enum class LocalLights : std::uint8_t { none, all, cell, tile };
    struct Variant {
        bool shadowed = false;
        bool emissive = false;
        LocalLights local_lights = LocalLights::none;
        bool tiles = false;  ///< drawn over the tiles of a class instead of the whole screen
        Brdf brdf = Brdf::ggx;
        GBufferLayout layout = GBufferLayout::compact;
    };
    [[nodiscard]] static LocalLights local_lights_of(const FrameResources& resources);
    [[nodiscard]] const gl::Program& program(Variant variant);
    void draw_by_tiles(PassContext& context, const FrameResources& resources, Variant variant);

    gl::ProgramRegistry& programs_;
    gl::VertexArray no_vertices_{"tiles"};
    std::array<const gl::Program*, 192> variants_{};
};

}  // namespace rambla::render
