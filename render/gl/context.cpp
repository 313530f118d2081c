#include "render/gl/context.h"

#include <epoxy/gl.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <optional>

#include "render/gl/calls.h"
#include "render/gl/egl_context.h"

namespace rambla::render::gl {

struct Context::State {
    WindowContext window;
    std::optional<EglContext> egl;
    bool errors_throw = false;
    std::mutex mutex;  ///< drivers may report from threads of their own
    std::string errors;

    ~State() {
        if (!egl && window.release) window.release();
    }
};

namespace {

// Performance hints are no errors, whatever their severity: Mesa reports every recompilation of a shader as
// one. What the compiler finds in a shader is reported once already, with file and line, as a ShaderError.
bool is_error(GLenum source, GLenum type, GLenum severity) {
    return source != GL_DEBUG_SOURCE_SHADER_COMPILER && type != GL_DEBUG_TYPE_PERFORMANCE &&
           (severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM);
}

}  // namespace

Context::Context(const WindowContext& window, bool errors_throw) : state_{std::make_unique<State>()} {
    state_->window = window;
    state_->errors_throw = errors_throw;
    if (window.make_current) {
        window.make_current();
    } else {
        state_->egl.emplace(EglContext::Options{.debug = errors_throw});
    }
    require_features(describe_device());
    count_calls();

    const auto report = [](GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                           const GLchar* message, const void* user) {
        // GL hands the pointer back as const; it is the State that was given below.
        State& state = *static_cast<State*>(const_cast<void*>(user));
        const std::string_view text{message, static_cast<std::size_t>(length)};
        if (!is_error(source, type, severity)) {
            spdlog::debug("GL: {}", text);
        } else if (!state.errors_throw) {
            spdlog::error("GL: {}", text);
        } else {
            const std::scoped_lock lock{state.mutex};
            state.errors.append(text).append("\n");
        }
    };
    glEnable(GL_DEBUG_OUTPUT);
    if (errors_throw) glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(report, state_.get());
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);

    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

Context::~Context() {
    glDebugMessageCallback(nullptr, nullptr);
}

bool Context::headless() const {
    return state_->egl.has_value();
}

void Context::swap() {
    if (state_->window.swap) state_->window.swap();
}

void Context::check_errors() {
    const std::scoped_lock lock{state_->mutex};
    if (state_->errors.empty()) return;
    std::string message = "GL reported errors:\n";
    message += state_->errors;
    state_->errors.clear();
    throw std::runtime_error(message);
}

}  // namespace rambla::render::gl
