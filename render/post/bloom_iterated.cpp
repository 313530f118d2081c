#include "render/post/bloom_spread.h"

namespace rambla::render {

BloomLight spread_by_iteration(BloomSteps& steps, BloomLight bright, int passes) {
    static const BlurKernel kernel = thirteen_tap_kernel();
    BloomLight light = bright;
    for (int i = 0; i < passes; ++i) {
        for (const glm::vec2 axis : {glm::vec2{1.0f, 0.0f}, glm::vec2{0.0f, 1.0f}})
            light = steps.step("bloom blur", BloomProgram::thirteen_taps, bright.size, light,
                               blur_step(kernel, axis));
    }
    return light;
}

}  // namespace rambla::render
