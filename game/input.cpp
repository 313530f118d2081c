#include "game/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rambla::game {
namespace {

Input& input_of(GLFWwindow* window) {
    return *static_cast<Input*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Input::Input(GLFWwindow* window) : window_{window} {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        if (action == GLFW_REPEAT) return;
        input_of(w).on_key(key, action == GLFW_PRESS, (modifiers & GLFW_MOD_SHIFT) != 0);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        if (button == GLFW_MOUSE_BUTTON_LEFT) input_of(w).button_held_ = action == GLFW_PRESS;
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        Input& input = input_of(w);
        const glm::vec2 place{x, y};
        if (input.pointer_known_) input.pointer_way_ += place - input.pointer_;
        input.pointer_ = place;
        input.pointer_known_ = true;
    });
    glfwSetScrollCallback(
        window, [](GLFWwindow* w, double, double y) { input_of(w).wheel_ += static_cast<float>(y); });
}

Input::~Input() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
}

void Input::on_key(int key, bool down, bool shift) {
    for (const Control& control : controls()) {
        const auto action = static_cast<std::size_t>(control.action);
        bool any_down = false;
        for (std::size_t i = 0; i < control.keys.size(); ++i) {
            if (control.keys[i] == key) keys_down_.set(action * 3 + i, down);
            any_down = any_down || keys_down_.test(action * 3 + i);
        }
        if (any_down && !held_.test(action)) {
            pressed_.set(action);
            with_shift_.set(action, shift);
        }
        held_.set(action, any_down);
    }
}

void Input::end_frame() {
    pressed_.reset();
    pointer_way_ = glm::vec2{0.0f};
    wheel_ = 0.0f;
}

void Input::forget_pointer() {
    pointer_known_ = false;
    pointer_way_ = glm::vec2{0.0f};
}

}  // namespace rambla::game
