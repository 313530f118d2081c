#include "render/jitter.h"

#include <gtest/gtest.h>

#include <array>

#include "render/temporal_history.h"

namespace rambla::render {
namespace {

systems::FrameView perspective() {
    systems::FrameView view;
    view.size_px = {960, 540};
    glm::mat4& p = view.clip_from_view;
    p = glm::mat4{0.0f};
    p[0][0] = 1.1f;
    p[1][1] = 1.9f;
    p[2][3] = -1.0f;
    p[3][2] = 0.05f;
    return view;
}

systems::FrameView parallel() {
    systems::FrameView view;
    view.size_px = {960, 540};
    view.orthographic = true;
    glm::mat4& p = view.clip_from_view;
    p[0][0] = 0.1f;
    p[1][1] = 0.2f;
    p[2][2] = 0.01f;
    p[3][2] = 1.0f;
    return view;
}

glm::dvec2 pixel_of(const systems::FrameView& view, glm::dvec3 point_m) {
    const glm::dvec4 clip = glm::dmat4{view.clip_from_view} * glm::dvec4{point_m, 1.0};
    return (0.5 * glm::dvec2{clip} / clip.w + 0.5) * glm::dvec2{view.size_px};
}

/// So that a still picture is where it would be without: two millionths of a pixel are the rounding of eight
/// floats.
TEST(Jitter, HasThePixelsMiddleForItsMean) {
    glm::dvec2 sum{0.0};
    for (std::uint32_t i = 0; i < k_jitter_length; ++i) {
        const glm::vec2 offset = jitter_px(i);
        EXPECT_LT(std::max(std::abs(offset.x), std::abs(offset.y)), 0.5f);
        EXPECT_EQ(offset, jitter_px(i + k_jitter_length));
        sum += glm::dvec2{offset};
    }
    EXPECT_LT(glm::length(sum), 2e-6);
}

/// Of eight columns and of nine rows of a pixel, no two samples share one.
TEST(Jitter, SpreadsOverThePixel) {
    std::array<int, 8> columns{};
    std::array<int, 9> rows{};
    const glm::vec2 first = jitter_px(0) - glm::vec2{1.0f / 2.0f, 1.0f / 3.0f};  // by which all are shifted
    for (std::uint32_t i = 0; i < k_jitter_length; ++i) {
        const glm::vec2 place = jitter_px(i) - first;
        ++columns[static_cast<std::size_t>(place.x * 8.0f + 0.01f) % 8];
        ++rows[static_cast<std::size_t>(place.y * 9.0f + 0.01f) % 9];
    }
    for (const int count : columns)
        EXPECT_EQ(count, 1);
    for (const int count : rows)
        EXPECT_LE(count, 1);
}

TEST(Jitter, MovesThePictureByAsMuchAtEveryDepth) {
    const glm::vec2 offset{0.3f, -0.4f};
    for (const systems::FrameView& view : {perspective(), parallel()}) {
        for (const double z : {-0.2, -3.0, -80.0}) {
            const glm::dvec3 point{0.4, -0.3, z};
            const glm::dvec2 moved = pixel_of(shifted(view, offset), point) - pixel_of(view, point);
            EXPECT_LT(glm::distance(moved, glm::dvec2{offset}), 1e-3)
                << z << ": rounding of floats near 1, times 480 pixels";
        }
    }
}

TEST(Jitter, NeverLeadsOutOfTheWidenedView) {
    for (const systems::FrameView& view : {perspective(), parallel()}) {
        const glm::dvec3 point{0.4, -0.3, -3.0};
        const glm::dvec2 size{view.size_px};
        const glm::dvec2 from_middle = pixel_of(view, point) - 0.5 * size;
        const glm::dvec2 wide = pixel_of(widened(view, 0.5f), point) - 0.5 * size;
        EXPECT_LT(glm::distance(wide, from_middle * size / (size + 1.0)), 1e-3);
    }
}

struct Moment {
    systems::Frame frame;
    Moment() {
        frame.view = perspective();
        frame.time_s = 10.0;
    }
};

/// Whether a Frame that differs from the one before it in this still has a past.
template <class Change>
bool has_past_after(Change&& change, bool continues = true, float exposure = 1.0f) {
    TemporalHistory history;
    Moment moment;
    static_cast<void>(history.follow(moment.frame, 1.0f, false));
    EXPECT_TRUE(history.follow(moment.frame, 1.0f, true).has_past);
    change(moment.frame);
    return history.follow(moment.frame, exposure, continues).has_past;
}

TEST(TemporalHistory, GoesOnOverWhatAPictureCanBeFoundAgainAfter) {
    EXPECT_TRUE(has_past_after([](systems::Frame& frame) { frame.view.eye_local_m.x += 5.0f; }));
    EXPECT_TRUE(has_past_after([](systems::Frame& frame) { frame.time_s += 0.5; }));
    EXPECT_TRUE(has_past_after([](systems::Frame& frame) { frame.view.clip_from_view[0][0] *= 1.2f; }));
    EXPECT_TRUE(has_past_after([](systems::Frame&) {}, true, 2.0f)) << "another exposure is a factor";
    EXPECT_TRUE(has_past_after([](systems::Frame& frame) {
        frame.view.eye_cell.x += 1;
        frame.view.eye_local_m.x -= 255.0f;
    }));
}

TEST(TemporalHistory, EndsAtACut) {
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) { frame.view.eye_local_m.x += 9.0f; }));
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) { frame.view.eye_cell.z += 1; }));
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) { frame.time_s -= 0.1; }));
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) { frame.time_s += 2.0; }));
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) { frame.view.size_px.x += 1; }));
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) { frame.view.orthographic = true; }));
    EXPECT_FALSE(has_past_after([](systems::Frame& frame) {
        frame.view.view_from_world[0] = {0, 0, 1, 0};
        frame.view.view_from_world[2] = {-1, 0, 0, 0};
    }));
    EXPECT_FALSE(has_past_after([](systems::Frame&) {}, false)) << "another scene";
}

TEST(TemporalHistory, BeginsTheJitterAnewAfterACut) {
    TemporalHistory history;
    Moment moment;
    std::vector<glm::vec2> jitters;
    for (const bool continues : {false, true, true, false, true})
        jitters.push_back(history.follow(moment.frame, 1.0f, continues).jitter_px);
    EXPECT_NE(jitters[0], jitters[1]);
    EXPECT_EQ(jitters[3], jitters[0]);
    EXPECT_EQ(jitters[4], jitters[1]);
}

/// The matrix alone tells where a point at rest was, near, far and at infinity, wherever in the world the eye
/// is.
TEST(TemporalHistory, KnowsWhereAPointAtRestWas) {
    for (const int cell : {0, 3906250}) {
        TemporalHistory history;
        Moment moment;
        systems::FrameView& view = moment.frame.view;
        view.eye_cell = {cell, 0, -cell};
        static_cast<void>(history.follow(moment.frame, 1.0f, false));
        const systems::FrameView then = view;
        view.eye_local_m += glm::vec3{0.5f, -0.25f, 0.125f};
        const float angle = 0.05f;
        view.view_from_world[0] = {std::cos(angle), 0, std::sin(angle), 0};
        view.view_from_world[2] = {-std::sin(angle), 0, std::cos(angle), 0};
        const TemporalFrame& frame = history.follow(moment.frame, 1.0f, true);
        ASSERT_TRUE(frame.has_past && frame.camera_moved);
        for (const double distance_m : {0.5, 5.0, 500.0, 0.0}) {  // 0 stands for infinity
            const glm::dvec4 from_then =
                distance_m > 0.0 ? glm::dvec4{0.1 * distance_m, 0.05 * distance_m, -distance_m, 1.0}
                                 : glm::dvec4{0.1, 0.05, -1.0, 0.0};
            const glm::dvec4 from_now = from_then - from_then.w * glm::dvec4{0.5, -0.25, 0.125, 0.0};
            const glm::dvec4 clip =
                glm::dmat4{frame.view.clip_from_view} * glm::dmat4{view.view_from_world} * from_now;
            const glm::dvec4 past = glm::dmat4{frame.past_from_present} * (clip / clip.w);
            const glm::dvec4 expected = glm::dmat4{then.clip_from_view} * from_then;
            const glm::dvec2 error_px =
                glm::dvec2{480.0, 270.0} * (glm::dvec2{past} / past.w - glm::dvec2{expected} / expected.w);
            EXPECT_LT(glm::length(error_px), 1e-3)
                << distance_m << " m: a float's rounding of the matrix times 480 pixels";
            EXPECT_NEAR(past.z / past.w, expected.z / expected.w, 1e-6);
        }
    }
}

}  // namespace
}  // namespace rambla::render
