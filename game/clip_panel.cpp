#include "game/clip_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace rambla::game {
namespace {

constexpr int k_rows = 6;             // more are scrolled to
constexpr float k_fastest = 4.0f;     // as far as the keys go
constexpr float k_backwards = -1.0f;  // likewise

/// Names come from files: two may be equal, and none may mean anything to Dear ImGui.
void list_clips(ClipPlayback& clips) {
    const auto count = static_cast<int>(clips.scene().clips.size());
    const auto rows = static_cast<float>(std::clamp(count, 1, k_rows));
    if (!ImGui::BeginListBox("##clips", {-1.0f, (rows + 0.5f) * ImGui::GetTextLineHeightWithSpacing()}))
        return;
    ImGuiListClipper clipper;
    clipper.Begin(count);
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            const auto clip = static_cast<std::uint32_t>(row);
            ImGui::PushID(row);
            if (ImGui::Selectable("##clip", clip == clips.clip())) clips.choose(clip);
            ImGui::SameLine();
            ImGui::TextUnformatted(clip_label(clips.scene(), clip).c_str());
            ImGui::PopID();
        }
    }
    ImGui::EndListBox();
}

}  // namespace

void draw_clip_panel(ClipPlayback& clips) {
    if (!clips.has_clips() || !ImGui::CollapsingHeader("clips", ImGuiTreeNodeFlags_DefaultOpen)) return;
    list_clips(clips);
    auto time_s = static_cast<float>(clips.time_s());
    const auto duration_s = static_cast<float>(clips.duration_s());
    if (ImGui::SliderFloat("time (s)", &time_s, 0.0f, duration_s, "%.2f", ImGuiSliderFlags_AlwaysClamp))
        clips.seek(static_cast<double>(time_s));
    float speed = clips.speed();
    if (ImGui::SliderFloat("speed", &speed, k_backwards, k_fastest, "%.2f", ImGuiSliderFlags_AlwaysClamp))
        clips.set_speed(speed);
}

}  // namespace rambla::game
