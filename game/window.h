#pragma once

#include <glm/glm.hpp>
#include <string>

#include "render/window_context.h"

struct GLFWwindow;

namespace rambla::game {

/// Whether the environment names a display to open windows on.
[[nodiscard]] bool has_display();
/// @throws MachineLacks  saying what to do without a display
void require_display();

/// A window with an OpenGL 4.5 core context, made on EGL where that works. Belongs to the main thread, which
/// must outlive the renderer that draws into it.
class Window {
public:
    /// @throws MachineLacks  without a display, or without OpenGL 4.5
    Window(glm::uvec2 size_px, const std::string& title, bool resizable);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// How the render thread gets at the context; valid as long as the window.
    [[nodiscard]] render::WindowContext context() const;
    [[nodiscard]] GLFWwindow* handle() const { return window_; }

    void poll();  ///< delivers events to whoever has set callbacks
    /// By its user, by close(), or since somebody has destroyed it.
    [[nodiscard]] bool closing() const;
    void close();

    /// Zero while the window is minimised; the last one where it has been destroyed.
    [[nodiscard]] glm::uvec2 size_px() const;
    void toggle_full_screen();
    /// Hides the pointer and delivers endless motion, or gives it back.
    void capture_pointer(bool captured);

private:
    GLFWwindow* window_ = nullptr;
    mutable glm::uvec2 size_px_{0};  ///< when it was last asked for
    glm::ivec2 place_before_{0};     ///< position and size to return to from full screen
    glm::ivec2 size_before_{0};
};

}  // namespace rambla::game
