#pragma once

struct GLFWwindow;

namespace rambla::game {

/// Makes the loss of a window something that a program can end by. Xlib ends the process itself, in whichever
/// thread was just talking to the server, where a window has been destroyed from outside or the server is
/// gone. From this call on the first is told by x11_window_lost(), and the second ends the process with one
/// line and k_machine_lacks. To be repeated, as GLFW replaces what is set here; does nothing where there is
/// no X11.
void watch_x11(GLFWwindow* window);

/// Whether somebody has destroyed the window.
[[nodiscard]] bool x11_window_lost();

}  // namespace rambla::game
