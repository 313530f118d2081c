// Methods that smooth the edges of the finished picture: where, how well, and where not.
#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <cmath>
#include <string>
#include <vector>

#include "render/post/hud.h"
#include "render/support.h"

namespace {

using namespace rambla;
using render::AntiAliasing;
using render::AntiAliasingParameters;
using render::AntiAliasingQuality;
using render::SobelOf;
using tests::matte;
using tests::Picture;
using tests::Stage;

constexpr std::array k_ways{
    AntiAliasingParameters{.method = AntiAliasing::sobel},
    AntiAliasingParameters{.method = AntiAliasing::sobel, .sobel_of = SobelOf::depth},
    AntiAliasingParameters{.method = AntiAliasing::edges},
    AntiAliasingParameters{.method = AntiAliasing::fxaa, .quality = AntiAliasingQuality::low},
    AntiAliasingParameters{.method = AntiAliasing::fxaa, .quality = AntiAliasingQuality::medium},
    AntiAliasingParameters{.method = AntiAliasing::fxaa, .quality = AntiAliasingQuality::high},
    AntiAliasingParameters{.method = AntiAliasing::morphological, .quality = AntiAliasingQuality::low},
    AntiAliasingParameters{.method = AntiAliasing::morphological, .quality = AntiAliasingQuality::medium},
    AntiAliasingParameters{.method = AntiAliasing::morphological, .quality = AntiAliasingQuality::high},
};

std::string name_of(const AntiAliasingParameters& way) {
    std::string name{render::k_anti_aliasing_methods[static_cast<std::size_t>(way.method)]};
    name += ' ';
    name += way.method == AntiAliasing::sobel
                ? render::k_sobel_of[static_cast<std::size_t>(way.sobel_of)]
                : render::k_anti_aliasing_qualities[static_cast<std::size_t>(way.quality)];
    return name;
}

Picture drawn(Stage& stage, const AntiAliasingParameters& way) {
    stage.settings.anti_aliasing = way;
    return stage.draw();
}

Picture drawn_plain(Stage& stage) {
    return drawn(stage, {.method = AntiAliasing::none});
}

/// A white card below an edge through the picture's middle that rises by `slope`, before a black sky.
struct Staircase {
    explicit Staircase(float slope) : slope_{slope} {
        assets::Material m = matte();
        m.unlit = true;
        stage.place(stage.square(), stage.material(m),
                    glm::rotate(glm::mat4{1.0f}, std::atan(slope), {0, 0, 1}) *
                        glm::translate(glm::mat4{1.0f}, {0, -20, 0}) *
                        glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
        stage.frame.environment.sky_zenith_radiance = stage.frame.environment.sky_horizon_radiance =
            glm::vec3{0.0f};
        stage.look_flat({0, 0, 5}, {0, 0, 0}, 2.0f);
    }

    /// Share of a pixel that the card covers, from 64² points.
    [[nodiscard]] double coverage(std::uint32_t x, std::uint32_t y) const {
        constexpr int k_points = 64;
        int covered = 0;
        for (int i = 0; i < k_points * k_points; ++i) {
            const double right = x + (i % k_points + 0.5) / k_points - 64.0;
            const double up = 64.0 - (y + (i / k_points + 0.5) / k_points);
            covered += up < slope_ * right ? 1 : 0;
        }
        return covered / static_cast<double>(k_points * k_points);
    }
    [[nodiscard]] double distance_px(std::uint32_t x, std::uint32_t y) const {
        const double right = x + 0.5 - 64.0, up = 63.5 - y;
        return std::fabs(up - slope_ * right) / std::hypot(1.0, slope_);
    }

    Stage stage;

private:
    double slope_;
};

/// Root of the mean squared difference from what the card covers, of the pixels that its edge is near.
double staircase_error(const Staircase& stairs, const Picture& picture) {
    const double white = picture.display(64, 127).x;
    double sum = 0.0;
    int count = 0;
    for (std::uint32_t y = 16; y < 112; ++y) {
        for (std::uint32_t x = 16; x < 112; ++x) {
            if (stairs.distance_px(x, y) > 1.5) continue;
            const double error = picture.display(x, y).x / white - stairs.coverage(x, y);
            sum += error * error;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

TEST(AntiAliasing, ComesCloserToWhatAnEdgeCoversAndLeavesFlatAreas) {
    // Errors that may remain, of those of the stairs. What is blurred without regard to the edge's direction
    // gains a quarter to two fifths. On the diagonal, stairs have no steps longer than a pixel, from which a
    // direction could be told: a fifth is gained, whatever the method.
    const auto allowed = [](const AntiAliasingParameters& way, float slope) {
        if (slope == 1.0f) return 0.85;
        switch (way.method) {
            case AntiAliasing::sobel:
            case AntiAliasing::edges:
                return 0.75;
            case AntiAliasing::fxaa:
                return 0.55;
            default:
                return 0.5;
        }
    };
    for (const float slope : {1.0f / 16, 1.0f / 8, 1.0f / 3, 0.7f, 1.0f}) {
        Staircase stairs{slope};
        const Picture plain = drawn_plain(stairs.stage);
        const double before = staircase_error(stairs, plain);
        EXPECT_FALSE(plain.has_pass("edge tiles"));
        for (const AntiAliasingParameters& way : k_ways) {
            // So that no flat area is only what the picture before has left there.
            stairs.stage.settings.debug.view = render::DebugView::depth;
            static_cast<void>(stairs.stage.redraw());
            stairs.stage.settings.debug.view = render::DebugView::off;
            const Picture smooth = drawn(stairs.stage, way);
            EXPECT_TRUE(smooth.has_pass("edge tiles"));
            EXPECT_TRUE(smooth.has_pass(
                render::k_anti_aliasing_methods[static_cast<std::size_t>(way.method)].data()));
            const double after = staircase_error(stairs, smooth);
            EXPECT_LT(after, allowed(way, slope) * before) << name_of(way) << ", slope " << slope;
            const std::string name = name_of(way);
            for (std::uint32_t y = 0; y < 128; ++y) {
                for (std::uint32_t x = 0; x < 128; ++x) {
                    if (stairs.distance_px(x, y) < 2.0) continue;
                    ASSERT_EQ(smooth.display(x, y), plain.display(x, y)) << name << ' ' << x << ' ' << y;
                }
            }
        }
    }
}

/// A wall with a checker texture, four pixels a field, that fills the picture.
void place_checkers(Stage& stage) {
    assets::Material m = matte();
    m.base_colour_texture = stage.texture(
        2, 2,
        {glm::u8vec4{255}, glm::u8vec4{60, 60, 60, 255}, glm::u8vec4{60, 60, 60, 255}, glm::u8vec4{255}},
        assets::ColourSpace::srgb);
    m.base_colour_texture.scale = glm::vec2{16.0f};
    stage.place(stage.square(), stage.material(m), glm::scale(glm::mat4{1.0f}, glm::vec3{2.0f}));
    stage.frame.environment = tests::only_sun({0, 0, 1});
    stage.look_flat({0, 0, 5}, {0, 0, 0}, 2.0f);
}

TEST(AntiAliasing, OfDepthAndNormalsLeavesTexturesAlone) {
    Stage stage;
    place_checkers(stage);
    const Picture plain = drawn_plain(stage);
    ASSERT_GT(std::abs(plain.display(2, 2).x - plain.display(6, 2).x), 50) << "the checkers are seen";
    EXPECT_EQ(drawn(stage, {.method = AntiAliasing::edges}).bytes, plain.bytes);
    EXPECT_EQ(drawn(stage, {.method = AntiAliasing::sobel, .sobel_of = SobelOf::depth}).bytes, plain.bytes);
    EXPECT_NE(drawn(stage, {.method = AntiAliasing::sobel}).bytes, plain.bytes) << "colour knows no surfaces";
    EXPECT_NE(drawn(stage, {.method = AntiAliasing::fxaa}).bytes, plain.bytes);
}

TEST(AntiAliasing, OfEdgesFindsFoldsByNormalsWhereThereAreAny) {
    for (const auto path : {render::LightingPath::tiled, render::LightingPath::forward}) {
        for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
            // Two walls that meet at 100 degrees, so far away that depth hardly bends from pixel to pixel.
            Stage stage;
            const std::uint32_t square = stage.square();
            for (const float side : {-1.0f, 1.0f}) {
                assets::Material m = matte(glm::vec3{side > 0.0f ? 1.0f : 0.2f});
                m.unlit = true;
                stage.place(square, stage.material(m),
                            glm::rotate(glm::mat4{1.0f}, 0.7f * side, {0, 1, 0}) *
                                glm::translate(glm::mat4{1.0f}, {side, 0, 0}));
            }
            stage.look({0, 0, 5}, {0, 0, 0}, 0.2f);
            stage.settings.lighting.path = path;
            stage.settings.gbuffer.layout = layout;
            const Picture plain = drawn_plain(stage);
            const Picture smooth = drawn(stage, {.method = AntiAliasing::edges});
            const bool has_normals = path != render::LightingPath::forward;
            EXPECT_EQ(smooth.bytes != plain.bytes, has_normals);
            EXPECT_EQ(smooth.display(64, 64) != plain.display(64, 64), has_normals) << "at the fold";
            EXPECT_EQ(smooth.display(60, 64), plain.display(60, 64)) << "beside it";
        }
    }
}

/// Things that have edges of all kinds: silhouettes, folds, textures, glass, and what the picture's border
/// cuts.
struct Jumble {
    explicit Jumble(glm::uvec2 size_px) {
        stage.frame.view.size_px = size_px;
        assets::Material checkers = matte();
        checkers.base_colour_texture = stage.texture(
            2, 2,
            {glm::u8vec4{255}, glm::u8vec4{200, 40, 20, 255}, glm::u8vec4{20, 60, 90, 255}, glm::u8vec4{255}},
            assets::ColourSpace::srgb);
        checkers.base_colour_texture.scale = glm::vec2{9.0f};
        assets::Material glass = matte({0.2f, 0.3f, 0.3f});
        glass.alpha_mode = assets::AlphaMode::blend;
        glass.base_colour.w = 0.4f;
        const std::uint32_t square = stage.square();
        const std::uint32_t floor = stage.material(checkers);
        stage.place(square, floor,
                    glm::rotate(glm::mat4{1.0f}, -1.5707963f, {1, 0, 0}) *
                        glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
        const std::uint32_t red = stage.material(matte({0.9f, 0.2f, 0.1f}));
        for (int i = 0; i < 12; ++i) {
            const auto t = static_cast<float>(i);
            stage.place(square, red,
                        glm::translate(glm::mat4{1.0f}, {0.4f * t - 2.4f, 0.5f + 0.1f * t, -0.3f * t}) *
                            glm::rotate(glm::mat4{1.0f}, t, {0.3f, 0.5f, 1.0f}) *
                            glm::scale(glm::mat4{1.0f}, glm::vec3{0.5f}));
        }
        stage.place(square, stage.material(glass), glm::translate(glm::mat4{1.0f}, {0.7f, 1, 1}));
        stage.frame.environment = assets::noon();
        stage.look({1, 2, 5}, {0, 1, 0});
    }
    Stage stage;
};

TEST(AntiAliasing, OnTilesIsTheSameAsEverywhere) {
    for (const glm::uvec2 size : {glm::uvec2{160, 120}, {1, 1}, {17, 33}, {65, 64}, {3, 50}}) {
        Jumble jumble{size};
        const Picture plain = drawn_plain(jumble.stage);
        for (AntiAliasingParameters way : k_ways) {
            const Picture tiles = drawn(jumble.stage, way);
            way.everywhere = true;
            const Picture everywhere = drawn(jumble.stage, way);
            ASSERT_EQ(everywhere.has_pass("edge tiles"), way.method == AntiAliasing::morphological);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < tiles.bytes.size(); ++i)
                wrong += tiles.bytes[i] != everywhere.bytes[i] ? 1 : 0;
            EXPECT_EQ(wrong, 0u) << name_of(way) << ' ' << size.x << 'x' << size.y;
            EXPECT_TRUE(size.x < 100 || tiles.bytes != plain.bytes) << name_of(way);
        }
    }
}

TEST(AntiAliasing, WorksOnWhatEachPathAndLayoutLeaves) {
    for (const auto path : {render::LightingPath::tiled, render::LightingPath::forward}) {
        for (const auto layout : {render::GBufferLayout::compact, render::GBufferLayout::wide}) {
            Jumble jumble{{65, 47}};
            jumble.stage.settings.lighting.path = path;
            jumble.stage.settings.gbuffer.layout = layout;
            const Picture tiles = drawn(jumble.stage, {.method = AntiAliasing::edges});
            const Picture everywhere =
                drawn(jumble.stage, {.method = AntiAliasing::edges, .everywhere = true});
            EXPECT_EQ(tiles.bytes, everywhere.bytes);
            EXPECT_NE(tiles.bytes, drawn_plain(jumble.stage).bytes);
        }
    }
}

/// Single pixels of a HUD, every other one, over the middle of the picture.
std::shared_ptr<const void> dotted_hud(glm::uvec2 size_px) {
    ImGuiContext* context = ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
    ImGui::GetIO().Fonts->Build();
    ImGui::NewFrame();
    for (int y = 40; y < 80; ++y) {
        for (int x = 40 + y % 2; x < 80; x += 2) {
            const ImVec2 corner{static_cast<float>(x), static_cast<float>(y)};
            ImGui::GetForegroundDrawList()->AddRectFilled(corner, {corner.x + 1.0f, corner.y + 1.0f},
                                                          IM_COL32(255, 0, 255, 255));
        }
    }
    ImGui::Render();
    std::shared_ptr<const void> hud = render::clone_hud(*ImGui::GetDrawData());
    ImGui::DestroyContext(context);
    return hud;
}

TEST(AntiAliasing, LeavesTheHudAlone) {
    Jumble jumble{{128, 128}};
    const std::shared_ptr<const void> hud = dotted_hud({128, 128});
    for (const AntiAliasingParameters& way : k_ways) {
        jumble.stage.frame.hud = nullptr;
        const Picture without = drawn(jumble.stage, way);
        jumble.stage.frame.hud = hud;
        const Picture with = drawn(jumble.stage, way);
        for (std::uint32_t y = 0; y < 128; ++y) {
            for (std::uint32_t x = 0; x < 128; ++x) {
                const bool dot = x >= 40 && x < 80 && y >= 40 && y < 80 && x % 2 == y % 2;
                const glm::ivec3 expected = dot ? glm::ivec3{255, 0, 255} : without.display(x, y);
                ASSERT_EQ(with.display(x, y), expected) << name_of(way) << ' ' << x << ' ' << y;
            }
        }
    }
}

}  // namespace
