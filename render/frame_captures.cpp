#include "render/frame_captures.h"

namespace rambla::render {
namespace {

void capture(Capture& capture, RenderGraph& graph, const char* name, TextureHandle texture, CapturedAs what,
             float scale = 1.0f) {
    if (texture.valid()) {
        capture.add(graph, name, texture, what, scale);
    } else {
        capture.release();
    }
}

}  // namespace

void FrameCaptures::add_from_scene(RenderGraph& graph, const FrameResources& resources) {
    const systems::CaptureRequest& wanted = resources.frame.capture;
    capture(linear_, graph, "capture linear", wanted.linear ? resources.scene_colour : TextureHandle{},
            CapturedAs::floats, 1.0f / resources.exposure);
    capture(objects_, graph, "capture objects", wanted.objects ? resources.objects : TextureHandle{},
            CapturedAs::objects);
    capture(positions_, graph, "capture positions", resources.read_positions, CapturedAs::floats);
    capture(normals_, graph, "capture normals", resources.read_normals, CapturedAs::floats);
}

void FrameCaptures::add_from_display(RenderGraph& graph, const FrameResources& resources) {
    const systems::CaptureRequest& wanted = resources.frame.capture;
    exposure_.add(graph, resources.adapted_exposure);
    capture(glowing_, graph, "capture glowing", wanted.glowing ? resources.scene_colour : TextureHandle{},
            CapturedAs::floats, 1.0f / resources.exposure);
    capture(display_, graph, "capture display", wanted.display ? resources.backbuffer : TextureHandle{},
            CapturedAs::bytes);
}

void FrameCaptures::take(FrameOutput& output) {
    if (display_.pending()) output.display = display_.take();
    if (exposure_.pending()) output.feedback.exposure = exposure_.take();
    if (linear_.pending()) output.linear = linear_.take();
    if (glowing_.pending()) output.glowing = glowing_.take();
    if (objects_.pending()) output.objects = objects_.take_objects();
    if (positions_.pending())
        output.surfaces = SurfaceImages{.positions = positions_.take(), .normals = normals_.take()};
}

}  // namespace rambla::render
