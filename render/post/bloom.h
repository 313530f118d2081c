#pragma once

#include "render/post/bloom_spread.h"

namespace rambla::render {

/// Adds the glow of very bright places to scene colour: finds the tiles in which something is bright, draws
/// what glows in them into few texels, spreads it, and adds it to the tiles where that is seen. The GPU
/// decides how much there is to draw, so that a picture without bright places costs little more than looking
/// for them. No pass when bloom is off.
class BloomPass {
public:
    explicit BloomPass(gl::ProgramRegistry& programs) : tools_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    void find_bright(RenderGraph& graph, FrameResources& resources);
    [[nodiscard]] BloomLight draw_bright(RenderGraph& graph, FrameResources& resources);
    [[nodiscard]] BloomLight spread(RenderGraph& graph, FrameResources& resources, BloomLight bright);
    void find_visible(RenderGraph& graph, FrameResources& resources, BloomLight light);
    void add_light(RenderGraph& graph, FrameResources& resources, BloomLight light);
    void bind_tiles(const PassContext& context) const;

    BloomTools tools_;
    BloomShares kawase_;
    BloomShares dual_;
    // Of the frame that is being made.
    shared::BloomFrameConstants constants_{};
    gl::BufferRange uniforms_{};  ///< with the constants
    BufferHandle tiles_{};        ///< draws and lists, as bloom_tiles.glsl has them
};

}  // namespace rambla::render
