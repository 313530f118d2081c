#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <xmmintrin.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include "unit/assets/trace_support.h"

namespace rambla::assets::test {
namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

TEST(TracerLimits, ScenesWithoutTrianglesStopNothing) {
    TracedWorld nothing;
    EXPECT_FALSE(Tracer{nothing.scene}.first_hit({}));
    nothing.place(Mesh{});
    EXPECT_FALSE(Tracer{nothing.scene}.is_stopped({}));
    Mesh lines = facing_square();
    lines.topology = Topology::lines;
    nothing.place(std::move(lines), moved({0, 0, -1}));
    nothing.mesh(facing_square());  // of no instance
    EXPECT_FALSE(Tracer{nothing.scene}.is_stopped({.origin_m = {0.1, 0.2, 0}}));
}

TEST(TracerLimits, BrokenTrianglesAreNotThereAndOthersAre) {
    TracedWorld world;
    Mesh mesh = facing_square();
    mesh.normals.clear();
    mesh.uv0.clear();
    mesh.positions.insert(
        mesh.positions.end(),
        {{k_nan, 0, 0}, {0, 0, std::numeric_limits<float>::infinity()}, {0.5f, 0, 0}, {0.25f, 0, 0}});
    // Corners that are no numbers, a line, a point.
    mesh.indices.insert(mesh.indices.end(), {0, 1, 4, 0, 5, 1, 6, 7, 6, 0, 6, 7, 3, 3, 3});
    world.place(std::move(mesh), moved({0, 0, -2}));
    world.place(0, glm::mat4{k_nan});
    const Tracer tracer{world.scene};
    for (const double x : {-0.7, 0.1, 0.3, 0.8}) {
        const auto hit = tracer.first_hit({.origin_m = {x, 0.0, 0}, .faces = TraceFaces::all});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->distance_m, 2.0);
        EXPECT_LT(hit->triangle, 2u);
        EXPECT_EQ(hit->uv0, glm::dvec2{0.0});
    }
}

TEST(TracerLimits, RaysThatAreNoneHitNothing) {
    TracedWorld world;
    world.place(cube());
    const Tracer tracer{world.scene};
    for (const glm::dvec3 broken : {glm::dvec3{k_infinity, 0, 0}, glm::dvec3{0, std::nan(""), 0}}) {
        EXPECT_FALSE(tracer.first_hit({.origin_m = broken, .faces = TraceFaces::all}));
        EXPECT_FALSE(tracer.is_stopped({.direction = broken, .faces = TraceFaces::all}));
    }
    EXPECT_FALSE(tracer.is_stopped({.direction = glm::dvec3{0.0}, .faces = TraceFaces::all}));
}

TEST(TracerLimits, ReferencesToNothingAreRefused) {
    const auto refused = [](const TraceScene& scene, const std::string& part) {
        try {
            const Tracer tracer{scene};
        } catch (const std::invalid_argument& error) {
            return std::string{error.what()}.find(part) != std::string::npos;
        }
        return false;
    };
    Mesh mesh = facing_square();
    mesh.indices[4] = 4;
    TracedWorld index;
    index.place(std::move(mesh));
    EXPECT_TRUE(refused(index.scene, "mesh 0 has 4 positions, but an index refers to number 4"));
    TracedWorld odd;
    Mesh quad = facing_square();
    quad.indices.pop_back();
    odd.place(std::move(quad));
    EXPECT_TRUE(refused(odd.scene, "5 indices"));
    TracedWorld column;
    Mesh short_column = facing_square();
    short_column.uv1.resize(3);
    column.place(std::move(short_column));
    EXPECT_TRUE(refused(column.scene, "3 entries"));
    TracedWorld world;
    world.place(facing_square());
    world.scene.instances[0].mesh = 1;
    EXPECT_TRUE(refused(world.scene, "The mesh of traced instance 0 refers to number 1 of 1"));
    world.scene.instances[0] = {.mesh = 0, .material = 0};
    EXPECT_TRUE(refused(world.scene, "The material of traced instance 0"));
    world.material({.texture = 3});
    EXPECT_TRUE(refused(world.scene, "The texture of traced material 0"));
}

// Sizes from a millimetre to a thousand kilometres: rays that start on a surface neither meet it again nor
// miss what stands on it.
TEST(TracerLimits, RaysLeaveSurfacesOfAnyScale) {
    for (const float scale : {1e-3f, 1e-1f, 1.0f, 30.0f, 1e4f, 1e6f}) {
        TracedWorld world;
        world.place(ground_square(), scaled(glm::vec3{scale})).rays = k_rays_of_sight;
        world.place(globe(24), moved({0, 0.25f * scale, 0}) * scaled(glm::vec3{0.25f * scale})).rays =
            k_rays_of_light;
        const Tracer tracer{world.scene};
        int on_ground = 0, on_globe = 0;
        for (int i = 0; i < 900; ++i) {
            const glm::dvec3 above{scale * (i % 30 - 14.7) / 16.0, 3.0 * scale,
                                   scale * (i / 30 - 14.7) / 16.0};
            const TraceHit hit = ground_hit(tracer, above);
            // Up and away, however flat: what is convex does not meet itself. Of the globe's edges rays keep
            // a distance that single precision can tell.
            const double slope = hit.instance == 0 ? 1e-7 : 1e-2;
            for (const glm::dvec3 aside :
                 {glm::dvec3{1, 0, 0}, glm::dvec3{-1, 0, 0}, glm::dvec3{0.6, 0, 0.8}}) {
                const glm::dvec3 flat = aside - glm::dot(aside, hit.geometric_normal) * hit.geometric_normal;
                EXPECT_FALSE(tracer.is_stopped({.origin_m = offset_origin(hit),
                                                .direction = flat + slope * hit.geometric_normal,
                                                .faces = TraceFaces::all,
                                                .rays = world.scene.instances[hit.instance].rays}))
                    << scale << " " << i;
            }
            // Down is what it stands on, at once.
            const TraceRay down{
                .origin_m = offset_origin(hit), .direction = {0, -1, 0}, .faces = TraceFaces::all};
            const auto again = tracer.first_hit(down);
            ASSERT_TRUE(again) << scale << " " << i;
            EXPECT_LT(again->distance_m, 1e-9 * scale);
            (hit.instance == 0 ? on_ground : on_globe) += 1;
        }
        EXPECT_GT(on_ground, 500);
        EXPECT_GT(on_globe, 20);
    }
}

TEST(TracerLimits, ContactsCastShadowsAtAnyScale) {
    for (const float scale : {1e-3f, 1.0f, 1e3f, 1e6f}) {
        TracedWorld world;
        world.place(ground_square(), scaled(glm::vec3{scale}));
        world.place(cube(), moved({0, 0.5f * scale, 0}) * scaled(glm::vec3{0.5f * scale}));
        const Tracer tracer{world.scene};
        // A hair, a millionth of the scene, beside the cube's wall; the sun is beyond it, and behind.
        const TraceHit hit = ground_hit(tracer, {(0.5 + 1e-6) * scale, 2.0 * scale, 0.1 * scale});
        ASSERT_EQ(hit.instance, 0u);
        TraceRay ray{.origin_m = offset_origin(hit), .direction = {-1, 1, 0}, .faces = TraceFaces::all};
        EXPECT_TRUE(tracer.is_stopped(ray)) << scale;
        ray.faces = TraceFaces::lit;
        EXPECT_TRUE(tracer.is_stopped(ray)) << scale << ": the light sees the cube's far wall";
        ray.direction = {1, 1, 0};
        EXPECT_FALSE(tracer.is_stopped(ray)) << scale;
    }
}

TEST(TracerLimits, RaysAlongAPlaneNeitherHitItNorFail) {
    TracedWorld world;
    world.place(ground_square());
    world.place(facing_square(), moved({0, 0, -5}));
    const Tracer tracer{world.scene};
    for (const double y : {0.0, 1e-12, -1e-12}) {
        const auto hit = tracer.first_hit({.origin_m = {0.1, y, 3}, .faces = TraceFaces::all});
        ASSERT_TRUE(hit) << y;
        EXPECT_EQ(hit->instance, 1u);
        EXPECT_EQ(hit->distance_m, 8.0);
    }
    // A ten-millionth of a degree downwards: met where it goes through.
    const auto grazing =
        tracer.first_hit({.origin_m = {0.1, 2e-3, 2}, .direction = {0, -1e-3, -1}, .faces = TraceFaces::all});
    ASSERT_TRUE(grazing);
    EXPECT_EQ(grazing->instance, 0u);
    EXPECT_NEAR(grazing->position_m.z, 0.0, 1e-12);
}

// Nothing gets through between the triangles of a mesh: rays through its very edges and vertices.
TEST(TracerLimits, ClosedMeshesAreTight) {
    TracedWorld world;
    const Mesh ball = globe(20);
    const glm::mat4 map = moved({0.3f, -0.2f, -3.1f}) * glm::rotate(glm::mat4{1.0f}, 0.7f, {1, 2, 3});
    world.place(ball, map);
    const Tracer tracer{world.scene};
    const glm::dvec3 inside{map * glm::vec4{0.03f, 0.01f, -0.02f, 1}};
    for (std::size_t i = 0; i + 1 < ball.indices.size(); ++i) {
        const glm::dvec3 a{map * glm::vec4{ball.positions[ball.indices[i]], 1}};
        const glm::dvec3 b{map * glm::vec4{ball.positions[ball.indices[i + 1]], 1}};
        for (const double share : {0.0, 0.31, 0.5}) {
            const TraceRay ray{
                .origin_m = inside, .direction = glm::mix(a, b, share) - inside, .faces = TraceFaces::all};
            EXPECT_TRUE(tracer.is_stopped(ray)) << i << " " << share;
            const auto hit = tracer.first_hit(ray);
            ASSERT_TRUE(hit);
            EXPECT_NEAR(hit->t, 1.0, 0.02);
        }
    }
}

unsigned float_mode() {
    return _mm_getcsr() & 0xffc0u;  // all but the flags of what has happened
}

TEST(TracerLimits, FloatingPointModesStayAsTheyAre) {
    constexpr unsigned k_flush_to_zero = 0x8040, k_round_down = 0x2000;
    const unsigned before = _mm_getcsr();
    TracedWorld world;
    world.place(globe(150), moved({0, 0, -9}));  // large enough for Embree to share the work out
    std::vector<TraceRay> rays;
    for (int i = 0; i < 100; ++i)
        rays.push_back({.origin_m = {0.007 * i, 0.2 - 0.003 * i, 0}, .direction = {-0.0005 * i, 0, -1}});
    std::vector<double> usual;
    for (const unsigned extra : {0u, k_flush_to_zero, k_round_down}) {
        std::vector<double> found;
        found.reserve(rays.size());
        _mm_setcsr(before | extra);
        const unsigned mine = float_mode();
        bool kept = true;
        {
            const Tracer tracer{world.scene};
            kept = kept && float_mode() == mine;
            for (const TraceRay& ray : rays) {
                const auto hit = tracer.first_hit(ray);
                kept = kept && hit && float_mode() == mine && tracer.is_stopped(ray) && float_mode() == mine;
                found.push_back(hit ? hit->t : 0.0);
            }
        }
        kept = kept && float_mode() == mine;
        _mm_setcsr(before);
        EXPECT_TRUE(kept) << extra;
        if (usual.empty()) usual = found;
        EXPECT_EQ(found, usual) << "nor does the caller's mode change results";
    }
}

TEST(TracerLimits, WorkersOfTbbKeepTheirModes) {
    TracedWorld world;
    world.place(globe(150), moved({0, 0, -9}));
    const Tracer tracer{world.scene};
    static_cast<void>(trace_picture(tracer, pinhole({64, 64})));
    std::atomic<int> others{0};
    const unsigned usual = float_mode();
    tbb::parallel_for(0, 64, [&](int) {
        if (float_mode() != usual) ++others;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});  // so that all threads take part
    });
    EXPECT_EQ(others, 0);
    volatile float smallest = std::numeric_limits<float>::min();
    EXPECT_GT(smallest / 2.0f, 0.0f) << "there are denormal numbers";
}

TEST(TracerLimits, MemoryIsCounted) {
    TracedWorld small, large;
    small.place(globe(8));
    large.place(globe(80));
    const Tracer few{small.scene}, many{large.scene};
    EXPECT_GT(few.memory_bytes(), 1000u);
    EXPECT_GT(many.memory_bytes(), few.memory_bytes() + 36u * 2 * 160 * 80);
    for (int i = 1; i < 20; ++i)
        large.place(0, moved({3.0f * static_cast<float>(i), 0, 0}) * scaled({1, 5, 0.5f}));
    EXPECT_LT(Tracer{large.scene}.memory_bytes(), 1.2 * static_cast<double>(many.memory_bytes()))
        << "instances share their mesh";
}

}  // namespace
}  // namespace rambla::assets::test
