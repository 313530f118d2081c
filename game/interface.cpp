#include "game/interface.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include "game/x11_watch.h"

namespace rambla::game {

Interface::Interface(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // panels open where they belong; nothing is written behind the user's back
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;  // the game decides when the pointer is captured
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    io.Fonts->Build();
}

Interface::~Interface() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Interface::begin_frame(glm::uvec2 size_px) {
    ImGui_ImplGlfw_NewFrame();
    if (x11_window_lost()) {  // what it has just asked GLFW for may be anything
        ImGui::GetIO().DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
        ImGui::GetIO().DisplayFramebufferScale = {1.0f, 1.0f};
    }
    ImGui::NewFrame();
}

const ImDrawData& Interface::end_frame() {
    ImGui::Render();
    return *ImGui::GetDrawData();
}

bool Interface::wants_pointer() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool Interface::wants_keys() const {
    return ImGui::GetIO().WantTextInput;
}

}  // namespace rambla::game
