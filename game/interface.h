#pragma once

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

    void begin_frame();
    /// What was built since begin_frame(); valid until the next begin_frame().
    [[nodiscard]] const ImDrawData& end_frame();
    /// Whether the pointer belongs to a panel of the interface.
    [[nodiscard]] bool wants_pointer() const;
    /// Whether keys are being typed into a field of the interface.
    [[nodiscard]] bool wants_keys() const;
};

}  // namespace rambla::game
