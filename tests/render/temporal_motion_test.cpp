// Temporal anti-aliasing while things or the camera move.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "render/temporal_world.h"

namespace {

using namespace rambla;
using tests::k_settling_frames;
using tests::Picture;
using tests::World;

/// A bright wall with darker stripes, two pixels wide and as far apart.
void build_wall(World& world) {
    const std::uint32_t bright = world.glowing(glm::vec3{1.0f}), less = world.glowing(glm::vec3{0.5f});
    world.place(bright, {-200, -90}, {200, 90}, 0.0f);
    for (int i = -30; i < 30; ++i)
        world.place(less, {4.0f * i + 0.3f, -90}, {4.0f * i + 2.3f, 90}, 0.05f);
}

/// Something dark, 40 pixels high, that passes before the wall.
struct Passer {
    std::function<void(World&)> add;
    std::function<void(World&, int frame)> go;
    std::function<float(int frame)> left_px;  ///< its left side
    int frames;
};

struct Trail {
    double worst = 0.0;
    double mean = 0.0;
    int pixels = 0;
};

/// Of the pixels that it has left more than three pictures ago: how much darker they are than without it.
Trail trail_of(const Passer& passer) {
    World with, without;
    build_wall(with);
    build_wall(without);
    passer.add(with);
    Trail trail;
    for (int frame = 0; frame < passer.frames; ++frame) {
        passer.go(with, frame);
        const Picture a = frame == 0 ? with.stage.draw() : with.stage.draw_next();
        const Picture b = frame == 0 ? without.stage.draw() : without.stage.draw_next();
        // Uncovered between frames − 4 and − 3 or before: this is the fourth picture at least that shows
        // them.
        const int end =
            frame < 4 ? -64 : static_cast<int>(std::floor(std::min(64.0f, passer.left_px(frame - 4))));
        for (int x = static_cast<int>(passer.left_px(0)); x < end; ++x) {
            for (int y = -19; y < 19; ++y) {
                const auto column = static_cast<std::uint32_t>(x + 64),
                           row = static_cast<std::uint32_t>(63 - y);
                const double darker = b.radiance(column, row).x - a.radiance(column, row).x;
                trail.worst = std::max(trail.worst, darker);
                trail.mean += darker;
                ++trail.pixels;
            }
        }
    }
    trail.mean /= std::max(1, trail.pixels);
    return trail;
}

constexpr int k_box_px = 24;

int frames_at(int speed_px) {
    return std::min(24, 8 + 160 / speed_px);
}

/// @param before_m  how far before the wall, which is 5 m from the eye
Passer box_of(int speed_px, float before_m = 1.0f) {
    const auto left = [speed_px](int frame) {
        return static_cast<float>(-56 + speed_px * frame);
    };
    const auto place = [left, before_m](int frame) {
        return World::rectangle({left(frame), -20}, {left(frame) + k_box_px, 20}, before_m);
    };
    return {
        .add =
            [place](World& world) {
                world.stage.place(world.square, world.glowing(glm::vec3{0.01f}), place(0));
            },
        .go = [place](World& world, int frame) { world.stage.things.back().world_from_local = place(frame); },
        .left_px = left,
        .frames = frames_at(speed_px)};
}

/// A trail would darken by up to 1. What remains is the difference of a mean of four samples or more to one
/// of many, at stripes that differ by a half, and pictures go on converging.
constexpr double k_no_trail = 0.15;
constexpr double k_no_trail_on_average = 0.01;

void expect_no_trail(const Trail& trail, int speed_px) {
    EXPECT_GT(trail.pixels, 500) << speed_px;
    EXPECT_LT(trail.worst, k_no_trail) << speed_px;
    EXPECT_LT(trail.mean, k_no_trail_on_average) << speed_px;
}

TEST(TemporalAntiAliasing, ABoxThatPassesLeavesNoTrailOfMoreThanThreePictures) {
    for (const int speed_px : {1, 2, 3, 5, 8, 13, 20})
        expect_no_trail(trail_of(box_of(speed_px)), speed_px);
}

TEST(TemporalAntiAliasing, NoTrailIsLeftByWhatPassesCloserThanDepthsAreKnown) {
    for (const float before_m : {0.05f, 0.14f})
        for (const int speed_px : {2, 5, 13})
            expect_no_trail(trail_of(box_of(speed_px, before_m)), speed_px);
}

/// Its left side goes on evenly, its right side swings.
Passer walker_of(int speed_px) {
    Passer passer = box_of(speed_px);
    const auto pose = [left = passer.left_px](World& world, int frame) {
        const glm::mat4 body = World::rectangle({left(frame), -20}, {left(frame) + k_box_px, 20}, 1.0f);
        const float swing = 0.3f * std::sin(0.9f * static_cast<float>(frame));
        world.stage.things.back().world_from_mesh = {
            body, body * glm::translate(glm::mat4{1.0f}, glm::vec3{0.2f * swing, swing, 0.0f})};
    };
    passer.add = [pose](World& world) {
        assets::Mesh m = world.stage.scene.meshes[world.square];
        m.joints.assign(4, {0, 1, 0, 0});
        m.weights = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}};
        world.stage.place(world.stage.mesh(std::move(m)), world.glowing(glm::vec3{0.01f}));
        pose(world, 0);
    };
    passer.go = pose;
    return passer;
}

TEST(TemporalAntiAliasing, AWalkerWithJointsLeavesNoTrailEither) {
    for (const int speed_px : {1, 4, 12})
        expect_no_trail(trail_of(walker_of(speed_px)), speed_px);
}

double shown(double radiance) {
    return radiance / (1.0 + radiance);
}

/// Root of the mean square of what two pictures show differently.
double difference(const Picture& a, const Picture& b, glm::uvec4 part) {
    double sum2 = 0.0;
    int count = 0;
    for (std::uint32_t y = part.y; y < part.w; ++y) {
        for (std::uint32_t x = part.x; x < part.z; ++x, ++count) {
            const double d = shown(a.radiance(x, y).x) - shown(b.radiance(x, y).x);
            sum2 += d * d;
        }
    }
    return std::sqrt(sum2 / count);
}

/// Sum of squared steps from pixel to pixel: what blur takes away.
double sharpness(const Picture& picture, glm::uvec4 part) {
    double sum2 = 0.0;
    for (std::uint32_t y = part.y; y < part.w; ++y) {
        for (std::uint32_t x = part.x; x < part.z; ++x) {
            const double d = shown(picture.radiance(x, y).x) - shown(picture.radiance(x + 1, y).x);
            sum2 += d * d;
        }
    }
    return sum2;
}

/// A wall, and posts before it that hide and show it again.
void build_street(World& world) {
    build_wall(world);
    const std::uint32_t post = world.glowing({0.1f, 0.2f, 0.3f});
    for (const float x : {-40.0f, -5.0f, 33.0f})
        world.place(post, {x, -90}, {x + 7.0f, 90}, 2.0f, 0.05f);
}

void look(World& world, float t) {
    // Sideways, ahead and turning, by two to three pixels per picture.
    world.stage.look({0.05f * t, 0.01f * t, World::k_eye_m - 0.02f * t}, {0.09f * t, 0, 0},
                     World::k_vertical_fov_rad);
    world.stage.frame.view.eye_local_m = world.stage.eye;
}

TEST(TemporalAntiAliasing, WhatIsFoundAgainByTheCamerasMotionIsSharp) {
    const glm::uvec4 middle{16, 16, 111, 112};
    constexpr int k_frames = 30;
    World moving, still, plain{render::AntiAliasing::none};
    for (World* world : {&moving, &still, &plain})
        build_street(*world);
    Picture picture;
    for (int frame = 0; frame <= k_frames; ++frame) {
        look(moving, static_cast<float>(frame));
        picture = frame == 0 ? moving.stage.draw() : moving.stage.draw_next();
    }
    look(still, k_frames);
    look(plain, k_frames);
    const Picture reference = still.after(k_settling_frames);
    const Picture aliased = plain.stage.draw();
    EXPECT_LT(difference(picture, reference, middle), 0.85 * difference(aliased, reference, middle));
    EXPECT_GT(sharpness(picture, middle), 0.75 * sharpness(reference, middle));
}

TEST(TemporalAntiAliasing, AThingThatMovesIsAsSharpAsOneAtRest) {
    const auto build = [](World& world) {
        world.place(world.glowing(glm::vec3{0.2f}), {-90, -90}, {90, 90}, 0.0f);
        const std::uint32_t bright = world.glowing(glm::vec3{1.0f}), less = world.glowing(glm::vec3{0.4f});
        world.place(bright, {-20, -20}, {20, 20}, 1.0f);
        for (int i = -2; i < 2; ++i)
            world.place(less, {10.0f * i, -20}, {10.0f * i + 4.0f, 20}, 1.001f);
    };
    constexpr int k_frames = 30;
    const auto go = [](World& world, int frame) {
        const glm::vec2 by_px =
            glm::vec2{1.3f, 0.4f} * static_cast<float>(frame - k_frames) + glm::vec2{0.4f, 0.2f};
        for (std::size_t i = 1; i < world.stage.things.size(); ++i) {
            const int stripe = static_cast<int>(i) - 2;
            const float x = 10.0f * static_cast<float>(stripe - 2);
            world.stage.things[i].world_from_local =
                i == 1 ? World::rectangle(glm::vec2{-20, -20} + by_px, glm::vec2{20, 20} + by_px, 1.0f)
                       : World::rectangle(glm::vec2{x, -20} + by_px, glm::vec2{x + 4.0f, 20} + by_px, 1.001f);
        }
    };
    World moving, still, plain{render::AntiAliasing::none};
    for (World* world : {&moving, &still, &plain})
        build(*world);
    Picture picture;
    for (int frame = 0; frame <= k_frames; ++frame) {
        go(moving, frame);
        picture = frame == 0 ? moving.stage.draw() : moving.stage.draw_next();
    }
    go(still, k_frames);
    go(plain, k_frames);
    const glm::uvec4 box{40, 40, 87, 88};
    const Picture reference = still.after(k_settling_frames);
    const Picture aliased = plain.stage.draw();
    EXPECT_LT(difference(picture, reference, box), 0.7 * difference(aliased, reference, box));
    EXPECT_GT(sharpness(picture, box), 0.85 * sharpness(reference, box));
}

}  // namespace
