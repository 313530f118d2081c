#include "game/hud.h"

#include <imgui.h>

#include <utility>

#include "game/controls.h"

namespace rambla::game {
namespace {

constexpr ImGuiWindowFlags k_passive =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs;
constexpr float k_margin_px = 12.0f;

/// Places the next window; (0,0) is the upper left corner of the picture, (1,1) the lower right one.
void place(float x, float y) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const ImVec2 inset{k_margin_px * (1.0f - 2.0f * x), k_margin_px * (1.0f - 2.0f * y)};
    ImGui::SetNextWindowPos({size.x * x + inset.x, size.y * y + inset.y}, ImGuiCond_Always, {x, y});
    ImGui::SetNextWindowBgAlpha(0.75f);
}

void text(std::string_view value) {
    ImGui::TextUnformatted(value.data(), value.data() + value.size());
}

void draw_help(bool walking) {
    place(0.5f, 0.5f);
    ImGui::Begin("help", nullptr, k_passive);
    if (ImGui::BeginTable("keys", 2)) {
        for (const Control& control : controls()) {
            if (control.scope == (walking ? ControlScope::viewing : ControlScope::walking)) continue;
            ImGui::TableNextColumn();
            text(control.keys_text);
            ImGui::TableNextColumn();
            text(control.help);
        }
        if (!walking) {
            ImGui::TableNextColumn();
            text("left button");
            ImGui::TableNextColumn();
            text("turn around the model");
            ImGui::TableNextColumn();
            text("wheel");
            ImGui::TableNextColumn();
            text("nearer, farther");
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void draw_row(const PassRow& row) {
    ImGui::TableNextColumn();
    text(row.name);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", row.gpu_ms_median);
    ImGui::TableNextColumn();
    ImGui::Text("%.0f %%", 100.0 * row.share);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", row.cpu_ms_median);
}

void draw_timings(double picture_ms, const TimingsPanel& timings) {
    place(1.0f, 0.0f);
    ImGui::Begin("timings", nullptr, k_passive);
    const double pictures_per_second = picture_ms > 0.0 ? 1000.0 / picture_ms : 0.0;
    ImGui::Text("%.1f ms, %.0f pictures per second", picture_ms, pictures_per_second);
    ImGui::Text("%u draws, %llu triangles", timings.newest().draws,
                static_cast<unsigned long long>(timings.newest().triangles));
    if (ImGui::BeginTable("passes", 4)) {
        for (const char* const heading : {"pass", "GPU ms", "share", "CPU ms"})
            ImGui::TableSetupColumn(heading);
        ImGui::TableHeadersRow();
        for (const PassRow& row : timings.table().passes)
            draw_row(row);
        draw_row(timings.table().missing);
        draw_row(timings.table().frame);
        ImGui::EndTable();
    }
    ImGui::End();
}

void draw_line(const char* name, float y, std::string_view value) {
    if (value.empty()) return;
    place(0.5f, y);
    ImGui::Begin(name, nullptr, k_passive);
    text(value);
    ImGui::End();
}

}  // namespace

void TimingsPanel::add(systems::Feedback feedback) {
    newest_ = feedback;
    if (feedback.passes.empty()) return;
    collected_.push_back(std::move(feedback));
    if (collected_.size() < k_frames_per_table && !table_.passes.empty()) return;
    table_ = make_pass_table(collected_);
    collected_.clear();
}

void draw_hud(const Hud& hud, const TimingsPanel& timings) {
    if (hud.timings) draw_timings(hud.picture_ms, timings);
    if (hud.help) draw_help(hud.walking);
    if (hud.paused) draw_line("pause", 0.1f, "Pause (P goes on)");
    draw_line("notice", 1.0f, hud.notice.empty() ? hud.caption : hud.notice);
    draw_line("shader error", 0.85f, hud.shader_error);
}

}  // namespace rambla::game
