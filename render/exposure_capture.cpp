#include "render/exposure_capture.h"

#include <cstring>

#include "assets/assert.h"
#include "render/shaders/shared/adapted_exposure.h"

namespace rambla::render {

void ExposureCapture::add(RenderGraph& graph, BufferHandle adapted_exposure) {
    if (!adapted_exposure.valid()) {
        buffer_ = {};
        return;
    }
    if (!buffer_)
        buffer_ = gl::Buffer{"capture exposure", sizeof(shared::AdaptedExposure), nullptr, GL_MAP_READ_BIT};
    pending_ = true;
    graph.add_pass(
        "capture exposure",
        [&](PassBuilder& pass) {
            pass.read(adapted_exposure, graph::Use::transfer);
            pass.side_effect();
        },
        [this, adapted_exposure](PassContext& context) {
            glCopyNamedBufferSubData(context.buffer(adapted_exposure), buffer_.name(), 0, 0,
                                     sizeof(shared::AdaptedExposure));
        });
}

systems::ExposureFeedback ExposureCapture::take() {
    RAMBLA_ASSERT(pending_, "only what was asked for can be taken");
    pending_ = false;
    const void* const mapped =
        glMapNamedBufferRange(buffer_.name(), 0, sizeof(shared::AdaptedExposure), GL_MAP_READ_BIT);
    RAMBLA_ASSERT(mapped != nullptr, "the buffer was made for reading");
    shared::AdaptedExposure adapted;
    std::memcpy(&adapted, mapped, sizeof(adapted));
    glUnmapNamedBuffer(buffer_.name());
    return {.known = true,
            .departure_ev = adapted.ev,
            .average_luminance = static_cast<double>(adapted.seen.x),
            .bad_pixels = static_cast<std::uint32_t>(adapted.seen.y + 0.5f)};
}

}  // namespace rambla::render
