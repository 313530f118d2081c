// The morphological method against one written from its description, which walks from pixel to pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/shader_harness.h"
#include "render/support.h"

namespace {

using namespace rambla;
using tests::add;
using tests::Inputs;
using tests::Picture;
using tests::Random;
using tests::ShaderHarness;
using tests::Stage;

/// Shares of the pixel above a line that belongs to what is below, and the other way round.
struct Areas {
    double above = 0.0;
    double below = 0.0;
};

/// By adding up the silhouette's height.
Areas integrated(int behind, int ahead, double height_behind, double height_ahead) {
    constexpr int k_steps = 2000;
    const double length = behind + ahead + 1;
    Areas areas;
    for (int i = 0; i < k_steps; ++i) {
        const double t = behind + (i + 0.5) / k_steps;
        const double height = 0.5 * height_behind * std::max(0.0, 1.0 - 2.0 * t / length) +
                              0.5 * height_ahead * std::max(0.0, 1.0 - 2.0 * (length - t) / length);
        (height > 0.0 ? areas.above : areas.below) += std::fabs(height) / k_steps;
    }
    return areas;
}

TEST(LineArea, IsTheIntegralOfTheSilhouette) {
    ShaderHarness gpu;
    Inputs inputs;
    for (int behind = 0; behind < 33; ++behind) {
        for (int ahead = 0; ahead < 33; ++ahead) {
            for (int heights = 0; heights < 9; ++heights)
                add(inputs, {behind, ahead, heights % 3 - 1, heights / 3 - 1});
        }
    }
    const std::vector<glm::vec4> found =
        gpu.run("line_area.glsl", "result.xy = line_areas(a.x, a.y, a.z, a.w);", inputs);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::vec4 in = inputs[4 * i];
        const Areas expected = integrated(static_cast<int>(in.x), static_cast<int>(in.y), in.z, in.w);
        // The sum's own error: where the silhouette meets the line within a step.
        ASSERT_NEAR(found[i].x, expected.above, 1e-5) << in.x << ' ' << in.y << ' ' << in.z << ' ' << in.w;
        ASSERT_NEAR(found[i].y, expected.below, 1e-5) << in.x << ' ' << in.y << ' ' << in.z << ' ' << in.w;
    }
}

TEST(LineBits, AreMirroredAtTheDiagonal) {
    ShaderHarness gpu;
    Inputs inputs;
    for (int bits = 0; bits < 65536; ++bits)
        add(inputs, {bits, 0, 0, 0});
    const std::vector<glm::vec4> found =
        gpu.run("line_bits.glsl", "result.x = float(transposed_bits(uint(a.x)));", inputs);
    for (unsigned bits = 0; bits < 65536; ++bits) {
        unsigned expected = 0;
        for (unsigned i = 0; i < 16; ++i)
            if ((bits >> i & 1u) != 0) expected |= 1u << (i % 4 * 4 + i / 4);
        ASSERT_EQ(static_cast<unsigned>(found[bits].x), expected) << bits;
    }
}

/// A picture of flat patches in three levels of grey, as the display shows it; rows from below.
class Patches {
public:
    explicit Patches(const Picture& picture) : size_{picture.size}, picture_{picture} {}

    [[nodiscard]] bool inside(int x, int y) const {
        return x >= 0 && y >= 0 && x < static_cast<int>(size_.x) && y < static_cast<int>(size_.y);
    }
    [[nodiscard]] double byte(int x, int y) const {
        const int right = std::clamp(x, 0, static_cast<int>(size_.x) - 1);
        const int up = std::clamp(y, 0, static_cast<int>(size_.y) - 1);
        return picture_
            .display(static_cast<std::uint32_t>(right), size_.y - 1 - static_cast<std::uint32_t>(up))
            .x;
    }
    [[nodiscard]] bool left(int x, int y) const { return inside(x, y) && is_edge(x, y, -1, 0); }
    [[nodiscard]] bool below(int x, int y) const { return inside(x, y) && is_edge(x, y, 0, -1); }

    /// What the method makes of a pixel.
    [[nodiscard]] double smoothed(int x, int y) const {
        const double from_below = areas(false, x, y).above, from_above = areas(false, x, y + 1).below;
        const double from_left = areas(true, y, x).above, from_right = areas(true, y, x + 1).below;
        // Of equals, whatever the sums of their areas round to.
        const bool vertical = std::max(from_below, from_above) >= std::max(from_left, from_right) - 1e-6;
        const double a = vertical ? from_below : from_left, b = vertical ? from_above : from_right;
        if (a + b == 0.0) return byte(x, y);
        const double before = vertical ? byte(x, y - 1) : byte(x - 1, y);
        const double after = vertical ? byte(x, y + 1) : byte(x + 1, y);
        return (a * std::lerp(byte(x, y), before, a) + b * std::lerp(byte(x, y), after, b)) / (a + b);
    }

private:
    [[nodiscard]] double difference(int x, int y, int dx, int dy) const {
        return std::fabs(byte(x, y) - byte(x + dx, y + dy)) / 255.0;
    }
    [[nodiscard]] bool is_edge(int x, int y, int dx, int dy) const {
        const double largest =
            std::max({difference(x, y, -1, 0), difference(x, y, 1, 0), difference(x, y, 0, -1),
                      difference(x, y, 0, 1), difference(x - 1, y, -1, 0), difference(x, y - 1, 0, -1)});
        return difference(x, y, dx, dy) >= std::max(0.05, 0.5 * largest);
    }
    [[nodiscard]] bool line(bool columns, int along, int across) const {
        return columns ? left(across, along) : below(along, across);
    }
    [[nodiscard]] bool crossed(bool columns, int along, int across) const {
        return columns ? below(across, along) : left(along, across);
    }
    [[nodiscard]] Areas areas(bool columns, int along, int across) const {
        if (!line(columns, along, across)) return {};
        const auto up = [&](int place) {
            return crossed(columns, place, across);
        };
        const auto down = [&](int place) {
            return crossed(columns, place, across - 1);
        };
        int first = along, last = along + 1;
        while (!up(first) && !down(first) && line(columns, first - 1, across))
            --first;
        while (!up(last) && !down(last) && line(columns, last, across))
            ++last;
        const auto height = [&](int end, int other) {
            if (up(end) && down(end)) return (down(other) ? 1.0 : 0.0) - (up(other) ? 1.0 : 0.0);
            return (up(end) ? 1.0 : 0.0) - (down(end) ? 1.0 : 0.0);
        };
        return integrated(along - first, last - along - 1, height(first, last), height(last, first));
    }

    glm::uvec2 size_;
    const Picture& picture_;
};

TEST(Morphological, MakesWhatItsDescriptionSays) {
    // Within what the high quality looks at on either hand.
    constexpr std::uint32_t k_width = 27, k_height = 22;
    Random random;
    for (int round = 0; round < 6; ++round) {
        Stage stage;
        stage.frame.view.size_px = {k_width, k_height};
        // Levels whose differences are far from half of each other, so that dither decides nothing.
        constexpr std::array<std::uint8_t, 3> levels{0, 70, 255};
        std::vector<glm::u8vec4> texels(k_width * k_height, glm::u8vec4{0, 0, 0, 255});
        for (int patch = 0; patch < 25; ++patch) {
            const auto in = [&](float limit) {
                return static_cast<std::uint32_t>(random() * limit);
            };
            const std::uint32_t x0 = in(k_width), y0 = in(k_height);
            const std::uint32_t x1 = std::min(k_width, x0 + 1 + in(12)),
                                y1 = std::min(k_height, y0 + 1 + in(6));
            const std::uint8_t level = levels[in(3)];
            for (std::uint32_t y = y0; y < y1; ++y) {
                for (std::uint32_t x = x0; x < x1; ++x)
                    texels[y * k_width + x] = {level, level, level, 255};
            }
        }
        assets::Material m = tests::matte();
        m.unlit = true;
        m.base_colour_texture = stage.texture(k_width, k_height, texels, assets::ColourSpace::srgb);
        stage.place(stage.square(), stage.material(m),
                    glm::scale(glm::mat4{1.0f}, {static_cast<float>(k_width) / k_height, 1.0f, 1.0f}));
        stage.look_flat({0, 0, 5}, {0, 0, 0}, 1.0f);
        stage.settings.anti_aliasing = {.method = render::AntiAliasing::none};
        const Picture plain = stage.draw();
        stage.settings.anti_aliasing = {.method = render::AntiAliasing::morphological,
                                        .quality = render::AntiAliasingQuality::high};
        const Picture smooth = stage.draw();
        const Patches patches{plain};
        int changed = 0;
        for (int y = 0; y < static_cast<int>(k_height); ++y) {
            for (int x = 0; x < static_cast<int>(k_width); ++x) {
                const double found =
                    smooth
                        .display(static_cast<std::uint32_t>(x), k_height - 1 - static_cast<std::uint32_t>(y))
                        .x;
                // Half a byte from rounding, and as much from shares in floats.
                ASSERT_NEAR(found, patches.smoothed(x, y), 1.0) << "round " << round << ": " << x << ' ' << y;
                changed += patches.smoothed(x, y) != patches.byte(x, y) ? 1 : 0;
            }
        }
        EXPECT_GT(changed, 50);
    }
}

}  // namespace
