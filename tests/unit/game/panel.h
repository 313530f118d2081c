#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

namespace rambla::game {

/// Widgets in a window of their own, and a mouse.
class Panel : public testing::Test {
protected:
    Panel(float width_px, float height_px) : width_px_{width_px}, height_px_{height_px} {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {width_px, height_px};
        io.Fonts->Build();
    }
    ~Panel() override { ImGui::DestroyContext(context_); }

    virtual void draw_widgets() = 0;

    void draw() {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({width_px_, height_px_});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
        draw_widgets();
        ImGui::End();
        ImGui::Render();
    }
    void click(float x_px, float y_px, float drag_px = 0.0f) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {x_px, y_px};
        draw();
        io.MouseDown[0] = true;
        draw();
        io.MousePos = {x_px + drag_px, y_px};
        draw();
        io.MouseDown[0] = false;
        draw();
    }
    /// Clicks, or drags to the right, further and further down until something has come true. The topmost
    /// line is the heading, which would fold the panel.
    template <class Fact>
    bool clicked_until(float x_px, float drag_px, const Fact& fact) {
        for (float y_px = 34.0f; y_px < height_px_; y_px += 4.0f) {
            click(x_px, y_px, drag_px);
            if (fact()) return true;
        }
        return false;
    }

private:
    float width_px_;
    float height_px_;
    ImGuiContext* context_ = ImGui::CreateContext();
};

}  // namespace rambla::game
