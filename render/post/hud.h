#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"

struct ImDrawData;

namespace rambla::render {

/// Coverage of a font's glyphs.
struct HudFont {
    glm::uvec2 size_px{0};
    std::vector<std::byte> coverage;  ///< one byte per texel, top row first
};

/// Triangles of an interface, copied out of Dear ImGui so that another thread can draw them while the next
/// interface is being built: nothing here refers to an ImGui context.
struct HudDrawData {
    struct Vertex {
        glm::vec2 position_px;
        glm::vec2 glyph_uv;
        std::uint32_t colour;  ///< RGBA8, sRGB, red in the lowest byte
    };
    struct Command {
        glm::vec4 clip_px;  ///< left, top, right, bottom
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t base_vertex = 0;
    };
    glm::vec2 origin_px{0.0f};
    glm::vec2 size_px{0.0f};
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices;
    std::vector<Command> commands;
    std::shared_ptr<const HudFont> font;
};

/// Copies what ImGui::Render() made, for Frame::hud. Call it in the thread of ImGui's current context. The
/// interface draws with its font's texture alone (no pictures) and without callbacks.
/// @return  a HudDrawData; null when there is nothing to draw
[[nodiscard]] std::shared_ptr<const void> clone_hud(const ImDrawData& data);

/// Draws Frame::hud over the `backbuffer`; no pass without one.
class HudPass {
public:
    explicit HudPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    void use_font(const std::shared_ptr<const HudFont>& font);

    const gl::Program& program_;
    gl::VertexArray vertices_;
    gl::Texture glyphs_;
    std::shared_ptr<const HudFont> font_;  ///< whose coverage glyphs_ holds
};

}  // namespace rambla::render
