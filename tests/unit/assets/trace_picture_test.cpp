#include "assets/trace/picture.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <cstring>

#include "unit/assets/trace_support.h"

namespace rambla::assets::test {
namespace {

/// A picture of one row that shows places of the ground, seen from straight above.
HitPicture row_of(const Tracer& tracer, const std::vector<glm::dvec3>& places) {
    HitPicture picture{{static_cast<std::uint32_t>(places.size()), 1}, {}};
    for (const glm::dvec3& place : places)
        picture.hits.push_back(ground_hit(tracer, place));
    return picture;
}

TEST(TraceCamera, PixelsSeeWhatProjectsOntoThem) {
    TraceCamera camera = pinhole({40, 30}, 0.9f, 0.1f);
    camera.clip_from_view[2][0] = 0.013f;  // a shifted pixel grid, as temporal anti-aliasing has it
    camera.clip_from_view[2][1] = -0.021f;
    camera.view_from_world = glm::rotate(glm::mat4{1.0f}, 0.6f, {0.3f, 0.9f, -0.1f}) * moved({3, -2, 5});
    for (const bool orthographic : {false, true}) {
        if (orthographic) {
            camera.clip_from_view = scaled({0.2f, 0.3f, 0.01f});
            camera.clip_from_view[3] = {0.05f, -0.07f, 0.9f, 1};
        }
        camera.orthographic = orthographic;
        const CameraRays rays{camera};
        const glm::dmat4 clip_from_world =
            glm::dmat4{camera.clip_from_view} * glm::dmat4{camera.view_from_world};
        const TraceRay ray = rays.through_pixel(31, 4);
        for (const double t : {ray.t_min, 7.0}) {
            const glm::dvec4 clip = clip_from_world * glm::dvec4{ray.origin_m + t * ray.direction, 1.0};
            EXPECT_NEAR(20.0 * (clip.x / clip.w + 1.0), 31.5, 1e-5);  // the inverse of a float rotation
            EXPECT_NEAR(15.0 * (1.0 - clip.y / clip.w), 4.5, 1e-5);
            EXPECT_TRUE(t != ray.t_min || std::abs(clip.z / clip.w - 1.0) < 1e-6) << "the near plane";
        }
        if (orthographic) {
            const glm::dvec4 end =
                clip_from_world * glm::dvec4{ray.origin_m + ray.t_max * ray.direction, 1.0};
            EXPECT_NEAR(end.z, 0.0, 1e-6);
        } else {
            EXPECT_TRUE(std::isinf(ray.t_max));
        }
        const TraceRay right = rays.through_pixel(32, 4), below = rays.through_pixel(31, 5);
        EXPECT_LT(glm::distance(right.direction - ray.direction, rays.spread().direction_right), 1e-12);
        EXPECT_LT(glm::distance(below.direction - ray.direction, rays.spread().direction_below), 1e-12);
        EXPECT_LT(glm::distance(right.origin_m - ray.origin_m, rays.spread().origin_right_m), 1e-12);
        EXPECT_LT(glm::distance(below.origin_m - ray.origin_m, rays.spread().origin_below_m), 1e-12);
    }
}

TEST(TracePicture, RowsBeginAtTheTopAndNearPlanesCut) {
    TracedWorld world;
    world.place(facing_square(), moved({-2, 2, -4}));     // upper left
    world.place(facing_square(), moved({0, 0, -0.04f}));  // nearer than the near plane
    world.place(facing_square(), moved({2, -2, -4})).rays = k_rays_of_light;
    const Tracer tracer{world.scene};
    const HitPicture picture = trace_picture(tracer, pinhole({64, 64}, 1.5f));
    std::size_t seen = 0;
    for (std::size_t i = 0; i < picture.hits.size(); ++i) {
        if (!picture.hits[i].exists()) continue;
        ++seen;
        EXPECT_EQ(picture.hits[i].object, 100u);
        EXPECT_NEAR(picture.hits[i].t, 4.0, 1e-6) << "t is depth";
        EXPECT_LT(i % 64, 32u);
        EXPECT_LT(i / 64, 32u);
    }
    const double side = 32.0 / std::tan(0.75) / 4.0;  // pixels a metre there
    EXPECT_NEAR(static_cast<double>(seen), 4.0 * side * side, 4.0 * side);
}

TEST(TracePicture, TheSunShinesBesideAShadow) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{100}));
    world.place(ground_square(), moved({0, 2, 0}));  // seen from above, and by the sun
    const Tracer tracer{world.scene};
    const HitPicture seen =
        row_of(tracer, {{0.5, 1, 0}, {2.5, 1, 0}, {3.5, 1, 0}, {0.5, 3, 0}, {-1.5, 1, 0.5}});
    EXPECT_EQ(trace_sun(tracer, seen, {-2, 2, 0}), (std::vector<float>{1, 0, 1, 1, 1}))
        << "the roof's shadow lies 2 m beside it";
    EXPECT_EQ(trace_sun(tracer, seen, {0, -1, 0}), (std::vector<float>{0, 0, 0, 0, 0})) << "from below";
    HitPicture sky = seen;
    sky.hits[1] = {};
    EXPECT_EQ(trace_sun(tracer, sky, {-2, 2, 0})[1], 1.0f);
}

TEST(TracePicture, ShadowsAreThoseOfTheFacesThatTheSunSees) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{100}));
    const glm::mat4 upside_down = moved({0, 2, 0}) * glm::rotate(glm::mat4{1.0f}, 3.14159265f, {1, 0, 0});
    world.place(ground_square(), upside_down).rays = k_rays_of_light;
    TracedWorld double_sided = world;
    double_sided.scene.instances[1].material = double_sided.material({.double_sided = true});
    TracedWorld unlit = double_sided;
    unlit.scene.instances[1].rays = k_rays_of_sight;
    const auto sun_on_ground = [](const TracedWorld& w) {
        const Tracer tracer{w.scene};
        return trace_sun(tracer, row_of(tracer, {{0.2, 1, 0.1}}), {0, 1, 0})[0];
    };
    EXPECT_EQ(sun_on_ground(world), 1.0f);
    EXPECT_EQ(sun_on_ground(double_sided), 0.0f);
    EXPECT_EQ(sun_on_ground(unlit), 1.0f);
}

// Behind the edge of a half plane: the light's part on one side of the line through the edge and the point.
TEST(TracePicture, PenumbrasOfSquaresAndDiscsAreThoseOfGeometry) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{1000}));
    world.place(ground_square(), moved({-1000, 1, 0}) * scaled(glm::vec3{1000}),
                world.material({.double_sided = true}));
    const Tracer tracer{world.scene};
    std::vector<glm::dvec3> places;
    for (int i = 0; i <= 20; ++i)
        places.emplace_back(-0.6 + 0.06 * i, 0.5, 0.3);
    const HitPicture seen = row_of(tracer, places);
    const SampleCount count{.samples = 1024, .seed = 5};
    const AreaLight square{.centre = {0, 3, 0}, .half_u = {0.5, 0, 0}, .half_v = {0, 0, 0.5}};
    AreaLight disc = square;
    disc.disc = true;
    const std::vector<float> square_shares = trace_area_light(tracer, seen, square, count);
    const std::vector<float> disc_shares = trace_area_light(tracer, seen, disc, count);
    for (std::size_t i = 0; i < places.size(); ++i) {
        // The edge x = 0 at a third of the way: it hides what lies left of x' = −2·x at the light's height.
        const double edge = std::clamp(-2.0 * places[i].x / 0.5, -1.0, 1.0);
        EXPECT_NEAR(square_shares[i], 0.5 * (1.0 - edge), 0.012) << i;  // 32 strata: ±1/32 in the worst row
        EXPECT_NEAR(disc_shares[i], (std::acos(edge) - edge * std::sqrt(1.0 - edge * edge)) / k_pi, 0.012)
            << i;
    }
}

TEST(TracePicture, TheSunIsADistantDisc) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{1000}));
    world.place(ground_square(), moved({-1000, 10, 0}) * scaled(glm::vec3{1000}),
                world.material({.double_sided = true}));
    const Tracer tracer{world.scene};
    const double radius = std::tan(0.27 * k_pi / 180.0);
    std::vector<glm::dvec3> places;
    for (int i = -6; i <= 6; ++i)
        places.emplace_back(10.0 * radius * i / 5.0, 1, 0.3);
    const AreaLight sun{.disc = true,
                        .distant = true,
                        .centre = {0, 1, 0},
                        .half_u = {radius, 0, 0},
                        .half_v = {0, 0, radius}};
    const std::vector<float> shares = trace_area_light(tracer, row_of(tracer, places), sun, {.samples = 400});
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double edge = std::clamp(-(static_cast<double>(i) - 6.0) / 5.0, -1.0, 1.0);
        EXPECT_NEAR(shares[i], (std::acos(edge) - edge * std::sqrt(1.0 - edge * edge)) / k_pi, 0.02) << i;
    }
    EXPECT_EQ(shares.front(), 0.0f);
    EXPECT_EQ(shares.back(), 1.0f);
}

TEST(TracePicture, LightsDoNotReachBeyondThemselves) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{100}));
    world.place(ground_square(), moved({0, 4, 0}) * scaled(glm::vec3{50}),
                world.material({.double_sided = true}));
    const Tracer tracer{world.scene};
    const AreaLight lamp{.centre = {0, 3, 0}, .half_u = {0.1, 0, 0}, .half_v = {0, 0, 0.1}};
    EXPECT_EQ(trace_area_light(tracer, row_of(tracer, {{1, 1, 1}}), lamp, {.samples = 16})[0], 1.0f);
}

TEST(TracePicture, AmbientOcclusionOfAnOpenPlaneIsOne) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{100}));
    const Tracer tracer{world.scene};
    const auto shares =
        trace_ambient(tracer, row_of(tracer, {{0, 1, 0}, {50, 1, -3}, {0.01, 1, 99.9}}), {.samples = 256});
    EXPECT_EQ(shares, (std::vector<float>{1, 1, 1}));
}

// Beside an infinite wall at the distance d, with radius r: a direction meets it if its part towards the wall
// is at least d/r. Cosine-weighted directions are points of the unit disc: a segment of it is hidden.
TEST(TracePicture, AmbientOcclusionBesideAWallIsThatOfADiscsSegment) {
    TracedWorld world;
    world.place(ground_square(), scaled(glm::vec3{1000}));
    const glm::mat4 upright = glm::rotate(glm::mat4{1.0f}, -1.57079633f, {0, 0, 1});
    world.place(ground_square(), moved({0, 0, 0}) * upright * scaled(glm::vec3{1000}));
    const Tracer tracer{world.scene};
    const HitPicture seen =
        row_of(tracer, {{1e-3, 1, 0}, {0.25, 1, 0}, {0.5, 1, 0}, {0.9, 1, 0}, {1.5, 1, 0}});
    const std::vector<float> shares = trace_ambient(tracer, seen, {.samples = 4096, .seed = 3}, 1.0);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double c = std::min(seen.hits[i].position_m.x, 1.0);
        EXPECT_NEAR(shares[i], 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / k_pi, 0.006)
            << i;  // 64 strata
    }
    const double in_the_corner = trace_ambient(tracer, row_of(tracer, {{1e-3, 1, 0}}), {.samples = 4096})[0];
    EXPECT_NEAR(in_the_corner, 0.5, 0.006) << "half of the hemisphere is wall";
}

TEST(TracePicture, MirrorsShowWhatIsBehindThem) {
    TracedWorld world;
    world.place(facing_square(), moved({0, 0, -5}) * scaled(glm::vec3{2}));
    world.place(cube(), moved({0.5f, 0.2f, 4}));  // behind the eye
    const Tracer tracer{world.scene};
    const TraceCamera camera = pinhole({33, 33}, 0.6f);
    const HitPicture seen = trace_picture(tracer, camera);
    const HitPicture mirrored = trace_mirrors(tracer, camera, seen);
    const CameraRays rays{camera};
    std::size_t cubes = 0;
    for (std::uint32_t i = 0; i < 33 * 33; ++i) {
        // The mirror image: the cube's near face lies at z = −13.
        const glm::dvec3 direction = rays.through_pixel(i % 33, i / 33).direction;
        const glm::dvec3 image = 13.0 * direction;
        const bool on_cube = std::abs(image.x - 0.5) < 1.0 && std::abs(image.y - 0.2) < 1.0;
        ASSERT_EQ(mirrored.hits[i].exists(), on_cube) << i;
        if (!on_cube) continue;
        ++cubes;
        EXPECT_EQ(mirrored.hits[i].object, 101u);
        EXPECT_NEAR(mirrored.hits[i].distance_m, 8.0 * glm::length(direction), 1e-7);  // offset: 2⁻³² · 5 m
        EXPECT_NEAR(mirrored.hits[i].position_m.x, image.x, 1e-7);
    }
    EXPECT_GT(cubes, 20u);
}

TEST(TracePicture, SmoothNormalsTurnMirrorsButNotIntoTheSurface) {
    TracedWorld world;
    Mesh bent = facing_square();
    bent.normals.assign(4, glm::normalize(glm::vec3{1.2f, 0, 1}));
    world.place(std::move(bent), moved({0, 0, -2}));
    world.place(facing_square(), moved({5, 0, -2}) * glm::rotate(glm::mat4{1.0f}, -1.57079633f, {0, 1, 0}));
    const Tracer tracer{world.scene};
    TraceCamera camera = pinhole({1, 1});
    EXPECT_FALSE(trace_mirrors(tracer, camera, trace_picture(tracer, camera)).hits[0].exists())
        << "that would go into the surface: the geometric normal sends it back, to nothing";
    world.meshes.front().normals.assign(4, glm::normalize(glm::vec3{0.95f, 0, 1}));
    EXPECT_EQ(trace_mirrors(tracer, camera, trace_picture(tracer, camera)).hits[0].object, 101u);
}

bool equal(const HitPicture& a, const HitPicture& b) {
    if (a.size_px != b.size_px) return false;
    for (std::size_t i = 0; i < a.hits.size(); ++i) {
        const TraceHit &x = a.hits[i], &y = b.hits[i];
        const bool same = x.object == y.object && x.instance == y.instance && x.triangle == y.triangle &&
                          x.front == y.front && x.barycentric == y.barycentric && x.t == y.t &&
                          x.distance_m == y.distance_m && x.position_m == y.position_m &&
                          x.geometric_normal == y.geometric_normal && x.shading_normal == y.shading_normal &&
                          x.uv0 == y.uv0 && x.uv1 == y.uv1 && x.offset_m == y.offset_m;
        if (!same) return false;
    }
    return true;
}

TEST(TracePicture, PicturesAreTheSameForAnyNumberOfThreads) {
    TracedWorld world;
    const std::uint32_t ball = world.mesh(globe(60));
    world.place(ground_square(), moved({0, -1, -8}) * scaled(glm::vec3{20}));
    for (int i = 0; i < 60; ++i) {
        const auto f = static_cast<float>(i);
        world.place(ball, moved({3.0f * std::sin(f), 0.1f * f - 1.0f, -8.0f + 3.0f * std::cos(2.0f * f)}) *
                              scaled(glm::vec3{0.6f, 0.9f, -0.5f}));
    }
    const TraceCamera camera = pinhole({80, 60});
    struct All {
        HitPicture seen, mirrored;
        std::vector<float> sun, area, ambient;
    };
    const auto trace = [&](std::uint64_t seed) {
        const Tracer tracer{world.scene};
        All all{.seen = trace_picture(tracer, camera), .mirrored = {}, .sun = {}, .area = {}, .ambient = {}};
        all.mirrored = trace_mirrors(tracer, camera, all.seen);
        all.sun = trace_sun(tracer, all.seen, {0.3, 1, 0.2});
        all.area = trace_area_light(
            tracer, all.seen, {.centre = {0, 4, 0}, .half_u = {1, 0, 0}, .half_v = {0, 0, 1}}, {16, seed});
        all.ambient = trace_ambient(tracer, all.seen, {16, seed}, 2.0);
        return all;
    };
    const tbb::global_control more{tbb::global_control::max_allowed_parallelism, 7};
    All one, seven;
    tbb::task_arena{1}.execute([&] { one = trace(1); });
    tbb::task_arena{7}.execute([&] { seven = trace(1); });
    EXPECT_TRUE(equal(one.seen, seven.seen));
    EXPECT_TRUE(equal(one.mirrored, seven.mirrored));
    EXPECT_EQ(one.sun, seven.sun);
    EXPECT_EQ(one.area, seven.area);
    EXPECT_EQ(one.ambient, seven.ambient);
    const All other = trace(2);
    EXPECT_NE(one.area, other.area) << "the seed counts";
    EXPECT_NE(one.ambient, other.ambient);
    std::size_t mirrored = 0;
    for (const TraceHit& hit : one.mirrored.hits)
        mirrored += hit.exists() ? 1u : 0u;
    EXPECT_GT(mirrored, 500u);
}

}  // namespace
}  // namespace rambla::assets::test
