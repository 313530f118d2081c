#pragma once

#include <bitset>
#include <glm/glm.hpp>

#include "game/controls.h"

struct GLFWwindow;

namespace rambla::game {

/// Keys and mouse of one window, as actions. A key that is pressed and released between two looks still
/// counts as pressed once. Sets the window's callbacks; whoever sets others afterwards must call these on.
class Input {
public:
    explicit Input(GLFWwindow* window);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    [[nodiscard]] bool held(Action action) const { return held_.test(static_cast<std::size_t>(action)); }
    /// Whether the action's key went down since the last end_frame().
    [[nodiscard]] bool pressed(Action action) const {
        return pressed_.test(static_cast<std::size_t>(action));
    }
    /// Whether Shift was down when the action's key went down last.
    [[nodiscard]] bool with_shift(Action action) const {
        return with_shift_.test(static_cast<std::size_t>(action));
    }
    [[nodiscard]] bool button_held() const { return button_held_; }  ///< left mouse button
    [[nodiscard]] glm::vec2 pointer_way() const {
        return pointer_way_;
    }                                                     ///< pixels since the last end_frame()
    [[nodiscard]] float wheel() const { return wheel_; }  ///< notches since the last end_frame()

    void end_frame();
    /// Forgets the motion so far: the pointer has just been captured or given back, and jumps.
    void forget_pointer();

private:
    void on_key(int key, bool down, bool shift);

    GLFWwindow* window_;
    std::bitset<k_actions> held_;
    std::bitset<k_actions> pressed_;
    std::bitset<k_actions> with_shift_;
    std::bitset<k_actions * 3> keys_down_;
    bool button_held_ = false;
    bool pointer_known_ = false;
    glm::vec2 pointer_{0.0f};
    glm::vec2 pointer_way_{0.0f};
    float wheel_ = 0.0f;
};

}  // namespace rambla::game
