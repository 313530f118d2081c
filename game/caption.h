#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string_view>

struct ImGuiContext;

namespace rambla::game {

/// Writes words into pictures that no window shows, with Dear ImGui's own font. Only one may live at a time,
/// and none beside an Interface.
class CaptionWriter {
public:
    CaptionWriter();
    ~CaptionWriter();
    CaptionWriter(const CaptionWriter&) = delete;
    CaptionWriter& operator=(const CaptionWriter&) = delete;

    /// Words at the lower left of a picture, in as many lines as its width calls for.
    /// @return  for Frame::hud
    [[nodiscard]] std::shared_ptr<const void> written(std::string_view words, glm::uvec2 picture_px);

private:
    ImGuiContext* context_;
};

}  // namespace rambla::game
