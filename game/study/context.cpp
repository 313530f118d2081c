#include <utility>

#include "game/study/study.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_quick_rounds = 2;
constexpr glm::uvec2 k_quick_size_px{160, 90};

}  // namespace

StudyContext::StudyContext(const StudyOptions& options, std::function<bool()> stopped)
    : options_{options}, stopped_{std::move(stopped)} {}

StudyContext::StudyContext(const StudyOptions& options, const std::atomic<bool>& stop)
    : StudyContext{options, [&stop] {
                       return stop.load();
                   }} {}

render::RenderThread& StudyContext::thread() {
    if (!thread_) {
        // Each grade is drawn once before it counts, which compiles what it needs and nothing else.
        thread_ = std::make_unique<render::RenderThread>(render::RenderThreadOptions{.window = {},
                                                                                     .shaders = {},
                                                                                     .gl_errors_throw = false,
                                                                                     .compile_ahead = false,
                                                                                     .compile_for = {}});
    }
    return *thread_;
}

std::uint32_t StudyContext::rounds(std::uint32_t full) const {
    if (options_.rounds > 0) return options_.rounds;
    return options_.quick ? k_quick_rounds : full;
}

std::vector<glm::uvec2> StudyContext::sizes(std::vector<glm::uvec2> full) const {
    if (options_.size_px != glm::uvec2{0}) return {options_.size_px};
    if (options_.quick) return {k_quick_size_px};
    return full;
}

}  // namespace rambla::game::study
