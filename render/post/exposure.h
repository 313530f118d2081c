#pragma once

#include <array>
#include <optional>

#include "render/gl/buffer.h"
#include "render/gl/program.h"
#include "render/pass_context.h"

namespace rambla::render {

/// Turns the picture's luminances into `adapted_exposure`, which tone mapping reads in the same frame:
/// nothing is read back. Automatic exposure follows them in time, by Frame::time_s; the first picture of a
/// scene, after a cut, and after a while without it is at once as bright as it calls for. No pass and no
/// memory unless there are `luminance` sums.
class ExposurePass {
public:
    explicit ExposurePass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    struct Variant {
        bool sums_in_buffer = false;
        bool estimate = false;
        bool adapt = false;
    };
    [[nodiscard]] const gl::Program& program(const Variant& variant);
    [[nodiscard]] gl::BufferRange upload_step(FrameResources& resources, glm::uvec2 size_px);

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, 8> variants_{};
    gl::Buffer state_;                   ///< shared::AdaptedExposure
    std::optional<double> last_time_s_;  ///< of the frame that state_ belongs to
};

}  // namespace rambla::render
