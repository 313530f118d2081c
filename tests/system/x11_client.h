#pragma once

#include <string>

namespace rambla::system_test {

/// Asks a window to close, as the cross in its title bar does (ICCCM 4.2.8.1, WM_DELETE_WINDOW).
/// @param window  number, as xdotool prints it
/// @return  whether the server could be asked
[[nodiscard]] bool ask_to_close(const std::string& display, const std::string& window);

}  // namespace rambla::system_test
