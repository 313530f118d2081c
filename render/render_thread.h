#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assets/image.h"
#include "assets/processed.h"
#include "assets/scene.h"
#include "assets/texture_levels.h"
#include "render/gl/context.h"
#include "render/graph/cost.h"
#include "render/settings.h"
#include "render/shader_source.h"
#include "render/window_context.h"
#include "systems/feedback.h"
#include "systems/frame.h"

namespace rambla::render {

struct RenderThreadOptions {
    WindowContext window;
    ShaderSource shaders;          ///< empty: the texts embedded at build
    bool gl_errors_throw = false;  ///< GL debug messages of high or medium severity become errors (tests)
    bool compile_ahead = true;  ///< draws every program once when a scene arrives, so that none hitches later
    Settings compile_for;       ///< what frames will ask for at first: decides which programs these are
};

struct FrameInput {
    systems::Frame frame;
    Settings settings;
    bool reload_shaders = false;          ///< compile again what the shader source has changed
    PassTimers timers = PassTimers::off;  ///< of its passes, on the GPU
    bool draw_graph = false;              ///< asks for FrameOutput::graph_svg
    /// Nothing is carried over from the frame before, as after a cut in a film: exposure is at once what the
    /// picture calls for. The first frame of a scene is drawn like that in any case.
    bool cut = false;
    /// For pictures that are kept: the render thread first waits for all texture levels that the frame needs
    /// and the budget allows, so that the picture depends on no disk's speed. Else no frame waits for any.
    bool complete_textures = false;
};

/// For each pixel drawn the Instance::object of the nearest opaque or masked surface; what blends does not
/// count.
struct ObjectImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint32_t> ids;  ///< row-major, top row first; assets::k_none where there is no surface
};

/// The G-buffer as lighting reads it, camera-relative world axes; of sky it says nothing.
struct SurfaceImages {
    assets::Image positions;  ///< rgba32f, m
    assets::Image normals;    ///< rgba32f, unit length
};

struct FrameOutput {
    systems::Feedback feedback;
    std::optional<assets::Image> display;  ///< rgba8, sRGB, HUD included; of the size that is shown
    /// rgba32f scene colour, exposure taken out, before bloom. This and what follows has the size that is
    /// drawn, FrameView::size_px.
    std::optional<assets::Image> linear;
    std::optional<assets::Image> glowing;  ///< the same as tone mapping finds it
    std::optional<ObjectImage> objects;
    std::optional<SurfaceImages> surfaces;  ///< only of the paths that have a G-buffer
    std::string shader_error;               ///< of a failed reload; the old programs stay in use
    std::string graph_svg;                  ///< the frame's passes as a drawing; empty unless asked for
};

/// Owns the thread that owns the GL context, and two FrameInputs, so that one is filled while the other is
/// drawn. Exceptions of the render thread surface in the next call here.
class RenderThread {
public:
    explicit RenderThread(RenderThreadOptions options);
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    /// What draws; the same for as long as this lives. Waits until there is a context, not for the shaders.
    [[nodiscard]] const DeviceInfo& device();

    /// Hands over the scene whose indices all later Frames use, and what was made of it; returns at once, and
    /// lets go of both when they are uploaded.
    /// @param source  brings the levels of textures that are not in `processed`; closed when this ends
    /// @param fading  materials of what may fade: programs for that are compiled ahead, too
    void upload(std::shared_ptr<const assets::Scene> scene,
                std::shared_ptr<const assets::ProcessedScene> processed,
                std::shared_ptr<assets::LevelSource> source = nullptr,
                std::vector<std::uint32_t> fading = {});

    /// Waits until a FrameInput is free and returns it for filling; its contents are those of two frames ago.
    [[nodiscard]] FrameInput& begin();
    /// Hands the filled FrameInput to the render thread; returns at once.
    void submit();
    /// Outputs of frames finished since the last call, oldest first; never waits.
    [[nodiscard]] std::vector<FrameOutput> collect();
    /// Waits until everything submitted is drawn.
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rambla::render
