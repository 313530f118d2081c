#pragma once

#include <glm/glm.hpp>

struct GLFWwindow;
struct ImDrawData;

namespace rambla::game {

/// Dear ImGui in one window, on the main thread: fed by GLFW, drawn elsewhere.
class Interface {
public:
    explicit Interface(GLFWwindow* window);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// @param size_px  of the window
    void begin_frame(glm::uvec2 size_px);
    /// What was built since begin_frame(); valid until the next begin_frame().
    [[nodiscard]] const ImDrawData& end_frame();
    /// Whether the pointer belongs to a panel of the interface.
    [[nodiscard]] bool wants_pointer() const;
    /// Whether keys are being typed into a field of the interface.
    [[nodiscard]] bool wants_keys() const;
};

}  // namespace rambla::game
