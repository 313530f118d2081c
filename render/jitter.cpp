#include "render/jitter.h"

#include <array>

namespace rambla::render {
namespace {

/// Halton 1960: the digits of `index` in a base, mirrored at the point.
constexpr float radical_inverse(std::uint32_t index, std::uint32_t base) {
    float inverse = 0.0f;
    float digit = 1.0f;
    for (; index > 0; index /= base) {
        digit /= static_cast<float>(base);
        inverse += digit * static_cast<float>(index % base);
    }
    return inverse;
}

using Offsets = std::array<glm::vec2, k_jitter_length>;

Offsets make_offsets() {
    Offsets offsets;
    glm::vec2 sum{0.0f};
    for (std::uint32_t i = 0; i < k_jitter_length; ++i) {
        offsets[i] = {radical_inverse(i + 1, 2), radical_inverse(i + 1, 3)};
        sum += offsets[i];
    }
    for (glm::vec2& offset : offsets)
        offset -= sum / static_cast<float>(k_jitter_length);
    return offsets;
}

}  // namespace

glm::vec2 jitter_px(std::uint32_t index) {
    static const Offsets k_offsets = make_offsets();
    return k_offsets[index % k_jitter_length];
}

systems::FrameView shifted(const systems::FrameView& view, glm::vec2 offset_px) {
    systems::FrameView moved = view;
    const glm::vec2 offset_ndc = 2.0f * offset_px / glm::vec2{view.size_px};
    // A perspective divides by −z, an orthographic view by 1.
    glm::vec4& column = moved.clip_from_view[view.orthographic ? 3 : 2];
    const glm::vec2 by = view.orthographic ? offset_ndc : -offset_ndc;
    column.x += by.x;
    column.y += by.y;
    return moved;
}

systems::FrameView widened(const systems::FrameView& view, float border_px) {
    systems::FrameView wide = view;
    const glm::vec2 size{view.size_px};
    const glm::vec2 scale = size / (size + 2.0f * border_px);
    for (int column = 0; column < 4; ++column) {
        wide.clip_from_view[column].x *= scale.x;
        wide.clip_from_view[column].y *= scale.y;
    }
    return wide;
}

}  // namespace rambla::render
