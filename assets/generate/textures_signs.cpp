#include <array>
#include <string_view>

#include "assets/generate/canvas.h"
#include "assets/generate/noise.h"
#include "assets/generate/textures.h"

namespace rambla::assets::generate {

namespace {

/// Capital letters, five columns by seven rows, a row per byte from the top, leftmost column in bit 4.
struct Glyph {
    char letter;
    std::array<std::uint8_t, 7> rows;
};
constexpr std::array<Glyph, 20> k_glyphs{{
    {'A', {0x0e, 0x11, 0x11, 0x1f, 0x11, 0x11, 0x11}}, {'B', {0x1e, 0x11, 0x11, 0x1e, 0x11, 0x11, 0x1e}},
    {'C', {0x0e, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0e}}, {'D', {0x1e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1e}},
    {'E', {0x1f, 0x10, 0x10, 0x1e, 0x10, 0x10, 0x1f}}, {'F', {0x1f, 0x10, 0x10, 0x1e, 0x10, 0x10, 0x10}},
    {'G', {0x0e, 0x11, 0x10, 0x17, 0x11, 0x11, 0x0e}}, {'I', {0x0e, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0e}},
    {'L', {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1f}}, {'M', {0x11, 0x1b, 0x15, 0x15, 0x11, 0x11, 0x11}},
    {'N', {0x11, 0x19, 0x15, 0x13, 0x11, 0x11, 0x11}}, {'O', {0x0e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e}},
    {'P', {0x1e, 0x11, 0x11, 0x1e, 0x10, 0x10, 0x10}}, {'Q', {0x0e, 0x11, 0x11, 0x11, 0x15, 0x12, 0x0d}},
    {'R', {0x1e, 0x11, 0x11, 0x1e, 0x14, 0x12, 0x11}}, {'S', {0x0f, 0x10, 0x10, 0x0e, 0x01, 0x01, 0x1e}},
    {'T', {0x1f, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}}, {'U', {0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e}},
    {'V', {0x11, 0x11, 0x11, 0x11, 0x11, 0x0a, 0x04}}, {' ', {0, 0, 0, 0, 0, 0, 0}},
}};

bool ink(char letter, int column, int row) {
    if (column < 0 || column > 4 || row < 0 || row > 6) return false;
    for (const Glyph& glyph : k_glyphs)
        if (glyph.letter == letter)
            return ((glyph.rows[static_cast<std::size_t>(row)] >> (4 - column)) & 1) != 0;
    return false;
}

struct Sign {
    std::string_view words;
    glm::vec3 board;
    glm::vec3 letters;
};
constexpr std::array<Sign, k_sign_cells> k_signs{{
    {"FORN DE PA", {0.36f, 0.20f, 0.13f}, {0.93f, 0.84f, 0.62f}},
    {"FARMACIA", {0.88f, 0.90f, 0.86f}, {0.10f, 0.45f, 0.25f}},
    {"BAR DEL SOL", {0.55f, 0.13f, 0.11f}, {0.95f, 0.91f, 0.80f}},
    {"LLIBRES", {0.13f, 0.20f, 0.30f}, {0.90f, 0.85f, 0.70f}},
    {"FLORS", {0.20f, 0.33f, 0.22f}, {0.95f, 0.90f, 0.82f}},
    {"CAFE", {0.16f, 0.14f, 0.13f}, {0.88f, 0.72f, 0.42f}},
    {"QUEVIURES", {0.84f, 0.74f, 0.50f}, {0.38f, 0.14f, 0.10f}},
    {"SABATES", {0.26f, 0.30f, 0.34f}, {0.92f, 0.92f, 0.90f}},
}};

}  // namespace

PaintedSet paint_signs(std::uint32_t seed) {
    // One board of 3.2 × 0.4 m per row of the picture.
    constexpr float k_aspect = 8.0f;
    Canvas canvas{512, 512};
    canvas.paint([&](glm::vec2 uv) {
        const auto cell = static_cast<std::uint32_t>(uv.y * static_cast<float>(k_sign_cells));
        const Sign& sign = k_signs[cell];
        const float y = glm::fract(uv.y * static_cast<float>(k_sign_cells));
        // Letters six columns apart, eleven rows to the board, so a column is as wide as a row is high.
        const float columns = 11.0f * k_aspect;
        const float width = 6.0f * static_cast<float>(sign.words.size()) - 1.0f;
        const float scale = width > columns - 8.0f ? width / (columns - 8.0f) : 1.0f;
        const float column = (uv.x * columns - 0.5f * columns) * scale + 0.5f * width;
        const float row = (y * 11.0f - 5.5f) + 3.5f;
        const auto letter = static_cast<int>(column) / 6;
        const bool within = column >= 0.0f && row >= 0.0f && letter < static_cast<int>(sign.words.size());
        const bool painted = within && ink(sign.words[static_cast<std::size_t>(letter)],
                                           static_cast<int>(column) % 6, static_cast<int>(row));
        const float border = std::min(std::min(uv.x, 1.0f - uv.x) * k_aspect, std::min(y, 1.0f - y));
        const bool line = border > 0.06f && border < 0.09f;
        const float wear = 0.92f + 0.16f * (fractal_noise(uv, {24, 24}, 4, seed) - 0.5f);
        return Texel{{(painted || line ? sign.letters : sign.board) * wear, 1.0f}, 0.0f, 0.5f};
    });
    return {"signs", canvas.colour_image("signs"), {}, {}, {}};
}

}  // namespace rambla::assets::generate
