#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "assets/processed.h"
#include "assets/scene.h"
#include "assets/texture_levels.h"
#include "render/gl/context.h"
#include "render/render_thread.h"

namespace rambla::render {

/// Draws Frames with the GL context that it makes, in the thread that constructs it. Results of a frame
/// (timings, captures) come out when the GPU has finished it: nothing waits unless more than two frames are
/// in flight.
class Renderer {
public:
    /// @param on_device  is told what draws as soon as there is a context, before shaders are compiled
    /// @throws MissingFeature, gl::ShaderError
    explicit Renderer(const RenderThreadOptions& options,
                      const std::function<void(const DeviceInfo&)>& on_device = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Replaces the scene whose indices Frames use.
    /// @param processed  what was made of it
    /// @param source     of the levels of textures that are not in `processed`
    /// @param fading     materials of what may fade
    void upload(const assets::Scene& scene, const assets::ProcessedScene& processed,
                std::shared_ptr<assets::LevelSource> source = nullptr,
                std::span<const std::uint32_t> fading = {});

    /// Draws and shows one frame. @throws std::runtime_error  with GL's messages, if errors are to throw
    void draw(const FrameInput& input);

    /// Moves the outputs of finished frames behind `outputs`, oldest first. @param wait  finishes all frames
    /// first
    void take_finished(std::vector<FrameOutput>& outputs, bool wait);

    [[nodiscard]] bool frames_in_flight() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rambla::render
