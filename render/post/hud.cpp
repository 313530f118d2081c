#include "render/post/hud.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

static_assert(sizeof(HudDrawData::Vertex) == sizeof(ImDrawVert) &&
              offsetof(HudDrawData::Vertex, glyph_uv) == offsetof(ImDrawVert, uv) &&
              offsetof(HudDrawData::Vertex, colour) == offsetof(ImDrawVert, col));
static_assert(sizeof(ImDrawIdx) == sizeof(std::uint16_t));

constexpr GLuint k_position = 0, k_glyph_uv = 1, k_colour = 2;  // locations in hud.vert.glsl
constexpr GLint k_clip_from_px = 0;

/// The current context's font, copied when its atlas has been built anew.
std::shared_ptr<const HudFont> current_font() {
    thread_local const unsigned char* copied_from = nullptr;
    thread_local std::shared_ptr<const HudFont> font;
    unsigned char* texels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&texels, &width, &height);
    if (texels == copied_from && font) return font;
    const auto bytes =
        std::as_bytes(std::span{texels, static_cast<std::size_t>(width) * static_cast<std::size_t>(height)});
    copied_from = texels;
    font = std::make_shared<const HudFont>(
        HudFont{.size_px = {width, height}, .coverage = {bytes.begin(), bytes.end()}});
    return font;
}

void append(HudDrawData& hud, const ImDrawList& list) {
    const auto base_vertex = static_cast<std::int32_t>(hud.vertices.size());
    const auto base_index = static_cast<std::uint32_t>(hud.indices.size());
    hud.vertices.resize(hud.vertices.size() + static_cast<std::size_t>(list.VtxBuffer.Size));
    std::memcpy(static_cast<void*>(hud.vertices.data() + base_vertex), list.VtxBuffer.Data,
                static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    hud.indices.insert(hud.indices.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.ElemCount == 0 || command.UserCallback != nullptr) continue;
        const ImVec4& clip = command.ClipRect;
        hud.commands.push_back({.clip_px = {clip.x, clip.y, clip.z, clip.w},
                                .first_index = base_index + command.IdxOffset,
                                .index_count = command.ElemCount,
                                .base_vertex = base_vertex + static_cast<std::int32_t>(command.VtxOffset)});
    }
}

/// The command's clip rectangle in the framebuffer. @return  false when nothing of it is left
bool set_scissor(const HudDrawData& hud, const HudDrawData::Command& command, glm::vec2 scale,
                 glm::uvec2 size) {
    const glm::vec2 limit{size};
    const glm::vec2 low =
        glm::clamp((glm::vec2{command.clip_px} - hud.origin_px) * scale, glm::vec2{0.0f}, limit);
    const glm::vec2 high = glm::clamp(
        (glm::vec2{command.clip_px.z, command.clip_px.w} - hud.origin_px) * scale, glm::vec2{0.0f}, limit);
    if (!(low.x < high.x && low.y < high.y)) return false;
    glScissor(static_cast<GLint>(low.x), static_cast<GLint>(limit.y - high.y),
              static_cast<GLsizei>(high.x - low.x), static_cast<GLsizei>(high.y - low.y));
    return true;
}

}  // namespace

std::shared_ptr<const void> clone_hud(const ImDrawData& data) {
    if (!data.Valid || data.TotalIdxCount == 0 || data.DisplaySize.x <= 0.0f || data.DisplaySize.y <= 0.0f)
        return {};
    auto hud = std::make_shared<HudDrawData>();
    hud->origin_px = {data.DisplayPos.x, data.DisplayPos.y};
    hud->size_px = {data.DisplaySize.x, data.DisplaySize.y};
    hud->vertices.reserve(static_cast<std::size_t>(data.TotalVtxCount));
    hud->indices.reserve(static_cast<std::size_t>(data.TotalIdxCount));
    for (int i = 0; i < data.CmdListsCount; ++i)
        append(*hud, *data.CmdLists[i]);
    hud->font = current_font();
    return hud;
}

HudPass::HudPass(gl::ProgramRegistry& programs)
    : program_{programs.get({.name = "hud",
                             .vertex = "hud.vert.glsl",
                             .fragment = "hud.frag.glsl",
                             .compute = {},
                             .defines = {}})},
      vertices_{"hud"} {
    vertices_.attribute(
        {.location = k_position, .components = 2, .offset = offsetof(HudDrawData::Vertex, position_px)});
    vertices_.attribute(
        {.location = k_glyph_uv, .components = 2, .offset = offsetof(HudDrawData::Vertex, glyph_uv)});
    vertices_.attribute({.location = k_colour,
                         .components = 4,
                         .type = GL_UNSIGNED_BYTE,
                         .normalised = true,
                         .offset = offsetof(HudDrawData::Vertex, colour)});
}

void HudPass::use_font(const std::shared_ptr<const HudFont>& font) {
    if (font == font_) return;
    font_ = font;
    glyphs_ = gl::Texture{"hud glyphs", {.format = GL_R8, .size = font->size_px}};
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(glyphs_.name(), 0, 0, 0, static_cast<GLsizei>(font->size_px.x),
                        static_cast<GLsizei>(font->size_px.y), GL_RED, GL_UNSIGNED_BYTE,
                        font->coverage.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void HudPass::add(RenderGraph& graph, FrameResources& resources) {
    const auto* hud = static_cast<const HudDrawData*>(resources.frame.hud.get());
    if (hud == nullptr || hud->commands.empty() || !hud->font) return;
    use_font(hud->font);
    const gl::BufferRange vertices =
        resources.stream.upload(std::span<const HudDrawData::Vertex>{hud->vertices});
    const gl::BufferRange indices = resources.stream.upload(std::span<const std::uint16_t>{hud->indices});
    graph.add_pass(
        "hud",
        [&](PassBuilder& pass) {
            resources.backbuffer = pass.write_colour(0, resources.backbuffer, LoadOp::load);
        },
        [this, &resources, hud, vertices, indices](PassContext& context) {
            glVertexArrayVertexBuffer(vertices_.name(), 0, vertices.buffer, vertices.offset,
                                      sizeof(HudDrawData::Vertex));
            vertices_.index_buffer(indices.buffer);
            vertices_.bind();
            glBindTextureUnit(UNIT_PASS, glyphs_.name());
            glBindSampler(UNIT_PASS, resources.samplers.linear.name());
            glDisable(GL_FRAMEBUFFER_SRGB);  // colours are encoded already
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            glEnable(GL_SCISSOR_TEST);
            program_.use();
            const glm::vec2 scale{2.0f / hud->size_px.x, -2.0f / hud->size_px.y};
            const glm::vec2 offset = glm::vec2{-1.0f, 1.0f} - hud->origin_px * scale;
            glUniform4f(k_clip_from_px, scale.x, scale.y, offset.x, offset.y);
            const glm::vec2 framebuffer_scale = glm::vec2{context.size()} / hud->size_px;
            for (const HudDrawData::Command& command : hud->commands) {
                if (!set_scissor(*hud, command, framebuffer_scale, context.size())) continue;
                const auto first =
                    static_cast<std::uintptr_t>(indices.offset) + command.first_index * sizeof(std::uint16_t);
                glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.index_count),
                                         GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(first),
                                         command.base_vertex);
                ++resources.counts.draws;
                ++resources.counts.calls;
                resources.counts.triangles += command.index_count / 3;
            }
            glDisable(GL_SCISSOR_TEST);
        });
}

}  // namespace rambla::render
