#pragma once

#include <functional>

namespace rambla::render {

/// A GL context made elsewhere, as functions that the render thread calls. Empty functions: make an EGL
/// surfaceless one.
struct WindowContext {
    std::function<void()> make_current;
    std::function<void()> release;
    std::function<void()> swap;
};

}  // namespace rambla::render
