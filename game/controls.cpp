#include "game/controls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rambla::game {

const std::array<Control, k_actions>& controls() {
    constexpr ControlScope k_everywhere = ControlScope::everywhere;
    constexpr ControlScope k_walking = ControlScope::walking;
    constexpr ControlScope k_viewing = ControlScope::viewing;
    static constexpr std::array<Control, k_actions> k_controls{{
        {Action::forward,
         k_walking,
         {GLFW_KEY_W, GLFW_KEY_KP_5, GLFW_KEY_UP},
         "W, keypad 5, up",
         "walk ahead"},
        {Action::back,
         k_walking,
         {GLFW_KEY_S, GLFW_KEY_KP_2, GLFW_KEY_DOWN},
         "S, keypad 2, down",
         "walk back"},
        {Action::left, k_walking, {GLFW_KEY_A, GLFW_KEY_KP_1, 0}, "A, keypad 1", "step to the left"},
        {Action::right, k_walking, {GLFW_KEY_D, GLFW_KEY_KP_3, 0}, "D, keypad 3", "step to the right"},
        {Action::turn_left, k_walking, {GLFW_KEY_LEFT, 0, 0}, "cursor left", "turn left (so does the mouse)"},
        {Action::turn_right, k_walking, {GLFW_KEY_RIGHT, 0, 0}, "cursor right", "turn right"},
        {Action::run, k_walking, {GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, 0}, "Shift", "run"},
        {Action::jump, k_walking, {GLFW_KEY_SPACE, GLFW_KEY_J, 0}, "Space, J", "jump"},
        {Action::help, k_everywhere, {GLFW_KEY_F1, 0, 0}, "F1", "this help"},
        {Action::overlay, k_everywhere, {GLFW_KEY_F2, 0, 0}, "F2", "every switch of the renderer"},
        {Action::timings, k_everywhere, {GLFW_KEY_F3, 0, 0}, "F3", "time of each pass"},
        {Action::full_screen, k_everywhere, {GLFW_KEY_F11, 0, 0}, "F11", "full screen"},
        {Action::screenshot, k_everywhere, {GLFW_KEY_F12, 0, 0}, "F12", "picture into out/ (Shift: EXR)"},
        {Action::pause, k_everywhere, {GLFW_KEY_P, 0, 0}, "P", "pause"},
        {Action::next_clip, k_viewing, {GLFW_KEY_C, 0, 0}, "C", "next clip (Shift: the one before)"},
        {Action::slower,
         k_viewing,
         {GLFW_KEY_COMMA, GLFW_KEY_KP_SUBTRACT, 0},
         ", or keypad -",
         "play slower"},
        {Action::faster, k_viewing, {GLFW_KEY_PERIOD, GLFW_KEY_KP_ADD, 0}, ". or keypad +", "play faster"},
        {Action::quit, k_everywhere, {GLFW_KEY_ESCAPE, 0, 0}, "Esc", "quit"},
    }};
    return k_controls;
}

}  // namespace rambla::game
