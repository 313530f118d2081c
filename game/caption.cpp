#include "game/caption.h"

#include <imgui.h>

#include "render/post/hud.h"

namespace rambla::game {

CaptionWriter::CaptionWriter() {
    IMGUI_CHECKVERSION();
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.Fonts->Build();
}

CaptionWriter::~CaptionWriter() {
    ImGui::DestroyContext(context_);
}

std::shared_ptr<const void> CaptionWriter::written(std::string_view words, glm::uvec2 picture_px) {
    constexpr float k_rim_px = 3.0f;
    const ImVec2 picture{static_cast<float>(picture_px.x), static_cast<float>(picture_px.y)};
    ImGui::GetIO().DisplaySize = picture;
    ImGui::NewFrame();
    const char* const begin = words.data();
    const char* const end = begin + words.size();
    const float wrap_px = picture.x - 2.0f * k_rim_px;
    const ImVec2 size = ImGui::CalcTextSize(begin, end, false, wrap_px);
    const ImVec2 corner{k_rim_px, picture.y - k_rim_px - size.y};
    ImDrawList* const list = ImGui::GetForegroundDrawList();
    list->AddRectFilled({0.0f, corner.y - k_rim_px}, {size.x + 2.0f * k_rim_px, picture.y},
                        IM_COL32(0, 0, 0, 190));
    list->AddText(nullptr, 0.0f, corner, IM_COL32_WHITE, begin, end, wrap_px);
    ImGui::Render();
    return render::clone_hud(*ImGui::GetDrawData());
}

}  // namespace rambla::game
