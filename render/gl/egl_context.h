#pragma once

#include <memory>

namespace rambla::render::gl {

/// A GL core context without any window system (EGL_MESA_platform_surfaceless): it draws into textures only.
class EglContext {
public:
    struct Options {
        bool debug = false;
        bool any_version = false;  ///< take an older context than 4.5 where that is all there is
    };
    /// Makes the context and makes it current in this thread. @throws MissingFeature
    explicit EglContext(const Options& options);
    /// Must run in the thread that made it.
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rambla::render::gl
