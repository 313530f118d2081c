#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "system/pictures.h"
#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;

const std::string k_small_city = "city:blocks=1x1,walkers=6,cars=2";

struct WalkProgram : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();

    nlohmann::json json(const Ended& ended) {
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return nlohmann::json::parse(ended.out);
    }
};

TEST_F(WalkProgram, DrawsFramesThatDifferAreNotBlackAndHoldNumbersOnly) {
    const Ended ended =
        rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "6", "--size", "320x180",
                "--format", "exr", "--profile-frames", "2", "-o", "w", "--graph", "graph.svg", "--json", "-"},
               folder);
    const nlohmann::json result = json(ended);
    for (int i = 0; i < 6; ++i) {
        const std::string name = "w/frame_000" + std::to_string(i);
        const assets::Image shown = picture(folder / (name + ".png"));
        EXPECT_EQ(shown.width, 320u);
        EXPECT_EQ(shown.height, 180u);
        // A street at noon: far from black, and not washed out either.
        EXPECT_GT(mean_byte(shown), 30.0) << name;
        EXPECT_LT(mean_byte(shown), 230.0) << name;
        EXPECT_EQ(non_finite_texels(picture(folder / (name + ".exr"))), 0u) << name;
        if (i == 0) continue;
        const assets::Image before = picture(folder / ("w/frame_000" + std::to_string(i - 1) + ".png"));
        EXPECT_GT(mean_difference(before, shown), 2.0) << "frames " << i - 1 << " and " << i << " look alike";
    }
    EXPECT_FALSE(fs::exists(folder / "w/frame_0006.png"));
    EXPECT_GT(mean_byte(picture(folder / "w/contact.png")), 10.0);
    EXPECT_THAT(file_text(folder / "graph.svg"), testing::HasSubstr("<svg"));

    EXPECT_EQ(result["schema"], "rambla.walk/1");
    EXPECT_EQ(result["frames"], 6);
    EXPECT_GT(result["triangles_median"].get<double>(), 1000.0);
    const nlohmann::json& table = result["pass_table"];
    EXPECT_GE(table["passes"].size(), 5u);
    double passes_ms = 0.0;
    for (const nlohmann::json& pass : table["passes"])
        passes_ms += pass["gpu_ms_median"].get<double>();
    const double frame_ms = table["frame"]["gpu_ms_median"];
    EXPECT_GT(frame_ms, 0.0);
    // Medians of two frames on a loaded machine do not add up exactly; a pass without its flush would read
    // near 0, and the passes then explain a fraction of the frame.
    EXPECT_GT(passes_ms, 0.8 * frame_ms);
    EXPECT_LT(passes_ms, 1.3 * frame_ms);
    EXPECT_THAT(file_text(folder / "w/passes.txt"), testing::HasSubstr("(missing)"));
}

TEST_F(WalkProgram, NightHasADarkSkyAndLampsThatShine) {
    const auto walk = [&](const char* time) {
        const nlohmann::json result =
            json(rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "2", "--size", "160x90",
                         "--time", time, "--profile-frames", "0", "-o", time, "--json", "-"},
                        folder));
        return std::pair{result, picture(folder / time / "frame_0000.png")};
    };
    const auto [noon, noon_picture] = walk("noon");
    const auto [night, night_picture] = walk("night");
    EXPECT_EQ(noon["time"], "noon");
    EXPECT_EQ(night["time"], "22:00");
    EXPECT_GT(night["visible_lights_most"].get<int>(), noon["visible_lights_most"].get<int>() + 10);
    // Above the street's end is sky, which the long exposure of the night leaves dark.
    const auto sky = [](const assets::Image& image) {
        return byte_at(image, 80, 1, 0) + byte_at(image, 80, 1, 1) + byte_at(image, 80, 1, 2);
    };
    EXPECT_LT(sky(night_picture), sky(noon_picture) / 2);
    EXPECT_GT(mean_byte(night_picture), 15.0) << "houses can be made out";
}

TEST_F(WalkProgram, FramesOfAnEarlierWalkAreGone) {
    write_file(folder / "frame_0077.png", "old");
    write_file(folder / "holiday.png", "mine");
    const Ended ended = rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "1", "--size",
                                "64x36", "--profile-frames", "0", "-o", ".", "--quiet"},
                               folder);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_FALSE(fs::exists(folder / "frame_0077.png"));
    EXPECT_TRUE(fs::exists(folder / "frame_0000.png"));
    EXPECT_EQ(file_text(folder / "holiday.png"), "mine");
}

TEST_F(WalkProgram, TwoHundredFramesHoldNoMoreThanFifty) {
    const Ended ended = rambla(
        {"walk", "--headless", "--scene", k_small_city, "--frames", "200", "--size", "96x54", "--shadows",
         "focused:size=256,taps=4", "--profile-frames", "0", "--stats", "-o", "w", "--json", "-"},
        folder);
    const nlohmann::json result = json(ended);
    EXPECT_EQ(result["steady"], true) << ended.err;
    EXPECT_EQ(result["gl_object_growth"], 0);
    EXPECT_THAT(ended.err, testing::HasSubstr("memory: steady over frames 50 to 199"));
}

TEST_F(WalkProgram, TheSimulationIsTheSameForAnyNumberOfThreads) {
    const auto walk = [&](const char* threads, const char* seed) {
        return json(rambla({"walk", "--no-render", "--steps", "300", "--threads", threads, "--seed", seed,
                            "--scene", "city:blocks=2x2,walkers=300,cars=20", "--json", "-"},
                           folder));
    };
    const nlohmann::json one = walk("1", "5");
    const nlohmann::json two = walk("2", "5");
    const nlohmann::json eight = walk("8", "5");
    EXPECT_EQ(one["state_hash"], two["state_hash"]);
    EXPECT_EQ(one["state_hash"], eight["state_hash"]);
    EXPECT_NE(one["state_hash"], walk("1", "6")["state_hash"]) << "the seed must matter";
    EXPECT_EQ(one["worker_threads"], 1);
    EXPECT_EQ(two["worker_threads"], 2);
    EXPECT_EQ(eight["worker_threads"], 8) << "whatever the number of cores";
}

TEST_F(WalkProgram, ASavedSimulationGoesOnAsIfItHadNotStopped) {
    const auto walk = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"walk", "--no-render", "--scene", k_small_city, "--json", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return rambla(arguments, folder);
    };
    const auto whole = json(walk({"--steps", "200"}))["state_hash"];
    const auto half = json(walk({"--steps", "100", "--save-state", "half.state"}))["state_hash"];
    EXPECT_NE(half, whole);
    EXPECT_EQ(json(walk({"--steps", "0", "--load-state", "half.state"}))["state_hash"], half);
    EXPECT_EQ(json(walk({"--steps", "100", "--load-state", "half.state"}))["state_hash"], whole);

    const Ended other = walk({"--seed", "9", "--load-state", "half.state"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.err, testing::HasSubstr("seed 9"));
    EXPECT_EQ(walk({"--time", "night", "--load-state", "half.state"}).exit_code, 2) << "other lamps burn";
    EXPECT_EQ(line_count(other.err), 1u);
    const std::string bytes = file_text(folder / "half.state");
    write_file(folder / "short.state", bytes.substr(0, bytes.size() / 2));
    const Ended cut = walk({"--load-state", "short.state"});
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_THAT(cut.err, testing::HasSubstr("short.state"));
    EXPECT_EQ(walk({"--load-state", "nowhere.state"}).exit_code, 2);
}

TEST_F(WalkProgram, FarFromTheWorldsOriginThePictureIsTheSame) {
    const auto walk = [&](const char* origin, const char* out) {
        const Ended ended = rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "1", "--size",
                                    "160x90", "--profile-frames", "0", "--origin", origin, "-o", out},
                                   folder);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return picture(folder / out / "frame_0000.png");
    };
    const assets::Image home = walk("0,0,0", "home");
    const assets::Image far = walk("1000000,0,-1000000", "far");
    // The camera stands on the float grid of another cell, 3e-5 m apart at most: single pixels on edges may
    // change.
    EXPECT_LT(mean_difference(home, far), 0.5);
}

TEST_F(WalkProgram, WholeCellsFromTheWorldsOriginEveryByteIsTheSame) {
    // Shadows are off: the texels of the sun's map lie on a grid of the whole world, not of its cells.
    const auto frame = [&](const char* origin, const char* out) {
        const Ended ended =
            rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "1", "--size", "160x90",
                    "--shadows", "off", "--profile-frames", "0", "--origin", origin, "-o", out},
                   folder);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return file_text(folder / out / "frame_0000.png");
    };
    const std::string home = frame("0,0,0", "home");
    EXPECT_FALSE(home.empty());
    EXPECT_TRUE(home == frame("256000,0,-512000", "cells"));
}

}  // namespace
}  // namespace rambla::system_test
