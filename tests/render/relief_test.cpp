// Heights below surfaces: what is seen of them is what is seen of geometry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/passes/surface_detail.h"
#include "render/shader_harness.h"
#include "render/support.h"

namespace {

using namespace rambla;
using render::DetailGrade;
using render::SurfaceDetail;
using tests::add;
using tests::Inputs;
using tests::Picture;
using tests::Random;
using tests::ShaderHarness;
using tests::Stage;

// A plane is met exactly: between two places, the surface is taken to be straight. d is depth at u = 0 and
// its slope.
TEST(Relief, APlaneIsMetWhereTheLineMeetsIt) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    for (int i = 0; i < 20000; ++i) {
        const float start = random(), end = random();  // depth at both ends of the shift
        const float steps = std::floor(1.0f + 40.0f * random());
        add(inputs, {start, end - start, steps, 0});
    }
    add(inputs, {0, 1, 16, 0});
    add(inputs, {1, 0, 16, 0});
    add(inputs, {1, 0, 1, 0});
    add(inputs, {0, 0, 1, 0});
    const auto found =
        gpu.run("relief.glsl", "plane = a.xy;\nresult.x = relief_entry(vec2(0.0), vec2(1.0, 0.0), int(a.z));",
                inputs, "vec2 plane;\nfloat relief_depth(vec2 uv) { return plane.x + plane.y * uv.x; }\n");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double start = inputs[4 * i].x, slope = inputs[4 * i].y;
        const double expected = start / (1.0 - slope);  // start + slope·t = t; slope < 1 but where start is 0
        // Differences of depths near 1 have rounding errors of 1e-7, and the line and the plane may be nearly
        // parallel.
        const double tolerance = 2e-6 / std::max(1.0 - slope, 1e-3);
        ASSERT_NEAR(found[i].x, start == 0.0 ? 0.0 : std::min(expected, 1.0), tolerance)
            << start << " + " << slope << " t in " << inputs[4 * i].z << " steps";
    }
}

// What rises above the line for longer than a step is never stepped over, and is met within a step.
TEST(Relief, TheFirstWallIsMetWithinAStep) {
    ShaderHarness gpu;
    Random random;
    Inputs inputs;
    constexpr int k_steps = 32, k_fine = 64 * k_steps;
    for (int i = 0; i < 20000; ++i)
        add(inputs, {random(), 1.0f + 5.0f * random(), 0, 0});  // phase and number of waves along the shift
    const auto found = gpu.run(
        "relief.glsl", "wave = a.xy;\nresult.x = relief_entry(vec2(0.0), vec2(1.0, 0.0), 32);", inputs,
        "vec2 wave;\n"
        "float relief_depth(vec2 uv) { return abs(2.0 * fract(wave.x + wave.y * uv.x) - 1.0); }\n");
    int brief = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double phase = inputs[4 * i].x, waves = inputs[4 * i].y;
        const auto is_inside = [&](int fine) {
            const double t = static_cast<double>(fine) / k_fine, x = phase + waves * t;
            return std::abs(2.0 * (x - std::floor(x)) - 1.0) <= t;
        };
        int first = 0;
        while (!is_inside(first))  // at the latest at 1
            ++first;
        int end = first;
        while (end < k_fine && is_inside(end))
            ++end;
        if (end < k_fine && end - first <= 65) {
            ++brief;
            continue;
        }
        EXPECT_NEAR(found[i].x, static_cast<double>(first) / k_fine, 1.0 / k_steps + 1.0 / k_fine)
            << phase << " " << waves;
    }
    EXPECT_LT(brief, 10000) << "at least half are tested";
}

TEST(Relief, ShiftsStayFiniteAtGrazingAngles) {
    ShaderHarness gpu;
    Inputs inputs;
    for (const float z : {1.0f, 0.5f, 0.125f, 1e-3f, 0.0f, -1e-3f, -1.0f}) {
        const float x = std::sqrt(std::max(0.0f, 1.0f - z * z));
        add(inputs, {x, 0, z, 0.05f});
        add(inputs, {0, x, z, 0.05f});
    }
    const auto found =
        gpu.run("relief.glsl", "result = vec4(deepest_shift(a.xyz, a.w), limited_shift(a.xyz, a.w));", inputs,
                "float relief_depth(vec2 uv) { return 0.0; }\n");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::vec4 eye = inputs[4 * i];
        const float rise = std::max(eye.z, 0.125f);
        EXPECT_NEAR(found[i].x, -eye.x / rise * 0.05f, 1e-6f);
        EXPECT_NEAR(found[i].y, eye.y / rise * 0.05f, 1e-6f) << "v points down";
        EXPECT_NEAR(found[i].z, -eye.x * 0.05f, 1e-7f);
        EXPECT_NEAR(found[i].w, eye.y * 0.05f, 1e-7f);
    }
}

TEST(Relief, MaterialsSampleWhatTheGradeAsksForAndTheyHave) {
    assets::Material m;
    EXPECT_EQ(surface_detail(m, DetailGrade::occlusion), SurfaceDetail::colour);
    m.occlusion_texture.texture = 0;
    EXPECT_EQ(surface_detail(m, DetailGrade::occlusion), SurfaceDetail::surface);
    m.normal_texture.texture = 0;
    EXPECT_EQ(surface_detail(m, DetailGrade::flat), SurfaceDetail::surface);
    EXPECT_EQ(surface_detail(m, DetailGrade::normal), SurfaceDetail::normals);
    EXPECT_EQ(surface_detail(m, DetailGrade::occlusion), SurfaceDetail::normals);
    m.height_texture.texture = 0;
    EXPECT_EQ(surface_detail(m, DetailGrade::occlusion), SurfaceDetail::normals) << "of no depth";
    m.height_depth = 0.01f;
    EXPECT_EQ(surface_detail(m, DetailGrade::flat), SurfaceDetail::surface);
    EXPECT_EQ(surface_detail(m, DetailGrade::normal), SurfaceDetail::normals);
    EXPECT_EQ(surface_detail(m, DetailGrade::parallax), SurfaceDetail::parallax);
    EXPECT_EQ(surface_detail(m, DetailGrade::occlusion), SurfaceDetail::parallax_occlusion);
    m.alpha_mode = assets::AlphaMode::mask;
    EXPECT_EQ(surface_detail(m, DetailGrade::occlusion), SurfaceDetail::normals);
}

constexpr int k_stripes = 64;
constexpr float k_depth = 0.1f;  ///< in u; the square is 2 m wide, so 0.2 m

/// A square whose colour says which stripe of the texture is seen, with heights.
struct Striped {
    explicit Striped(bool along_v, const std::vector<glm::u8vec4>& heights) {
        std::vector<glm::u8vec4> stripes;
        for (int i = 0; i < k_stripes; ++i)
            stripes.push_back({4 * i + 2, 0, 0, 255});
        const auto strip = [&](const std::vector<glm::u8vec4>& texels) {
            const auto count = static_cast<std::uint32_t>(texels.size());
            return along_v ? stage.texture(1, count, texels) : stage.texture(count, 1, texels);
        };
        material.unlit = true;
        material.base_colour_texture = strip(stripes);
        material.height_texture = strip(heights);
        material.height_depth = k_depth;
        stage.settings.shadows.method = render::ShadowMethod::off;
        stage.settings.detail = {.grade = DetailGrade::occlusion, .steps = 32};
    }
    void place() { stage.place(stage.square(), stage.material(material)); }
    [[nodiscard]] static int stripe(const Picture& picture, std::uint32_t x, std::uint32_t y) {
        return static_cast<int>(std::floor(picture.radiance(x, y).x * 255.0f / 4.0f));
    }

    Stage stage;
    assets::Material material;
};

/// Where the ray through the middle of a pixel meets the plane z = 0, and its direction.
struct Ray {
    glm::dvec3 at, direction;
};
Ray ray_through(const Stage& stage, std::uint32_t x, std::uint32_t y) {
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{stage.frame.view.clip_from_view} *
                                                    glm::dmat4{stage.frame.view.view_from_world});
    const glm::dvec2 size{stage.frame.view.size_px};
    const glm::dvec2 ndc = glm::dvec2{(x + 0.5) / size.x, 1.0 - (y + 0.5) / size.y} * 2.0 - 1.0;
    const glm::dvec4 far = world_from_clip * glm::dvec4{ndc, 0.5, 1.0};
    const glm::dvec3 direction = glm::normalize(glm::dvec3{far} / far.w);
    const glm::dvec3 eye{stage.eye};
    return {eye - direction * (eye.z / direction.z), direction};
}

/// u or v of a place on the square's plane.
double coordinate(glm::dvec3 at, bool along_v) {
    return along_v ? 0.5 - 0.5 * at.y : 0.5 + 0.5 * at.x;
}

// A relief that is as deep everywhere looks like a square that lies that deep.
TEST(Relief, EvenDepthLooksLikeASquareThatLiesDeeper) {
    for (const bool along_v : {false, true}) {
        for (const auto path : {render::LightingPath::tiled, render::LightingPath::forward}) {
            for (const DetailGrade grade :
                 {DetailGrade::normal, DetailGrade::parallax, DetailGrade::occlusion}) {
                Striped striped{along_v, {{0, 0, 0, 255}}};
                striped.place();
                Stage& stage = striped.stage;
                stage.settings.detail.grade = grade;
                stage.settings.lighting.path = path;
                for (const glm::vec3 from : {glm::vec3{0, 0, 3}, {2, 1, 2}, {-2, -1.5f, 1}}) {
                    stage.look(from, {0, 0, 0});
                    const Picture picture = stage.draw();
                    int seen = 0;
                    for (std::uint32_t y = 0; y < 128; y += 5) {
                        for (std::uint32_t x = 0; x < 128; x += 5) {
                            const Ray ray = ray_through(stage, x, y);
                            // 0.55: what the eye sees deeper lies on the square, too.
                            if (std::abs(ray.at.x) > 0.55 || std::abs(ray.at.y) > 0.55) continue;
                            ++seen;
                            const double deep_m = grade == DetailGrade::normal ? 0.0 : 2.0 * k_depth;
                            // Offset limiting leaves out the division by z.
                            const double along =
                                grade == DetailGrade::parallax ? deep_m : deep_m / -ray.direction.z;
                            const double expected =
                                k_stripes * coordinate(ray.at + ray.direction * along, along_v);
                            const int found = Striped::stripe(picture, x, y);
                            // Interpolated coordinates are exact to a 1000th of a stripe or so.
                            EXPECT_NEAR(found + 0.5, expected, 0.51)
                                << x << " " << y << " grade " << static_cast<int>(grade) << " v " << along_v
                                << " from " << from.x;
                        }
                    }
                    EXPECT_GT(seen, 20);
                }
            }
        }
    }
}

// A step down from one half to the other, against the same in geometry: seen across it, what is near its foot
// is hidden.
/// @param scale_and_offset  of the coordinates of the heights, whose middle stays where it is
void expect_a_step(glm::vec2 scale_and_offset) {
    Striped striped{false, {{255, 255, 255, 255}, {0, 0, 0, 255}}};
    striped.material.height_texture.scale.x = scale_and_offset.x;
    striped.material.height_texture.offset.x = scale_and_offset.y;
    striped.place();
    Stage& stage = striped.stage;
    for (const float side : {-1.5f, 1.5f}) {
        stage.look({side, 0.2f, 2.0f}, {0, 0, 0});
        const Picture picture = stage.draw();
        int hidden = 0, seen = 0;
        for (std::uint32_t y = 20; y < 108; y += 4) {
            for (std::uint32_t x = 0; x < 128; ++x) {
                const Ray ray = ray_through(stage, x, y);
                if (std::abs(ray.at.x) > 0.6 || std::abs(ray.at.y) > 0.6) continue;
                ++seen;
                double u = coordinate(ray.at, false);
                if (u > 0.5) {
                    const double deep = u + k_depth * ray.direction.x / -ray.direction.z;
                    if (deep < 0.5) ++hidden;
                    u = std::max(deep, 0.5);  // on the floor, or on the wall of the step
                }
                const double step = k_depth * std::abs(ray.direction.x / ray.direction.z) / 32.0;
                EXPECT_NEAR(Striped::stripe(picture, x, y) + 0.5, u * k_stripes, 0.51 + step * k_stripes)
                    << x << " " << y << " side " << side;
            }
        }
        EXPECT_GT(seen, 300);
        EXPECT_EQ(hidden > 50, side > 0.0f) << "the wall is seen from the deep side only: " << hidden;
    }
}

TEST(Relief, AStepHidesWhatLiesBehindIt) {
    expect_a_step({1.0f, 0.0f});
}

TEST(Relief, ShiftsFollowTheTransformOfTheHeights) {
    expect_a_step({0.5f, 0.25f});
    expect_a_step({0.8f, 0.1f});
}

TEST(Relief, ShiftsFollowTheTransformOfWhatIsSampled) {
    Striped striped{false, {{0, 0, 0, 255}}};
    striped.material.base_colour_texture.scale.x = 0.5f;
    striped.material.base_colour_texture.offset.x = 0.25f;
    striped.place();
    Stage& stage = striped.stage;
    stage.look({2, 1, 2}, {0, 0, 0});
    const Picture picture = stage.draw();
    for (std::uint32_t x = 4; x < 128; x += 5) {
        const Ray ray = ray_through(stage, x, 64);
        if (std::abs(ray.at.x) > 0.55) continue;
        const glm::dvec3 deep = ray.at + ray.direction * (2.0 * k_depth / -ray.direction.z);
        EXPECT_NEAR(Striped::stripe(picture, x, 64) + 0.5, k_stripes * (0.25 + 0.5 * coordinate(deep, false)),
                    0.51)
            << x;
    }
}

TEST(Relief, OtherCoordinatesStayWhereTheyAre) {
    Striped striped{false, {{0, 0, 0, 255}}};
    striped.material.base_colour_texture.uv_set = 1;
    striped.place();
    Stage& stage = striped.stage;
    stage.scene.meshes[0].uv1 = stage.scene.meshes[0].uv0;
    stage.look({1.5f, 0, 2.0f}, {0, 0, 0});
    const Picture relief = stage.draw();
    stage.settings.detail.grade = DetailGrade::normal;
    EXPECT_EQ(relief.bytes, stage.draw().bytes);
}

TEST(Relief, MirroredCoordinatesShowTheSame) {
    const std::vector<glm::u8vec4> heights{{0, 0, 0, 255}};
    Striped striped{true, heights};
    striped.place();
    striped.stage.look({0.5f, 1.5f, 1.5f}, {0, 0, 0});
    const Picture expected = striped.stage.draw();
    // v upwards with the stripes turned round, and the bitangent against v again.
    Striped mirrored{true, heights};
    mirrored.material.base_colour_texture.scale.y = -1.0f;
    mirrored.material.base_colour_texture.offset.y = 1.0f;
    mirrored.place();
    assets::Mesh& mesh = mirrored.stage.scene.meshes[0];
    for (glm::vec2& uv : mesh.uv0)
        uv.y = 1.0f - uv.y;
    mesh.tangents.assign(4, glm::vec4{1, 0, 0, -1});
    mirrored.stage.look({0.5f, 1.5f, 1.5f}, {0, 0, 0});
    const Picture found = mirrored.stage.draw();
    int differ = 0;
    int seen = 0;
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            const Ray ray = ray_through(striped.stage, x, y);
            if (std::abs(ray.at.x) > 0.55 || std::abs(ray.at.y) > 0.55) continue;
            ++seen;
            differ += Striped::stripe(expected, x, y) != Striped::stripe(found, x, y);
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_LT(differ, seen / 100);  // rounding at the rims of stripes
}

TEST(Relief, NothingShiftsFromBehindOrWithoutTangents) {
    for (const bool behind : {false, true}) {
        Striped striped{false, {{0, 0, 0, 255}}};
        striped.material.double_sided = true;
        striped.place();
        Stage& stage = striped.stage;
        if (!behind) stage.scene.meshes[0].tangents.assign(4, glm::vec4{0.0f});
        stage.look({1.5f, 0, behind ? -2.0f : 2.0f}, {0, 0, 0});
        const Picture relief = stage.draw();
        stage.settings.detail.grade = DetailGrade::normal;
        EXPECT_EQ(relief.bytes, stage.draw().bytes) << "behind " << behind;
    }
}

}  // namespace
