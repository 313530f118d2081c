#include "assets/generate/ground_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>

#include "assets/generate/building.h"
#include "assets/generate/city_plan.h"
#include "assets/process/srgb.h"
#include "unit/assets/generate_support.h"

namespace rambla::assets::test {
namespace {

using namespace generate;

const char* const k_small = "city:blocks=1x1,walkers=0,cars=0";

/// Generated once for all tests of a program.
const Scene& small_night() {
    static const Scene scene = generate_place(k_small, 1, k_night).scene;
    return scene;
}

/// A lit window of two panes, its wall's foot at the origin.
ShopWindow window_at(const Frame& wall) {
    return {.wall = wall,
            .opening = {{-1.2f, 0.0f}, {1.2f, 3.0f}},
            .glass = {{{{-1.1f, 0.5f}, {0.2f, 2.9f}}, {1.0f, 0.8f, 0.5f}},
                      {{{0.3f, 0.1f}, {1.1f, 2.9f}}, {0.4f, 0.3f, 0.2f}}}};
}

/// The same by adding up small pieces of the panes, of which those do not count that the wall hides.
glm::dvec3 integrated(const ShopWindow& window, glm::dvec3 p) {
    constexpr int k_steps = 300;
    glm::dvec3 sum{0.0};
    for (const GlowingGlass& glass : window.glass) {
        const glm::dvec2 min{glass.at.min}, size{glass.at.max - glass.at.min};
        for (int i = 0; i < k_steps; ++i) {
            for (int j = 0; j < k_steps; ++j) {
                const glm::dvec3 at{min.x + size.x * (i + 0.5) / k_steps,
                                    min.y + size.y * (j + 0.5) / k_steps, -static_cast<double>(k_reveal_m)};
                const glm::dvec3 r = at - p;
                const double crossing = p.x + r.x * p.z / (p.z + static_cast<double>(k_reveal_m));
                if (crossing < static_cast<double>(window.opening.min.x) ||
                    crossing > static_cast<double>(window.opening.max.x))
                    continue;
                const double r2 = glm::dot(r, r);
                sum += glm::dvec3{glass.radiance} * (r.y * -r.z / (r2 * r2)) * (size.x * size.y);
            }
        }
    }
    return sum / (std::numbers::pi * k_steps * k_steps);
}

TEST(ShopLight, IsWhatThePanesSendThroughTheOpening) {
    const Frame wall = turned({10.0f, 0.12f, -7.0f}, 0.7f);
    const ShopWindow window = window_at(wall);
    for (const glm::vec3 at : {glm::vec3{0.0f, 0.0f, 0.6f},
                               {0.5f, 0.0f, 0.1f},
                               {1.5f, 0.0f, 0.3f},
                               {-2.0f, 0.0f, 1.0f},
                               {0.2f, -0.12f, 1.7f},
                               {2.5f, 0.0f, 1.5f}}) {
        const glm::dvec3 found = glow_on_ground(window, wall.point(at), {});
        const glm::dvec3 expected = integrated(window, glm::dvec3{at});
        // The jamb runs through the steps that it cuts; places of the world are floats.
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], 5e-3 * std::max(expected.x, 0.01)) << at.x << ", " << at.z;
    }
    // Beside the opening, close to the wall, its jamb hides all of it.
    EXPECT_EQ(glow_on_ground(window, wall.point({1.5f, 0.0f, 0.02f}), {}), glm::dvec3{0.0});
    EXPECT_EQ(glow_on_ground(window, wall.point({0.0f, 0.0f, -1.0f}), {}), glm::dvec3{0.0}) << "behind";
}

TEST(ShopLight, FadesToNothingWhereItsReachEnds) {
    const ShopWindow window = window_at({});
    const GlowReach reach{.ahead_m = 4.0f, .beside_m = 3.0f};
    EXPECT_EQ(glow_on_ground(window, {0.0f, 0.0f, 4.0f}, reach), glm::dvec3{0.0});
    EXPECT_NEAR(glow_on_ground(window, {4.2f, 0.0f, 1.0f}, reach).x, 0.0, 1e-12);
    double before = 1.0;
    for (float z = 0.3f; z < 4.0f; z += 0.05f) {
        const double now = glow_on_ground(window, {0.0f, 0.0f, z}, reach).x;
        // Close to the foot, the window stands too high to shine on it; beyond it only fades.
        if (z > 0.6f) {
            EXPECT_LT(now, before) << z;
            EXPECT_LT(before - now, 0.02) << z;
        }
        before = now;
    }
    EXPECT_LT(before, 1e-4);
}

TEST(ShopLight, IsAsBrightAsThePictureOfThePane) {
    Scene scene;
    Image image{.name = "", .width = 4, .height = 2, .texels = std::vector<std::byte>(32, std::byte{255})};
    for (std::size_t texel : {1u, 2u, 5u, 6u})
        image.texels[4 * texel] = std::byte{188};
    for (std::size_t texel = 4; texel < 8; ++texel)
        image.texels[4 * texel + 1] = std::byte{188};
    scene.images.push_back(image);
    scene.textures.push_back({.name = "", .image = 0, .colour_space = ColourSpace::srgb, .sampler = {}});
    scene.materials.resize(2);
    scene.materials[0].emissive = {2.0f, 1.0f, 0.5f};
    scene.materials[1] = scene.materials[0];
    scene.materials[1].emissive_texture.texture = 0;
    EXPECT_EQ(mean_emission(scene, 0, {0, 0}, {1, 1}), glm::vec3(2, 1, 0.5f));
    const float half = linear_from_srgb(188.0f / 255.0f);
    EXPECT_NEAR(mean_emission(scene, 1, {0.25f, 0.0f}, {0.75f, 1.0f}).x, 2.0f * half, 1e-5f);
    EXPECT_NEAR(mean_emission(scene, 1, {1.0f, 1.0f}, {0.0f, 0.0f}).x, 1.0f + half, 1e-5f);
    EXPECT_EQ(mean_emission(scene, 1, {0.0f, 0.5f}, {1.0f, 0.0f}).y, 1.0f);
    EXPECT_NEAR(mean_emission(scene, 1, {0.0f, 1.0f}, {1.0f, 0.5f}).y, half, 1e-5f);
    EXPECT_NEAR(mean_emission(scene, 1, {0.0f, 0.0f}, {1.0f, 1.0f}).y, 0.5f + 0.5f * half, 1e-5f);
}

/// A texel's light.
glm::vec3 light_at(const Image& image, float strength, glm::uvec2 at) {
    glm::vec3 light;
    for (int c = 0; c < 3; ++c)
        light[c] =
            strength *
            linear_from_srgb_bytes()[std::to_integer<std::size_t>(
                image.texels[4 * (std::size_t{at.y} * image.width + at.x) + static_cast<std::size_t>(c)])];
    return light;
}

/// As a shader samples it: bilinear, clamped to the edge.
glm::vec3 sampled(const Image& image, float strength, glm::vec2 uv) {
    const glm::vec2 size{static_cast<float>(image.width), static_cast<float>(image.height)};
    const glm::vec2 at = glm::clamp(uv * size - 0.5f, glm::vec2{0.0f}, size - 1.0f);
    const glm::uvec2 low{at};
    const glm::uvec2 high = glm::min(low + 1u, glm::uvec2{image.width - 1, image.height - 1});
    const glm::vec2 share = at - glm::vec2{low};
    return glm::mix(
        glm::mix(light_at(image, strength, low), light_at(image, strength, {high.x, low.y}), share.x),
        glm::mix(light_at(image, strength, {low.x, high.y}), light_at(image, strength, high), share.x),
        share.y);
}

TEST(GroundLight, TexelsHoldTheFormula) {
    const StreetPlan plan;
    const GroundCharts charts = block_ground_charts(plan, 0.25f);
    const Frame block = turned({69.0f, 0.0f, -138.0f}, 0.0f);
    // In the middle of the side that faces +x.
    const Frame wall = block * turned({0.5f * plan.block_m, k_kerb_height_m, 3.1f}, 1.57079633f);
    const std::vector<ShopWindow> windows{window_at(wall)};
    const GroundLight light = bake_ground(charts, plan, block, windows);
    ASSERT_GT(light.strength, 0.1f);
    EXPECT_LT(light.strength, 0.5f) << "less than half of the sky is window";
    const GroundChart& chart = charts.chart_at(block.local(wall.point({0, 0, 1})));
    int lit = 0;
    for (std::uint32_t y = 0; y < chart.count.y; ++y) {
        for (std::uint32_t x = 0; x < chart.count.x; ++x) {
            const float t = k_first_t_m + charts.texel_m * static_cast<float>(y);
            const glm::vec3 place = block.point(
                chart.frame.point({chart.s_min_m + charts.texel_m * static_cast<float>(x), 0.0f, t}));
            const glm::vec3 found = light_at(light.image, light.strength, chart.first + glm::uvec2{x, y});
            const glm::dvec3 at{wall.local({place.x, k_kerb_height_m, place.z})};
            // Where nothing fades yet.
            if (t < 0.05f || t > 0.4f * glow_reach(plan).ahead_m || std::abs(at.x) > 3.0) continue;
            const glm::dvec3 expected = integrated(windows[0], at);
            // Half a byte's step of sRGB: 1/255 of a slope of up to 2.3, of the largest.
            EXPECT_NEAR(found.x, expected.x, 0.005 * light.strength + 0.02 * expected.x)
                << at.x << ", " << at.z;
            lit += found.x > 0.05f ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 30);
}

TEST(GroundLight, FollowsFromThePlaceAndNotFromTheChart) {
    // A mesh's corner lies in the charts of two sides; both say the same of it.
    const StreetPlan plan;
    const GroundCharts charts = block_ground_charts(plan, 0.25f);
    std::vector<ShopWindow> windows;
    const float end = 0.5f * plan.block_m - k_chamfer_m;
    for (const float angle : {0.0f, 1.57079633f})
        for (const float x : {-end + 2.0f, end - 2.0f})
            windows.push_back(window_at(turned({0, 0, 0}, angle) *
                                        turned({x, k_kerb_height_m, 0.5f * plan.block_m}, 0.0f)));
    const GroundLight light = bake_ground(charts, plan, {}, windows);
    float brightest = 0.0f;
    for (const float offset : {0.3f, 1.0f, 2.0f}) {
        const auto outline = block_outline(plan, offset);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::vec3 place{outline[i].x, k_kerb_height_m, outline[i].y};
            std::vector<glm::vec3> found;
            for (const GroundChart& chart : charts.charts)
                if (std::abs(chart.frame.local(place).z - offset) < 0.01f)
                    found.push_back(sampled(light.image, light.strength, charts.uv(chart, place)));
            ASSERT_EQ(found.size(), 2u);
            // A texel's grid lies otherwise in each.
            EXPECT_NEAR(found[0].x, found[1].x, 0.02f * light.strength) << i << " at " << offset;
            brightest = std::max(brightest, found[0].x);
        }
    }
    EXPECT_GT(brightest, 0.03f * light.strength);
}

TEST(GroundLight, EndsBeforeItsChartsDo) {
    const StreetPlan plan;
    const GroundCharts charts = block_ground_charts(plan, 0.25f);
    std::vector<ShopWindow> windows;
    for (int side = 0; side < 4; ++side) {
        const Frame turn = turned({0, 0, 0}, 1.57079633f * static_cast<float>(side));
        for (float x = -23.5f; x < 24.0f; x += 3.0f)
            windows.push_back(window_at(turn * turned({x, k_kerb_height_m, 0.5f * plan.block_m}, 0.0f)));
        const float middle = 0.5f * plan.block_m - 0.5f * k_chamfer_m;
        const Frame chamfer = turn * turned({middle, k_kerb_height_m, middle}, 0.25f * 3.14159265f);
        windows.push_back(window_at(chamfer * turned({-1.8f, 0, 0}, 0.0f)));
        windows.push_back(window_at(chamfer * turned({1.8f, 0, 0}, 0.0f)));
    }
    const GroundLight light = bake_ground(charts, plan, {}, windows);
    for (const GroundChart& chart : charts.charts) {
        // The last row is dark anyway; so is the one before it, or the step would be seen.
        for (std::uint32_t x = 0; x < chart.count.x; ++x) {
            const glm::uvec2 last = chart.first + glm::uvec2{x, chart.count.y - 2};
            EXPECT_EQ(light_at(light.image, light.strength, last), glm::vec3{0.0f}) << x;
        }
    }
    EXPECT_GT(light.strength, 0.1f);
}

/// The parts of a scene's ground that have light maps, by the material they would have by day.
struct LitPart {
    const Mesh* mesh;
    const Material* material;
    const Image* image;
};
std::vector<LitPart> lit_parts(const Scene& scene) {
    std::vector<LitPart> parts;
    for (const Shown& shown : shown_models(scene)) {
        for (const ModelPart& part : scene.models[shown.model].parts) {
            const Material& material = scene.materials[part.material];
            if (material.light_map_texture.texture == k_none) continue;
            parts.push_back({&scene.meshes[part.mesh], &material,
                             &scene.images[scene.textures[material.light_map_texture.texture].image]});
        }
    }
    return parts;
}

TEST(ShopGlow, FallsOnTheGroundAtNightOnly) {
    const Scene day = generate_place(k_small, 1).scene;
    EXPECT_TRUE(lit_parts(day).empty());
    for (const Mesh& mesh : day.meshes)
        EXPECT_TRUE(mesh.uv1.empty());
    const Scene& night = small_night();
    const std::vector<LitPart> parts = lit_parts(night);
    // A block and four edges; paving, kerb, gutter and asphalt of each.
    EXPECT_EQ(parts.size(), 20u);
    std::map<std::string, int> materials;
    for (const LitPart& part : parts) {
        ++materials[part.material->name];
        EXPECT_TRUE(is_light_mapped(*part.material));
        EXPECT_EQ(part.material->light_map_texture.uv_set, 1u);
        ASSERT_EQ(part.mesh->uv1.size(), part.mesh->positions.size());
        const Texture& texture = night.textures[part.material->light_map_texture.texture];
        EXPECT_EQ(texture.sampler.wrap_u, WrapMode::clamp_to_edge);
        EXPECT_EQ(texture.colour_space, ColourSpace::srgb);
    }
    EXPECT_EQ(materials.size(), 4u);
}

TEST(ShopGlow, ComesFromShopsThatAreOpen) {
    const auto all = [](const Scene& scene) {
        double sum = 0.0;
        for (const LitPart& part : lit_parts(scene)) {
            if (part.material->name != "paving") continue;
            for (std::uint32_t y = 0; y < part.image->height; ++y)
                for (std::uint32_t x = 0; x < part.image->width; ++x)
                    sum += static_cast<double>(
                        light_at(*part.image, part.material->light_map_strength, {x, y}).x);
        }
        return sum;
    };
    // Of three dozen independent houses, 0.6 of the shops at 22:00 and 0.15 at 3:00.
    const double night = all(small_night()), late = all(generate_place(k_small, 1, {3 * 60}).scene);
    EXPECT_GT(late, 0.0);
    EXPECT_LT(late, 0.5 * night);
}

TEST(ShopGlow, IsNowhereBrighterThanTheWindows) {
    const Scene& night = small_night();
    glm::vec3 emitted{0.0f};
    for (const Material& material : night.materials)
        if (material.name == "glass-shop") emitted = material.emissive;
    for (const LitPart& part : lit_parts(night)) {
        EXPECT_GT(part.material->light_map_strength, 0.02f * emitted.x);
        EXPECT_LT(part.material->light_map_strength, 0.5f * emitted.x) << "half of the sky is window";
        // Warm, as the windows are.
        glm::vec3 sum{0.0f};
        for (std::uint32_t y = 0; y < part.image->height; ++y)
            for (std::uint32_t x = 0; x < part.image->width; ++x)
                sum += light_at(*part.image, 1.0f, {x, y});
        EXPECT_GT(sum.x, sum.y);
        EXPECT_GT(sum.y, sum.z);
    }
}

TEST(ShopGlow, IsGoneWhereItsGroundEnds) {
    const Scene& night = small_night();
    const CityPlan plan = plan_of({.blocks_x = 1, .blocks_z = 1});
    const float half_street = 0.5f * plan.street.street_width_m;
    int on_rims = 0, inside = 0;
    for (const LitPart& part : lit_parts(night)) {
        const bool block = part.mesh->name == "block-ground";
        const float strength = part.material->light_map_strength;
        const auto is_rim = [&](glm::vec3 p) {
            const float to_rim = block ? 0.5f * plan.street.pitch_m() - std::max(std::abs(p.x), std::abs(p.z))
                                       : half_street - p.z;
            return to_rim < 1e-3f;
        };
        for (std::size_t i = 0; i < part.mesh->indices.size(); ++i) {
            const std::uint32_t a = part.mesh->indices[i];
            const std::uint32_t b = part.mesh->indices[i % 3 == 2 ? i - 2 : i + 1];
            for (int k = 0; k <= 300; ++k) {
                const float share = static_cast<float>(k) / 300.0f;
                const glm::vec3 p = glm::mix(part.mesh->positions[a], part.mesh->positions[b], share);
                const glm::vec3 light =
                    sampled(*part.image, strength, glm::mix(part.mesh->uv1[a], part.mesh->uv1[b], share));
                inside += light.x > 0.1f * strength ? 1 : 0;
                // About the city's corners, shops of the next side shine across.
                if (!is_rim(p) || (!block && p.x < half_street)) continue;
                ++on_rims;
                // The first steps of a byte: the last row before the rim has a little light.
                EXPECT_LE(light.x, 2.0f / 255.0f / 12.92f * strength) << p.x << ", " << p.z;
            }
        }
    }
    EXPECT_GT(on_rims, 2000);
    EXPECT_GT(inside, 500);
}

TEST(ShopGlow, LeavesTheSidesOfKerbsDark) {
    const Scene& night = small_night();
    std::size_t sides = 0;
    for (const LitPart& part : lit_parts(night)) {
        for (std::size_t i = 0; i < part.mesh->positions.size(); ++i) {
            if (part.mesh->normals[i].y > 0.5f) continue;
            ++sides;
            EXPECT_LT(sampled(*part.image, 1.0f, part.mesh->uv1[i]).x, 1e-5f) << "rounding of coordinates";
        }
    }
    EXPECT_GT(sides, 30u);
}

TEST(ShopGlow, TakesLittleMemoryInALargeCity) {
    std::size_t texels = 0, images = 0;
    for (const Image& image : generate_place("city:blocks=10x10,walkers=0,cars=0", 1, k_night).scene.images) {
        if (image.name != "shop-glow") continue;
        texels += std::size_t{image.width} * image.height;
        ++images;
    }
    EXPECT_GT(images, 100u);
    EXPECT_LT(texels * 4, 16u << 20) << "bytes";
}

}  // namespace
}  // namespace rambla::assets::test
