// Pictures that are drawn larger than they are shown, and their means.
#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "render/post/hud.h"
#include "render/support.h"

namespace {

using namespace rambla;
using render::AntiAliasing;
using tests::matte;
using tests::Picture;
using tests::Stage;

/// Half a byte of the mean, of white 0.77 encoded, where light changes 1.6 times as fast as its code, and a
/// whole one of each sample, whose dither goes either way: 1.5·1.6/255, in units of white, 0.55.
constexpr double k_bytes_of_white = 0.018;

double light_of(int byte) {
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// An unlit scene before black.
struct Unlit {
    Unlit() {
        stage.settings.tone.curve = render::ToneCurve::reinhard;
        stage.settings.tone.dither = false;
        stage.settings.anti_aliasing.method = AntiAliasing::none;
        stage.frame.environment.sky_zenith_radiance = stage.frame.environment.sky_horizon_radiance =
            stage.frame.environment.ground_radiance = glm::vec3{0.0f};
    }
    std::uint32_t white() {
        assets::Material m = matte();
        m.unlit = true;
        return stage.material(m);
    }
    /// @param samples  1 is no anti-aliasing at all
    void show(glm::uvec2 size, std::uint32_t samples) {
        stage.frame.view.size_px = size * samples;
        stage.frame.view.samples = samples;
        stage.settings.anti_aliasing.method = samples > 1 ? AntiAliasing::ssaa : AntiAliasing::none;
    }
    static double share_of_white(const Picture& picture, std::uint32_t x, std::uint32_t y);
    Stage stage;
};

/// What the tone curve makes of white, as display light.
double light_of_white() {
    Unlit unlit;
    unlit.stage.place(unlit.stage.square(), unlit.white(), glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const Picture picture = unlit.stage.draw();
    double sum = 0.0;
    for (std::uint32_t y = 0; y < picture.size.y; ++y)
        for (std::uint32_t x = 0; x < picture.size.x; ++x)
            sum += light_of(picture.display(x, y).x);
    return sum / (picture.size.x * picture.size.y);
}

double Unlit::share_of_white(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    static const double white = light_of_white();
    return light_of(picture.display(x, y).x) / white;
}

/// White below a line through the middle of the picture.
struct Edge : Unlit {
    explicit Edge(double slope_of_edge) : slope{slope_of_edge} {
        stage.place(stage.square(), white(),
                    glm::rotate(glm::mat4{1.0f}, static_cast<float>(std::atan(slope)), {0, 0, 1}) *
                        glm::translate(glm::mat4{1.0f}, {0, -20, 0}) *
                        glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    }
    Picture draw(std::uint32_t samples) {
        show({k_size, k_size}, samples);
        return stage.draw();
    }
    /// Share of a pixel below the line. y counts from above.
    [[nodiscard]] double coverage(std::uint32_t x, std::uint32_t y) const {
        constexpr int k_strips = 512;  // off by less than 1e-5: the height is linear but where it is cut
        double sum = 0.0;
        for (int i = 0; i < k_strips; ++i) {
            const double column = x + (i + 0.5) / k_strips;
            const double height = 0.5 * k_size + slope * (column - 0.5 * k_size);
            sum += std::clamp(height - (k_size - 1.0 - y), 0.0, 1.0);
        }
        return sum / k_strips;
    }
    [[nodiscard]] double largest_error(const Picture& picture) const {
        double largest = 0.0;
        for (std::uint32_t y = 0; y < k_size; ++y)
            for (std::uint32_t x = 0; x < k_size; ++x)
                largest = std::max(largest, std::fabs(share_of_white(picture, x, y) - coverage(x, y)));
        return largest;
    }
    static constexpr std::uint32_t k_size = 48;
    double slope;
};

TEST(Supersampling, ShowsAsMuchOfAnEdgesPixelAsItCoversUpToHalfARowOfSamples) {
    for (const double slope : {0.125, 0.37, -0.93}) {
        Edge edge{slope};
        EXPECT_GT(edge.largest_error(edge.draw(1)), 0.4) << "what is to be made better, slope " << slope;
        for (std::uint32_t samples = 2; samples <= 8; ++samples) {
            const Picture picture = edge.draw(samples);
            ASSERT_TRUE(picture.has_pass("supersampling"));
            // In each of N columns of samples, those below the line are its height in N steps, rounded: off
            // by 1/(2N) at most. The mean of N heights is the area but for the two columns at most where the
            // line enters and leaves the pixel: |slope|/(8·N²) each (midpoint rule at a kink).
            const double n = samples;
            const double bound = 0.5 / n + 2.0 * std::fabs(slope) / (8.0 * n * n) + k_bytes_of_white;
            EXPECT_LE(edge.largest_error(picture), bound) << samples << " samples, slope " << slope;
        }
    }
}

TEST(Supersampling, AveragesTheLightOfAPatternFinerThanPixelsNotItsCodes) {
    constexpr std::uint32_t k_size = 16;
    for (std::uint32_t samples = 2; samples <= 8; ++samples) {
        const std::uint32_t fine = k_size * samples;
        std::vector<glm::u8vec4> checks(std::size_t{fine} * fine, glm::u8vec4{0, 0, 0, 255});
        for (std::uint32_t y = 0; y < fine; ++y)
            for (std::uint32_t x = 0; x < fine; ++x)
                if ((x + y) % 2 == 0) checks[y * fine + x] = glm::u8vec4{255};
        Unlit unlit;
        const std::uint32_t material = unlit.white();
        unlit.stage.scene.materials[material].base_colour_texture =
            unlit.stage.texture(fine, fine, checks, assets::ColourSpace::srgb);
        unlit.stage.place(unlit.stage.square(), material);
        unlit.show({k_size, k_size}, samples);
        unlit.stage.look_flat({0, 0, 5}, {0, 0, 0}, 1.0f);  // a texel for each pixel that is drawn
        const Picture picture = unlit.stage.draw();
        for (std::uint32_t y = 0; y < k_size; ++y) {
            for (std::uint32_t x = 0; x < k_size; ++x) {
                const std::uint32_t all = samples * samples;
                const std::uint32_t odd = (x + y) * samples % 2;  // the first sample is black
                const double white = (all % 2 == 0 ? all / 2.0 : (all + 1.0) / 2.0 - odd) / all;
                ASSERT_NEAR(Unlit::share_of_white(picture, x, y), white, k_bytes_of_white)
                    << samples << " samples at " << x << " " << y;
            }
        }
    }
}

TEST(Supersampling, TakesOddSizesAndKeepsThem) {
    for (const glm::uvec2 size : {glm::uvec2{1, 1}, {3, 131}, {97, 2}}) {
        for (std::uint32_t samples = 2; samples <= 8; ++samples) {
            Unlit unlit;
            unlit.stage.place(unlit.stage.square(), unlit.white(),
                              glm::scale(glm::mat4{1.0f}, glm::vec3{900.0f}));
            unlit.show(size, samples);
            unlit.stage.look({0, 0, 5}, {0, 0, 0});
            const Picture picture = unlit.stage.draw();
            EXPECT_EQ(picture.size, size);
            EXPECT_EQ(picture.drawn, size * samples);
            for (std::uint32_t y = 0; y < size.y; ++y)
                for (std::uint32_t x = 0; x < size.x; ++x)
                    ASSERT_NEAR(Unlit::share_of_white(picture, x, y), 1.0, k_bytes_of_white)
                        << size.x << "x" << size.y << ", " << samples << " samples at " << x << " " << y;
        }
    }
}

TEST(Supersampling, WithOneSampleIsNoAntiAliasing) {
    Edge edge{0.37};
    const Picture plain = edge.draw(1);
    edge.stage.settings.anti_aliasing.method = AntiAliasing::ssaa;  // of which one alone fits
    const Picture picture = edge.stage.draw();
    EXPECT_FALSE(picture.has_pass("supersampling"));
    EXPECT_EQ(picture.bytes, plain.bytes);
}

TEST(Supersampling, ShowsLinesAndPointsAsThickAsWithoutIt) {
    for (const auto topology : {assets::Topology::lines, assets::Topology::points}) {
        Unlit unlit;
        assets::Mesh mesh;
        mesh.topology = topology;
        mesh.positions = {{-0.9f, 0.1f, 0}, {0.8f, 0.1f, 0}, {-0.3f, -0.7f, 0}, {-0.3f, 0.6f, 0}};
        mesh.normals.assign(4, {0, 0, 1});
        mesh.indices = {0, 1, 2, 3};
        unlit.stage.place(unlit.stage.mesh(std::move(mesh)), unlit.white());
        const auto light = [&](std::uint32_t samples) {
            unlit.show({64, 64}, samples);
            unlit.stage.look_flat({0, 0, 5}, {0, 0, 0}, 1.0f);
            const Picture picture = unlit.stage.draw();
            double sum = 0.0;
            for (std::uint32_t y = 0; y < 64; ++y)
                for (std::uint32_t x = 0; x < 64; ++x)
                    sum += Unlit::share_of_white(picture, x, y);
            return sum;
        };
        const double plain = light(1);
        ASSERT_GT(plain, 3.0);
        // Ends of lines may be a pixel shorter or longer, of 54 and 42; four points are four pixels.
        EXPECT_NEAR(light(4), plain, 0.06 * plain) << static_cast<int>(topology);
        EXPECT_EQ(light(1), plain) << "and as thin as before, afterwards";
    }
}

TEST(Supersampling, LeavesDebugViewsUnmixed) {
    Edge edge{0.37};
    edge.stage.settings.debug.view = render::DebugView::emission;
    const auto colours = [&](std::uint32_t samples) {
        const Picture picture = edge.draw(samples);
        EXPECT_EQ(picture.size, glm::uvec2{Edge::k_size});
        std::set<int> found;
        for (std::uint32_t y = 0; y < Edge::k_size; ++y)
            for (std::uint32_t x = 0; x < Edge::k_size; ++x)
                found.insert(picture.display(x, y).x);
        return found;
    };
    const std::set<int> plain = colours(1);
    EXPECT_EQ(plain.size(), 2u) << "the square and what is not there";
    EXPECT_EQ(colours(4), plain);
}

/// Opaque shapes, rims and text.
std::shared_ptr<const void> make_hud() {
    ImGuiContext* context = ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {128, 128};
    ImGui::GetIO().Fonts->Build();
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({8, 8}, {60, 30}, IM_COL32(255, 128, 0, 255));
    list.AddLine({4, 120}, {124, 40}, IM_COL32(0, 255, 60, 255), 3.0f);
    list.AddCircleFilled({96, 96}, 14.0f, IM_COL32(40, 40, 255, 255));
    list.AddText({70, 14}, IM_COL32_WHITE, "Hg 42");
    list.AddText({12, 12}, IM_COL32_BLACK, "Rambla");
    ImGui::Render();
    auto hud = render::clone_hud(*ImGui::GetDrawData());
    ImGui::DestroyContext(context);
    return hud;
}

TEST(Supersampling, AndEveryOtherAntiAliasingLeavesTheHudAsItIsToTheBit) {
    constexpr std::uint32_t k_size = 128;
    Unlit unlit;
    Stage& stage = unlit.stage;
    const std::uint32_t square = stage.square();
    const std::uint32_t white = unlit.white();
    const auto draw = [&](AntiAliasing method) {
        const std::uint32_t samples = method == AntiAliasing::ssaa ? 3 : 1;
        unlit.show({k_size, k_size}, samples);
        stage.look({0, 0, 5}, {0, 0, 0});
        stage.settings.anti_aliasing.method = method;
        return stage.draw();
    };
    // What covers the picture shows where it is drawn over black as over white.
    stage.frame.hud = make_hud();
    const Picture over_black = draw(AntiAliasing::none);
    stage.place(square, white, glm::scale(glm::mat4{1.0f}, glm::vec3{20.0f}));
    const Picture over_white = draw(AntiAliasing::none);
    std::set<std::pair<std::uint32_t, std::uint32_t>> hud;
    std::uint32_t letters = 0;
    for (std::uint32_t y = 0; y < k_size; ++y) {
        for (std::uint32_t x = 0; x < k_size; ++x) {
            if (over_black.display(x, y) != over_white.display(x, y)) continue;
            hud.emplace(x, y);
            if (over_black.display(x, y) == glm::ivec3{255}) ++letters;
        }
    }
    ASSERT_GT(hud.size(), 1500u) << "rectangle, line and circle";
    ASSERT_LT(hud.size(), std::size_t{k_size} * k_size / 2) << "and no more";
    ASSERT_GT(letters, 10u) << "the insides of letters";
    // Behind it, edges that anti-aliasing works on, and that cross the HUD.
    stage.things.clear();
    for (int i = -3; i <= 3; ++i)
        stage.place(square, white,
                    glm::translate(glm::mat4{1.0f}, {0.8f * static_cast<float>(i), 0, 0}) *
                        glm::rotate(glm::mat4{1.0f}, 0.3f, {0, 0, 1}) *
                        glm::scale(glm::mat4{1.0f}, {0.2f, 3.0f, 1.0f}));
    const Picture plain = draw(AntiAliasing::none);
    for (std::size_t i = 1; i < render::k_anti_aliasing_methods.size(); ++i) {
        const std::string_view name = render::k_anti_aliasing_methods[i];
        const Picture picture = draw(static_cast<AntiAliasing>(i));
        EXPECT_NE(picture.bytes, plain.bytes) << name << " does something";
        for (const auto& [x, y] : hud)
            ASSERT_EQ(picture.display(x, y), over_black.display(x, y)) << name << " at " << x << " " << y;
    }
}

}  // namespace
