#include "game/x11_watch.h"

#include <X11/Xlib.h>
#include <X11/Xproto.h>
#include <dlfcn.h>
#include <spdlog/spdlog.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "game/exit_code.h"

namespace rambla::game {
namespace {

std::atomic<XID> watched{0};
std::atomic<bool> lost{false};

int on_error(Display* display, XErrorEvent* error) {
    const bool no_such_window = error->error_code == BadWindow || error->error_code == BadDrawable;
    if (no_such_window && error->resourceid == watched) {
        lost = true;
        return 0;
    }
    static std::atomic<unsigned char> told{Success};  // a request of every frame must not fill the log
    if (told.exchange(error->error_code) == error->error_code) return 0;
    std::array<char, 128> text{};
    XGetErrorText(display, error->error_code, text.data(), static_cast<int>(text.size()));
    spdlog::warn("the X server refuses request {}: {}", error->request_code, text.data());
    return 0;
}

/// Must not return, and other threads may be in the middle of anything: nothing is torn down.
int on_connection_lost(Display* display) {
    std::fprintf(stderr, "error: the X server '%s' is gone, and the window with it\n",
                 DisplayString(display));
    std::fflush(nullptr);
    std::_Exit(k_machine_lacks);
}

/// By name, since GLFW exists without X11 as well.
XID x11_window(GLFWwindow* window) {
    using GetX11Window = XID (*)(GLFWwindow*);
    static const auto get = reinterpret_cast<GetX11Window>(dlsym(RTLD_DEFAULT, "glfwGetX11Window"));
    return get == nullptr ? 0 : get(window);
}

}  // namespace

void watch_x11(GLFWwindow* window) {
    const XID id = x11_window(window);
    if (id == 0) return;
    if (watched.exchange(id) != id) lost = false;
    XSetErrorHandler(on_error);
    XSetIOErrorHandler(on_connection_lost);
}

bool x11_window_lost() {
    return lost;
}

}  // namespace rambla::game
