#include "systems/look/texture_demand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "systems/look/projection.h"
#include "systems/pipeline.h"
#include "unit/systems/random.h"

namespace rambla::systems {
namespace {

using test::Random;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinity = std::numeric_limits<float>::infinity();

assets::TextureData image_of(glm::uvec2 size) {
    assets::TextureData image;
    const auto levels = static_cast<std::uint32_t>(std::bit_width(std::max(size.x, size.y)));
    for (std::uint32_t level = 0; level < levels; ++level)
        image.levels.push_back({std::max(size.x >> level, 1u), std::max(size.y >> level, 1u), 0, 0, 0.0f});
    return image;
}

/// One mesh with one textured material, and a world in which it stands.
struct Textured {
    explicit Textured(assets::Mesh mesh, glm::uvec2 size = {1024, 1024}) {
        processed.meshes.push_back({.mesh = mesh, .lods = {}, .shadow = {}, .sphere = {}, .occluder = {}});
        processed.images.push_back(image_of(size));
        processed.textures.push_back({.name = "", .image = 0, .sampler = {}});
        processed.materials.emplace_back().base_colour_texture.texture = 0;
        scene.meshes.push_back(std::move(mesh));
        scene.materials = processed.materials;
        scene.models.push_back({.name = "", .parts = {{0, 0}}});
        for (const glm::vec3& point : scene.meshes[0].positions)
            box.expand(point);
    }

    /// Adds one instance.
    void place(const glm::mat3& linear, glm::vec3 translation_m) {
        world.create(WorldTransform{{0, 0, 0}, linear, translation_m}, Renderable{0, 0, 0},
                     LocalBounds{box.centre(), box.half_extents()});
    }

    /// What the systems that look at the world find.
    [[nodiscard]] std::uint8_t demand_of_frame(const Eye& eye) {
        world.set_resource(TextureUses{scene, processed});
        build_frame(world, eye, 1.0f, frame);
        return frame.texture_demand.at(0);
    }

    /// The same without a sun, from the origin, and without waking other threads.
    [[nodiscard]] std::uint8_t demand(const Eye& eye) {
        const float aspect = static_cast<float>(eye.size_px.x) / static_cast<float>(eye.size_px.y);
        frame.view.size_px = eye.size_px;
        frame.view.orthographic = eye.kind == assets::CameraKind::orthographic;
        frame.view.clip_from_view =
            frame.view.orthographic
                ? reversed_orthographic(eye.half_height_m * aspect, eye.half_height_m, eye.near_m, eye.far_m)
                : reversed_perspective(eye.vertical_fov_rad, aspect, eye.near_m);
        const CullVolume camera = frustum_volume(frame.view.clip_from_view);
        Culling culling;
        culling(world, {}, std::span{&camera, 1});
        TextureDemand{}(culling, TextureUses{scene, processed}, Deformations{}, frame);
        return frame.texture_demand.at(0);
    }

    assets::Scene scene;
    assets::ProcessedScene processed;
    assets::Bounds box;
    ecs::World world;
    Frame frame;
};

/// Two metres wide, with the texture once per metre.
assets::Mesh square() {
    assets::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.uv0 = {{0, 2}, {2, 2}, {2, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

Eye eye_of(glm::uvec2 size_px, float fov_rad = 1.0f) {
    Eye eye;
    eye.size_px = size_px;
    eye.vertical_fov_rad = fov_rad;
    return eye;
}

/// Pixels between texels of a wall that faces the eye: the level that it is seen at.
double level_of_wall(double distance_m, double fov_rad, double height_px, double texels_per_m) {
    return std::log2(texels_per_m * distance_m * 2.0 * std::tan(0.5 * fov_rad) / height_px);
}

/// The finest level at which any pixel samples one triangle, found by sampling: coordinates at each pixel
/// that the triangle covers and at its neighbours, on the triangle's plane.
std::optional<double> sampled_level(const std::array<glm::dvec3, 3>& corners,
                                    const std::array<glm::dvec2, 3>& texels, const Frame& frame) {
    const FrameView& view = frame.view;
    const glm::dmat4 clip_from_world{view.clip_from_view * view.view_from_world};
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{clip_from_world});
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area2 = glm::dot(normal, normal);
    struct Hit {
        glm::dvec3 shares{0.0};
        bool before_eye = false;
    };
    const auto hit = [&](double x, double y) {
        const glm::dvec2 ndc = 2.0 * glm::dvec2{x, y} / glm::dvec2{view.size_px} - 1.0;
        const glm::dvec4 near = world_from_clip * glm::dvec4{ndc, 1.0, 1.0};
        const glm::dvec4 far = world_from_clip * glm::dvec4{ndc, 0.25, 1.0};
        const glm::dvec3 from = glm::dvec3{near} / near.w;
        const glm::dvec3 along = glm::dvec3{far} / far.w - from;
        const double t = glm::dot(corners[0] - from, normal) / glm::dot(along, normal);
        const glm::dvec3 p = from + t * along;
        Hit result;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 a = corners[(i + 1) % 3] - p, b = corners[(i + 2) % 3] - p;
            result.shares[i] = glm::dot(glm::cross(a, b), normal) / area2;
        }
        result.before_eye = t >= 0.0;
        return result;
    };
    const auto coordinates = [&](const Hit& at) {
        return texels[0] * at.shares[0] + texels[1] * at.shares[1] + texels[2] * at.shares[2];
    };
    std::optional<double> finest;
    for (std::uint32_t y = 0; y < view.size_px.y; ++y) {
        for (std::uint32_t x = 0; x < view.size_px.x; ++x) {
            const Hit here = hit(x + 0.5, y + 0.5);
            const double least = std::min({here.shares[0], here.shares[1], here.shares[2]});
            if (!here.before_eye || !(least >= 0.0)) continue;
            double longest = 0.0;
            for (const Hit& there : {hit(x + 1.5, y + 0.5), hit(x + 0.5, y + 1.5)}) {
                const glm::dvec2 step = glm::abs(coordinates(there) - coordinates(here));
                longest = std::max({longest, step.x, step.y});
            }
            const double level = std::log2(std::max(longest, 1e-300));
            finest = std::min(finest.value_or(level), level);
        }
    }
    return finest;
}

TEST(TextureDemand, IsNeverCoarserThanAnyPixelOfRandomTrianglesSamples) {
    Random random{1};
    int seen = 0;
    double excess = 0.0;
    for (int i = 0; i < 1500; ++i) {
        assets::Mesh mesh;
        mesh.indices = {0, 1, 2};
        const float uv_size = std::exp2(random.uniform(-3, 5));
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.push_back(random.point(std::exp2(random.uniform(-2, 3))));
            mesh.uv0.push_back(uv_size * glm::vec2{random.uniform(-1, 1), random.uniform(-1, 1)});
        }
        Textured textured{mesh, {1u << (4 + random.below(7)), 1u << (4 + random.below(7))}};
        assets::TextureSlot& slot = textured.processed.materials[0].base_colour_texture;
        slot.scale = {random.uniform(-3, 3), random.uniform(0.2f, 2)};
        slot.rotation_rad = random.uniform(-4, 4);
        slot.offset = {random.uniform(-1, 1), 7.0f};
        glm::mat3 linear = glm::mat3_cast(random.rotation());
        if (i % 2 == 0) linear = linear * std::exp2(random.uniform(-3, 3));
        if (i % 3 == 0) linear[1] *= random.uniform(-3, 3);
        const glm::vec3 at = glm::vec3{0.0f, 0.0f, -random.uniform(0, 30)} + random.point(2.0f);
        textured.place(linear, at);
        Eye eye = eye_of({32, 20}, random.uniform(0.3f, 2.0f));
        if (i % 4 == 0) {
            eye.kind = assets::CameraKind::orthographic;
            eye.half_height_m = std::exp2(random.uniform(-2, 4));
        }
        const std::uint8_t demand = textured.demand(eye);

        std::array<glm::dvec3, 3> corners;
        std::array<glm::dvec2, 3> texels;
        const glm::dvec2 size{textured.processed.images[0].levels[0].width,
                              textured.processed.images[0].levels[0].height};
        const double c = std::cos(slot.rotation_rad), s = std::sin(slot.rotation_rad);
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = glm::dvec3{linear * mesh.positions[k] + at};
            const glm::dvec2 scaled = glm::dvec2{mesh.uv0[k]} * glm::dvec2{slot.scale};
            texels[k] = glm::dvec2{c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y} * size;
        }
        const std::optional<double> sampled = sampled_level(corners, texels, textured.frame);
        if (!sampled) continue;
        const double last = static_cast<double>(textured.processed.images[0].levels.size() - 1);
        const double used = std::clamp(std::floor(*sampled), 0.0, last);
        ASSERT_NE(demand, k_not_demanded) << i;
        ASSERT_LE(demand, used) << "triangle " << i << " is sampled at " << *sampled;
        excess += used - demand;
        ++seen;
    }
    EXPECT_GT(seen, 500) << "the triangles must be seen";
    // Boxes around triangles reach nearer to the eye than they do, and random coordinates are stretched one
    // way: the mean stays below two levels all the same.
    EXPECT_LT(excess / seen, 2.0);
}

TEST(TextureDemand, OfAWallIsWithinOneLevelOfWhatItIsSeenAt) {
    for (const float distance_m : {2.0f, 5.0f, 17.0f, 64.0f, 300.0f}) {
        Textured textured{square()};
        textured.place(glm::mat3{1.0f}, {0, 0, -distance_m});
        const double seen = level_of_wall(distance_m, 0.2, 480, 1024);
        const int demand = textured.demand(eye_of({640, 480}, 0.2f));
        EXPECT_LE(demand, std::max(0.0, seen));
        EXPECT_GE(demand, std::min(10.0, std::floor(seen - 1.0)));
    }
}

TEST(TextureDemand, OfAFrameIsWhatLookingFinds) {
    Textured textured{square()};
    textured.place(glm::mat3{1.0f}, {0, 0, -40});
    EXPECT_EQ(textured.demand_of_frame(eye_of({640, 480})), textured.demand(eye_of({640, 480})));
}

TEST(TextureDemand, OfASupersampledFrameIsThatOfThePictureThatIsDrawn) {
    Textured textured{square()};
    textured.place(glm::mat3{1.0f}, {0, 0, -5});
    Eye eye = eye_of({160, 120});
    const std::uint8_t of_shown = textured.demand_of_frame(eye);
    eye.samples = 4;
    const std::uint8_t of_drawn = textured.demand_of_frame(eye);
    EXPECT_EQ(textured.frame.view.size_px, (glm::uvec2{640, 480}));
    EXPECT_EQ(textured.frame.view.shown_px(), eye.size_px);
    EXPECT_EQ(of_drawn, textured.demand(eye_of({640, 480})));
    EXPECT_EQ(of_drawn + 2, of_shown) << "four times as fine";
}

TEST(TextureDemand, FollowsTheNearestInstanceItsScaleAndTheSizeOfThePicture) {
    Textured textured{square()};
    textured.place(glm::mat3{1.0f}, {0, 0, -100});
    const int far = textured.demand(eye_of({640, 480}));
    EXPECT_EQ(textured.demand(eye_of({2560, 1920})), far - 2) << "four times the pixels";
    textured.place(glm::mat3{16.0f}, {0, 0, -100});
    EXPECT_EQ(textured.demand(eye_of({640, 480})), far - 4) << "sixteen times as large";
    textured.place(glm::mat3{1.0f}, {0, 0, 100});
    EXPECT_EQ(textured.demand(eye_of({640, 480})), far - 4) << "what stands behind is not seen";
    textured.place(glm::mat3{1.0f}, {0, 0, -1.0f});
    EXPECT_EQ(textured.demand(eye_of({640, 480})), 0);
}

TEST(TextureDemand, CountsRepeatsOfTheTextureTransform) {
    Textured textured{square()};
    textured.place(glm::mat3{1.0f}, {0, 0, -50});
    const int once = textured.demand(eye_of({640, 480}));
    textured.processed.materials[0].base_colour_texture.scale = {4, 4};
    EXPECT_EQ(textured.demand(eye_of({640, 480})), once + 2);
    textured.processed.materials[0].base_colour_texture.rotation_rad = 1.0f;
    EXPECT_EQ(textured.demand(eye_of({640, 480})), once + 2);
}

TEST(TextureDemand, IsThatOfEverySlotThatShadersSample) {
    using assets::Material;
    Textured textured{square()};
    textured.place(glm::mat3{1.0f}, {0, 0, -50});
    const int expected = textured.demand(eye_of({640, 480}));
    for (const auto slot :
         {&Material::metalness_roughness_texture, &Material::normal_texture, &Material::occlusion_texture,
          &Material::emissive_texture, &Material::specular_texture, &Material::specular_colour_texture,
          &Material::light_map_texture}) {
        textured.processed.materials[0] = {};
        (textured.processed.materials[0].*slot).texture = 0;
        EXPECT_EQ(textured.demand(eye_of({640, 480})), expected);
    }
}

TEST(TextureDemand, OfOrthographicViewsDoesNotDependOnDistance) {
    for (const float distance_m : {3.0f, 500.0f}) {
        Textured textured{square()};
        textured.place(glm::mat3{1.0f}, {0, 0, -distance_m});
        Eye eye = eye_of({480, 480});
        eye.kind = assets::CameraKind::orthographic;
        eye.half_height_m = 60.0f;  // a pixel is 0.25 m: 256 texels, level 8
        EXPECT_EQ(textured.demand(eye), 7);
    }
}

TEST(TextureDemand, NeedsTheFinestLevelOfAllThatCannotBeBounded) {
    const auto demand_with = [](const std::function<void(Textured&)>& change) {
        Textured textured{square()};
        textured.place(glm::mat3{1.0f}, {0, 0, -200});
        change(textured);
        return int{textured.demand(eye_of({640, 480}))};
    };
    EXPECT_GT(demand_with([](Textured&) {}), 5);
    const auto with_bounds = [&](glm::vec3 centre, glm::vec3 half) {
        return demand_with([=](Textured& t) {
            t.world.create(WorldTransform{{0, 0, 0}, glm::mat3{1.0f}, {0, 0, 0}}, Renderable{0, 0, 0},
                           LocalBounds{centre, half});
        });
    };
    EXPECT_EQ(with_bounds({0, 0, 0}, {5, 5, 5}), 0) << "the eye inside of the bounds";
    EXPECT_EQ(with_bounds({0, 0, -0.06f}, {0, 0, 0}), 0) << "the eye on the mesh, or almost";
    EXPECT_EQ(with_bounds({0, 0, -200}, {k_nan, 1, 1}), 0);
    EXPECT_EQ(with_bounds({k_nan, 0, -200}, {1, 1, 1}), 0);
    EXPECT_EQ(with_bounds({0, 0, 0}, glm::vec3{k_infinity}), 0);
    EXPECT_EQ(with_bounds({0, 0, 0}, glm::vec3{3e38f}), 0);
    EXPECT_EQ(demand_with([](Textured& t) { t.place(glm::mat3{k_nan}, {0, 0, -200}); }), 0);
    const auto with_mesh = [&](const std::function<void(assets::Mesh&)>& change) {
        return demand_with([&](Textured& t) { change(t.processed.meshes[0].mesh); });
    };
    EXPECT_EQ(with_mesh([](assets::Mesh& m) { m.uv0.assign(4, {0.3f, 0.3f}); }), 0) << "one texel for all";
    EXPECT_EQ(with_mesh([](assets::Mesh& m) { m.uv0[2] = {k_nan, 0}; }), 0);
    EXPECT_EQ(with_mesh([](assets::Mesh& m) { m.uv0.clear(); }), 0);
    EXPECT_EQ(with_mesh([](assets::Mesh& m) { m.topology = assets::Topology::lines; }), 0);
    EXPECT_EQ(with_mesh([](assets::Mesh& m) {
                  m.uv0.assign({{0, 0}, {1e30f, 0}, {1e30f, 1e30f}, {0, 1e30f}});
              }),
              10);
}

TEST(TextureDemand, CountsNoTrianglesWithoutArea) {
    assets::Mesh mesh = square();
    mesh.indices.insert(mesh.indices.end(), {0, 0, 1});
    Textured textured{mesh};
    textured.place(glm::mat3{1.0f}, {0, 0, -200});
    EXPECT_GT(textured.demand(eye_of({640, 480})), 5);
}

TEST(TextureDemand, HeedsHowSamplersChooseLevels) {
    const auto demand_with = [](assets::Filter minify, assets::MipFilter mip) {
        Textured textured{square()};
        textured.place(glm::mat3{1.0f}, {0, 0, -50});
        textured.processed.textures[0].sampler.minify = minify;
        textured.processed.textures[0].sampler.mip = mip;
        return int{textured.demand(eye_of({640, 480}))};
    };
    const int usual = demand_with(assets::Filter::linear, assets::MipFilter::linear);
    EXPECT_EQ(demand_with(assets::Filter::linear, assets::MipFilter::none), 0) << "it knows no levels";
    EXPECT_EQ(demand_with(assets::Filter::linear, assets::MipFilter::nearest), usual);
    // OpenGL 4.5, 8.14.3: magnification goes on up to a level of ½ there, and would be linear.
    EXPECT_EQ(demand_with(assets::Filter::nearest, assets::MipFilter::nearest), usual - 1);
}

TEST(TextureDemand, IsNothingForWhatIsNotSeenUnlessItCutsOutShadows) {
    for (const assets::AlphaMode mode : {assets::AlphaMode::opaque, assets::AlphaMode::mask}) {
        Textured textured{square()};
        textured.processed.materials[0].alpha_mode = mode;
        textured.processed.materials[0].emissive_texture.texture = 0;
        textured.place(glm::mat3{1.0f}, {0, 60, -20});  // above the picture, between it and the sun
        assets::Environment noon;
        noon.direction_to_sun = {0, 1, 0};
        noon.sun_illuminance = glm::vec3{3};
        textured.world.set_resource(Sunlight{noon});
        EXPECT_EQ(textured.demand_of_frame(eye_of({640, 480})),
                  mode == assets::AlphaMode::mask ? 0 : k_not_demanded);
        EXPECT_EQ(textured.frame.counts.visible, 0u);
        EXPECT_EQ(textured.frame.counts.casters, 1u);
    }
}

TEST(TextureDemand, IsEmptyWithoutAScene) {
    Textured textured{square()};
    textured.place(glm::mat3{1.0f}, {0, 0, -20});
    build_frame(textured.world, eye_of({640, 480}), 1.0f, textured.frame);
    EXPECT_TRUE(textured.frame.texture_demand.empty());
}

TEST(PixelSteps, ReachNoFartherThanTheRayOfTheNextPixel) {
    Random random{3};
    double tightest = 0.0;
    for (int i = 0; i < 20000; ++i) {
        FrameView view;
        view.size_px = {640, 480};
        view.clip_from_view = reversed_perspective(random.uniform(0.2f, 2.2f), 4.0f / 3.0f, 0.05f);
        const double depth_m = std::exp2(random.uniform(-3, 10));
        // On the plane at depth 1: the point's place, and one pixel on from there, to whichever side.
        const glm::dvec2 tangent{1.0 / view.clip_from_view[0][0], 1.0 / view.clip_from_view[1][1]};
        const glm::dvec2 place = tangent * glm::dvec2{random.uniform(-1, 1), random.uniform(-1, 1)};
        const double turn = random.uniform(-4, 4);
        const glm::dvec2 next =
            place + 2.0 * tangent / glm::dvec2{view.size_px} * glm::dvec2{std::cos(turn), std::sin(turn)};
        const glm::dvec3 point = depth_m * glm::dvec3{place, -1.0};
        const glm::dvec3 ray = glm::normalize(glm::dvec3{next, -1.0});
        const double apart_m = glm::length(glm::cross(point, ray));
        const double step_m = PixelSteps{view}.least_m(glm::vec3{point}, glm::vec3{0.0f});
        ASSERT_LE(step_m, apart_m * 1.01) << "a hundredth for the curve of a tangent over a pixel";
        tightest = std::max(tightest, step_m / apart_m);
    }
    EXPECT_GT(tightest, 0.95) << "in the corners, a step outwards";
}

TEST(StretchOf, BoundsHowMuchLengthsGrow) {
    EXPECT_FLOAT_EQ(stretch_of(glm::mat3{3.0f}), 3.0f);
    Random random{2};
    for (int i = 0; i < 2000; ++i) {
        const glm::mat3 linear{random.point(3), random.point(3), random.point(3)};
        const glm::vec3 direction = glm::normalize(random.point(1));
        ASSERT_LE(glm::length(linear * direction), stretch_of(linear) * 1.0001f);
    }
    EXPECT_TRUE(std::isnan(stretch_of(glm::mat3{k_nan})));
}

}  // namespace
}  // namespace rambla::systems
