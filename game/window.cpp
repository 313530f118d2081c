#include "game/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <spdlog/fmt/fmt.h>

#include <cstdlib>

#include "game/exit_code.h"
#include "game/x11_watch.h"

namespace rambla::game {
namespace {

bool named(const char* variable) {
    const char* const value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

MachineLacks no_window(const std::string& reason) {
    return MachineLacks{
        fmt::format("no window can be opened ({}); start Rambla in a desktop session or under xvfb-run, or "
                    "draw into files with "
                    "`rambla walk --headless` and `rambla view FILE --headless --out F.png`",
                    reason)};
}

GLFWwindow* try_create(glm::uvec2 size_px, const std::string& title, int context_api) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, context_api);
    return glfwCreateWindow(static_cast<int>(size_px.x), static_cast<int>(size_px.y), title.c_str(), nullptr,
                            nullptr);
}

}  // namespace

bool has_display() {
    return named("DISPLAY") || named("WAYLAND_DISPLAY");
}

void require_display() {
    if (!has_display()) throw no_window("neither DISPLAY nor WAYLAND_DISPLAY is set");
}

Window::Window(glm::uvec2 size_px, const std::string& title, bool resizable) {
    require_display();
    if (glfwInit() != GLFW_TRUE) throw no_window(last_glfw_error());
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, resizable ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS,
                   0);  // the renderer has targets of its own; the window only shows the last one
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_ALPHA_BITS, 0);  // what passes leave in alpha is nothing for a compositor
    window_ = try_create(size_px, title, GLFW_EGL_CONTEXT_API);
    if (window_ == nullptr) window_ = try_create(size_px, title, GLFW_NATIVE_CONTEXT_API);
    if (window_ == nullptr) {
        const std::string reason = last_glfw_error();
        glfwTerminate();
        throw MachineLacks{
            fmt::format("no OpenGL 4.5 window can be made ({}); `rambla doctor` says what this machine "
                        "offers",
                        reason)};
    }
    watch_x11(window_);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

render::WindowContext Window::context() const {
    return {.make_current =
                [window = window_] {
                    glfwMakeContextCurrent(window);
                    glfwSwapInterval(1);
                },
            .release = [] { glfwMakeContextCurrent(nullptr); },
            .swap =
                [window = window_] {
                    glfwSwapBuffers(window);
                }};
}

void Window::poll() {
    watch_x11(window_);
    glfwPollEvents();
}

bool Window::closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE || x11_window_lost();
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

glm::uvec2 Window::size_px() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    // GLFW does not ask whether the server knows: of a window that is gone, it gives whatever is in memory.
    if (!x11_window_lost()) size_px_ = glm::max(size, 0);
    return size_px_;
}

void Window::toggle_full_screen() {
    if (glfwGetWindowMonitor(window_) != nullptr) {
        glfwSetWindowMonitor(window_, nullptr, place_before_.x, place_before_.y, size_before_.x,
                             size_before_.y, 0);
        return;
    }
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) return;
    glfwGetWindowPos(window_, &place_before_.x, &place_before_.y);
    glfwGetWindowSize(window_, &size_before_.x, &size_before_.y);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::capture_pointer(bool captured) {
    const int mode = captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL;
    if (glfwGetInputMode(window_, GLFW_CURSOR) != mode) glfwSetInputMode(window_, GLFW_CURSOR, mode);
}

}  // namespace rambla::game
