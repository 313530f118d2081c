// Motion vectors against where points of a moving plane are seen, found in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "render/motion_bench.h"

namespace {

using namespace rambla;
using tests::matte;
using tests::MotionBench;
using tests::Stage;

/// Where a plane's point (x, y) lies in the world.
struct Plane {
    glm::dvec3 origin;
    glm::dvec3 along_x;
    glm::dvec3 along_y;
};

Plane plane_of(const glm::mat4& world_from_local) {
    return {glm::dvec3{world_from_local[3]}, glm::dvec3{world_from_local[0]},
            glm::dvec3{world_from_local[1]}};
}

struct Camera {
    glm::dvec3 eye_m;
    glm::dmat4 clip_from_eye;
};

Camera camera_of(const Stage& stage) {
    return {glm::dvec3{stage.eye},
            glm::dmat4{stage.frame.view.clip_from_view} * glm::dmat4{stage.frame.view.view_from_world}};
}

glm::dvec2 pixel_of(const Camera& camera, glm::dvec3 world_m, glm::dvec2 size_px) {
    const glm::dvec4 clip = camera.clip_from_eye * glm::dvec4{world_m - camera.eye_m, 1.0};
    return (0.5 * glm::dvec2{clip} / clip.w + 0.5) * size_px;
}

/// The plane's point that is seen at a place of the picture: where x of the clip space less w times the
/// place's vanishes, and y's likewise, which are two linear equations.
glm::dvec2 point_at(const Camera& camera, const Plane& plane, glm::dvec2 place_px, glm::dvec2 size_px) {
    const glm::dvec2 ndc = 2.0 * place_px / size_px - 1.0;
    const glm::dvec4 o = camera.clip_from_eye * glm::dvec4{plane.origin - camera.eye_m, 1.0};
    const glm::dvec4 x = camera.clip_from_eye * glm::dvec4{plane.along_x, 0.0};
    const glm::dvec4 y = camera.clip_from_eye * glm::dvec4{plane.along_y, 0.0};
    const glm::dmat2 m{glm::dvec2{x} - x.w * ndc, glm::dvec2{y} - y.w * ndc};
    return glm::inverse(m) * (o.w * ndc - glm::dvec2{o});
}

/// A world with one square, as it was and as it is.
struct Move {
    Stage stage;
    std::uint32_t square = 0;
    Plane then;
    Plane now;
    std::function<void(Stage&)> go = [](Stage&) {
    };

    Move() {
        stage.frame.view.size_px = {160, 120};
        look({0.3f, 0.2f, 4.0f}, {0, 0, 0});
        square = stage.square();
        stage.material(matte());
    }
    void look(glm::vec3 from, glm::vec3 to) {
        stage.look(from, to);
        stage.frame.view.eye_local_m = from;
    }
    /// Far from the world's origin; the stage's own places count from there.
    void start_at(glm::ivec3 cell) { stage.frame.view.eye_cell = cell; }
};

constexpr double k_most_error_px = 1.0 / 16.0;

/// The largest error in the pixels that surely show the square, after it and the camera have gone on.
double largest_error_px(Move& move, int& pixels) {
    MotionBench bench{move.stage};
    EXPECT_FALSE(bench.draw(move.stage).has_value()) << "nothing has a past in the first frame";
    const Camera was = camera_of(move.stage);
    move.go(move.stage);
    const auto vectors = bench.draw(move.stage);
    const Camera is = camera_of(move.stage);
    if (!vectors) return std::nan("");
    const glm::uvec2 size = move.stage.frame.view.size_px;
    const glm::dvec2 jitter{bench.temporal().jitter_px};
    double worst = 0.0;
    pixels = 0;
    for (std::uint32_t y = 0; y < size.y; ++y) {
        for (std::uint32_t x = 0; x < size.x; ++x) {
            const glm::dvec2 place = glm::dvec2{x, y} + 0.5 - jitter;
            const glm::dvec2 point = point_at(is, move.now, place, glm::dvec2{size});
            if (std::fabs(point.x) > 0.97 || std::fabs(point.y) > 0.97) continue;
            const glm::dvec3 before =
                move.then.origin + point.x * move.then.along_x + point.y * move.then.along_y;
            const glm::dvec2 expected = place - pixel_of(was, before, glm::dvec2{size});
            const glm::dvec2 found{(*vectors)[std::size_t{y} * size.x + x]};
            worst = std::max(worst, glm::distance(found, expected));
            ++pixels;
        }
    }
    return worst;
}

void expect_exact(Move& move) {
    int pixels = 0;
    const double error = largest_error_px(move, pixels);
    EXPECT_LE(error, k_most_error_px);
    EXPECT_GT(pixels, 1000) << "the test would see nothing";
    testing::Test::RecordProperty("largest_error_px", std::to_string(error));
}

glm::mat4 turned(float angle_rad, glm::vec3 axis) {
    return glm::rotate(glm::mat4{1.0f}, angle_rad, glm::normalize(axis));
}
glm::mat4 moved(glm::vec3 by) {
    return glm::translate(glm::mat4{1.0f}, by);
}

void place_and_move(Move& move, const glm::mat4& then, const glm::mat4& now) {
    move.stage.place(move.square, 0, then);
    move.then = plane_of(then);
    move.now = plane_of(now);
    move.go = [now](Stage& stage) {
        stage.things[0].world_from_local = now;
    };
}

TEST(MotionVectors, OfAThingThatSlides) {
    Move move;
    place_and_move(move, moved({-0.3f, 0.1f, 0.0f}), moved({0.25f, -0.1f, 0.4f}));
    expect_exact(move);
}

TEST(MotionVectors, OfAThingThatTurnsAndGrows) {
    Move move;
    place_and_move(move, turned(0.4f, {1, 1, 0}),
                   turned(0.1f, {0, 0.4f, 1}) * glm::scale(glm::mat4{1.0f}, glm::vec3{1.2f, 0.9f, 1.0f}));
    expect_exact(move);
}

/// @param move  must outlive what it does
void slide_while_the_camera_moves(Move& move) {
    place_and_move(move, moved({-0.3f, 0.1f, 0.0f}), moved({0.1f, -0.1f, 0.4f}));
    const auto slide = move.go;
    move.go = [&move, slide](Stage& stage) {
        slide(stage);
        move.look({0.6f, 0.1f, 3.7f}, {0.1f, 0.05f, 0});
    };
}

TEST(MotionVectors, OfAThingThatSlidesWhileTheCameraMovesAndTurns) {
    Move move;
    slide_while_the_camera_moves(move);
    expect_exact(move);
}

TEST(MotionVectors, AThousandKilometresAway) {
    Move move;
    move.start_at({3906250, -12, -3906250});
    slide_while_the_camera_moves(move);
    expect_exact(move);
}

TEST(MotionVectors, AcrossTheBorderOfTwoCells) {
    Move move;
    place_and_move(move, moved({-0.3f, 0.1f, 0.0f}), moved({0.1f, -0.1f, 0.4f}));
    const auto slide = move.go;
    move.go = [&move, slide](Stage& stage) {
        slide(stage);
        move.look({0.6f, 0.1f, 3.7f}, {0.1f, 0.05f, 0});
        stage.frame.view.eye_cell.x -= 1;
        stage.frame.view.eye_local_m.x += 256.0f;
    };
    expect_exact(move);
}

/// The left side of the square hangs on joint 0, its right side on joint 1: a point (x, y) follows their
/// mean.
std::uint32_t skinned_square(Stage& stage) {
    assets::Mesh m = stage.scene.meshes[0];
    m.joints.assign(4, {0, 1, 0, 0});
    m.weights = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}};
    return stage.mesh(std::move(m));
}

/// Of two joints that both only move.
Plane hung_between(glm::dvec3 left, glm::dvec3 right) {
    return {0.5 * (left + right), glm::dvec3{1, 0, 0} + 0.5 * (right - left), {0, 1, 0}};
}

TEST(MotionVectors, OfAThingWithJoints) {
    Move move;
    move.stage.place(skinned_square(move.stage), 0);
    move.stage.things[0].world_from_mesh = {moved({0, 0.1f, 0}), moved({0.2f, 0, 0})};
    move.then = hung_between({0, 0.1f, 0}, {0.2f, 0, 0});
    move.now = hung_between({0, 0.1f, 0}, {0.4f, 0.3f, -0.2f});
    move.go = [](Stage& stage) {
        stage.things[0].world_from_mesh[1] = moved({0.4f, 0.3f, -0.2f});
    };
    expect_exact(move);
}

TEST(MotionVectors, OfAThingWithMorphTargets) {
    Move move;
    assets::Mesh m = move.stage.scene.meshes[0];
    m.morphs.resize(2);
    // Both are linear in the place on the square: the first one lifts its right side, the second one widens
    // it.
    m.morphs[0].positions = {{0, 0, 0}, {0, 0.5f, 0.2f}, {0, 0.5f, 0.2f}, {0, 0, 0}};
    m.morphs[1].positions = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    move.stage.place(move.stage.mesh(std::move(m)), 0);
    move.stage.things[0].morphs = {{0, 0.25f}};
    const auto plane = [](double lifted, double widened) {
        const glm::dvec3 up{0, 0.5 * lifted, 0.2 * lifted};
        return Plane{0.5 * up, glm::dvec3{1 + widened, 0, 0} + 0.5 * up, {0, 1, 0}};
    };
    move.then = plane(0.25, 0.0);
    move.now = plane(0.75, 0.125);
    move.go = [](Stage& stage) {
        stage.things[0].morphs = {{0, 0.75f}, {1, 0.125f}};
    };
    expect_exact(move);
}

TEST(MotionVectors, OfAThingWithMorphTargetsThatHangsOnJoints) {
    Move move;
    assets::Mesh m = move.stage.scene.meshes[skinned_square(move.stage)];
    m.morphs.resize(1);
    m.morphs[0].positions = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    move.stage.place(move.stage.mesh(std::move(m)), 0);
    move.stage.things[0].world_from_mesh = {moved({0, 0, 0}), moved({0, 0, 0})};
    move.stage.things[0].morphs = {{0, 0.1f}};
    move.then = {{0, 0, 0}, {1.1, 0, 0}, {0, 1, 0}};
    move.now = hung_between({0, 0, 0}, {0, 0.3f, 0});
    move.now.along_x.x = 1.2;
    move.go = [](Stage& stage) {
        stage.things[0].world_from_mesh[1] = moved({0, 0.3f, 0});
        stage.things[0].morphs = {{0, 0.2f}};
    };
    expect_exact(move);
}

TEST(MotionVectors, AreNotMadeOfWhatRestsWhileTheCameraMoves) {
    Move move;
    move.stage.place(move.square, 0, turned(0.3f, {1, 2, 0}) * moved({0.1f, 0.7f, 0.3f}));
    MotionBench bench{move.stage};
    for (int i = 0; i < 20; ++i) {
        const float t = 0.1f * static_cast<float>(i);
        move.look({t, 0.5f * t, 4.0f - t}, {0.3f * t, 0, 0});
        EXPECT_FALSE(bench.draw(move.stage).has_value()) << i;
        EXPECT_EQ(bench.temporal().has_past, i > 0) << "no cut";
    }
}

/// Beside a thing that moves, those that rest keep the value that the target is cleared to.
TEST(MotionVectors, AreDrawnForWhatMovesAlone) {
    Move move;
    move.stage.place(move.square, 0, moved({-1.5f, 0, 0}));
    move.stage.place(move.square, 0, moved({1.5f, 0, 0}));
    MotionBench bench{move.stage};
    static_cast<void>(bench.draw(move.stage));
    move.stage.things[1].world_from_local = moved({1.6f, 0, 0});
    const auto vectors = bench.draw(move.stage);
    ASSERT_TRUE(vectors.has_value());
    const auto at = [&](glm::vec3 world) {
        const glm::vec2 pixel = move.stage.pixel_of(world);
        return (*vectors)[(119u - static_cast<std::uint32_t>(pixel.y)) * 160u +
                          static_cast<std::uint32_t>(pixel.x)];
    };
    EXPECT_GT(at({-1.5f, 0, 0}).x, 50000.0f);
    EXPECT_NEAR(at({1.5f, 0, 0}).x, 2.6f, 0.3f) << "0.1 m, 4 m before an eye of 60 degrees and 120 rows";
}

}  // namespace
