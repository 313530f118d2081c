#pragma once

#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Smooths jagged edges of `display` into the `backbuffer`, by the methods that need no more than a finished
/// picture and what it shows: sobel, edges, fxaa and morphological. No pass with any other.
///
/// Most pixels have no edge and stay as they are: they are copied. A compute pass, `edge tiles`, lists the
/// tiles of the screen in which the method would change a pixel, and one indirect draw runs it there.
class EdgeSmoothingPass {
public:
    explicit EdgeSmoothingPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    /// What picks programs.
    struct Choice {
        AntiAliasing method = AntiAliasing::none;
        AntiAliasingQuality quality = AntiAliasingQuality::medium;
        SobelOf sobel_of = SobelOf::colour;
        bool everywhere = false;
        bool has_normals = false;
        GBufferLayout layout = GBufferLayout::compact;

        bool operator==(const Choice&) const = default;
    };
    /// What the list of tiles is kept in.
    struct Tiles {
        BufferHandle list{};
        TextureHandle edges{};  ///< of morphological alone: where pixels differ from their neighbours
    };

    void choose(const Choice& choice);
    void add_tiles(RenderGraph& graph, const FrameResources& resources);
    void add_smoothing(RenderGraph& graph, FrameResources& resources);

    gl::ProgramRegistry& programs_;
    Choice choice_;
    Tiles tiles_;                              ///< of the frame that is being added
    const gl::Program* find_tiles_ = nullptr;  ///< null: not called for
    const gl::Program* smooth_ = nullptr;
};

}  // namespace rambla::render
