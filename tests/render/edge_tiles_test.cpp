// Which tiles are listed for anti-aliasing, against a search of every pixel on the CPU.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/buffer.h"
#include "render/gl/context.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/shader_harness.h"
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/edge_tiles.h"

namespace {

using namespace rambla::render;
using rambla::tests::Random;

constexpr int k_tile = static_cast<int>(shared::k_edge_tile_px);

/// Lumas in bytes, row by row from below.
struct Lumas {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> bytes;

    Lumas(glm::ivec2 size_px, std::uint8_t value)
        : size{size_px},
          bytes(static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y), value) {}
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(std::clamp(y, 0, size.y - 1)) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(std::clamp(x, 0, size.x - 1));
    }
    [[nodiscard]] float at(int x, int y) const { return static_cast<float>(bytes[index(x, y)]) / 255.0f; }
};

using Tiles = std::set<std::pair<int, int>>;

class EdgeTiles {
public:
    [[nodiscard]] Tiles find(const Lumas& lumas, bool morphological) {
        const gl::Program& program = programs_.get({.name = "edge tiles",
                                                    .vertex = {},
                                                    .fragment = {},
                                                    .compute = "edge_tiles.comp.glsl",
                                                    .defines = {{"FXAA", morphological ? "0" : "1"},
                                                                {"SOBEL", "0"},
                                                                {"EDGES", "0"},
                                                                {"MORPHOLOGICAL", morphological ? "1" : "0"},
                                                                {"QUALITY", "1"}}});
        return run(program, lumas);
    }

private:
    [[nodiscard]] Tiles run(const gl::Program& program, const Lumas& lumas) {
        const glm::uvec2 size{lumas.size};
        const gl::Texture display{"display", {.format = GL_RGBA8, .size = size}};
        std::vector<glm::u8vec4> texels;
        for (const std::uint8_t luma : lumas.bytes)
            texels.push_back(glm::u8vec4{0, 0, 0, luma});
        glTextureSubImage2D(display.name(), 0, 0, 0, lumas.size.x, lumas.size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                            texels.data());
        const glm::uvec2 grid = (size + shared::k_edge_tile_px - 1u) / shared::k_edge_tile_px;
        const gl::Texture edges{"edges", {.format = GL_RG32UI, .size = grid}};
        std::vector<std::uint32_t> list(4 + std::size_t{grid.x} * grid.y, 0u);
        const gl::Buffer buffer{"edge tiles", list.size() * sizeof(std::uint32_t), list.data()};
        buffer.range().bind(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE);
        const gl::Sampler nearest{"nearest", {}};
        glBindTextureUnit(UNIT_PASS, display.name());
        glBindSampler(UNIT_PASS, nearest.name());
        glBindImageTexture(0, edges.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32UI);
        program.use();
        glDispatchCompute((grid.x + EDGE_TILES_OF_GROUP - 1) / EDGE_TILES_OF_GROUP,
                          (grid.y + EDGE_TILES_OF_GROUP - 1) / EDGE_TILES_OF_GROUP, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetNamedBufferSubData(buffer.name(), 0,
                                static_cast<GLsizeiptr>(list.size() * sizeof(std::uint32_t)), list.data());
        context_.check_errors();
        Tiles tiles;
        for (std::uint32_t i = 0; i < list[0]; ++i)
            tiles.emplace(static_cast<int>(list[4 + i] & 0xffffu), static_cast<int>(list[4 + i] >> 16u));
        EXPECT_EQ(tiles.size(), list[0]) << "each tile once";
        return tiles;
    }

    gl::Context context_{{}, true};
    gl::ProgramRegistry programs_{embedded_shader};
};

/// FXAA's medium quality, by its own description.
bool has_contrast(const Lumas& lumas, int x, int y) {
    const float around[] = {lumas.at(x, y), lumas.at(x, y + 1), lumas.at(x, y - 1), lumas.at(x + 1, y),
                            lumas.at(x - 1, y)};
    const auto [least, most] = std::minmax_element(std::begin(around), std::end(around));
    return *most - *least >= std::max(0.0625f, 0.166f * *most);
}

Tiles expected_tiles(const Lumas& lumas) {
    Tiles tiles;
    for (int y = 0; y < lumas.size.y; ++y) {
        for (int x = 0; x < lumas.size.x; ++x) {
            if (has_contrast(lumas, x, y)) tiles.emplace(x / k_tile, y / k_tile);
        }
    }
    return tiles;
}

TEST(EdgeTiles, OfAFlatPictureAreNone) {
    EdgeTiles edge_tiles;
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {64, 64}, {17, 33}, {130, 5}}) {
        for (const std::uint8_t value : {0, 128, 255}) {
            EXPECT_TRUE(edge_tiles.find(Lumas{size, value}, false).empty());
            EXPECT_TRUE(edge_tiles.find(Lumas{size, value}, true).empty());
        }
    }
}

TEST(EdgeTiles, AreThoseOfThePixelsThatAMethodWouldChange) {
    EdgeTiles edge_tiles;
    Random random;
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {64, 64}, {17, 33}, {130, 5}, {3, 90}}) {
        // Few dots, of all contrasts: most tiles are flat.
        Lumas lumas{size, 100};
        for (std::size_t i = 0; i < lumas.bytes.size(); ++i)
            if (random() < 0.02f) lumas.bytes[i] = static_cast<std::uint8_t>(100.0f + 60.0f * random());
        EXPECT_EQ(edge_tiles.find(lumas, false), expected_tiles(lumas)) << size.x << 'x' << size.y;
    }
}

TEST(EdgeTiles, ReachOverTheirBordersByOnePixel) {
    EdgeTiles edge_tiles;
    for (const int x : {3, 4, 7, 8, 9}) {
        Lumas lumas{{16, 16}, 0};
        lumas.bytes[lumas.index(x, 9)] = 255;
        Tiles expected;
        for (const int dx : {-1, 0, 1})
            expected.emplace((x + dx) / k_tile, 9 / k_tile);
        EXPECT_EQ(edge_tiles.find(lumas, false), expected) << x;
        EXPECT_EQ(edge_tiles.find(lumas, true), expected) << x << ": edges lie between the same pixels";
    }
}

}  // namespace
