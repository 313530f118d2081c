#include "game/interface.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

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

void Interface::begin_frame() {
    ImGui_ImplGlfw_NewFrame();
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
