// Five ways to find the lights of a pixel, and one picture of the places that people walk through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "system/pictures.h"
#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;

struct Difference {
    int largest = 0;              ///< of any channel, in 1/255
    double beyond_one_pct = 0.0;  ///< pixels with a channel that differs by more than 1/255
};

Difference difference(const assets::Image& a, const assets::Image& b) {
    Difference found;
    std::size_t beyond = 0;
    for (std::uint32_t y = 0; y < a.height; ++y) {
        for (std::uint32_t x = 0; x < a.width; ++x) {
            int largest = 0;
            for (std::uint32_t channel = 0; channel < 3; ++channel)
                largest = std::max(largest, std::abs(byte_at(a, x, y, channel) - byte_at(b, x, y, channel)));
            found.largest = std::max(found.largest, largest);
            beyond += largest > 1 ? 1 : 0;
        }
    }
    found.beyond_one_pct = 100.0 * static_cast<double>(beyond) / (static_cast<double>(a.width) * a.height);
    return found;
}

struct LightingPathsProgram : testing::Test {
    ScratchFolder scratch;

    nlohmann::json walk(const std::string& path, std::vector<std::string> scene) {
        std::vector<std::string> arguments{
            "walk",       "--headless", "--frames", "1",       "--profile-frames",
            "0",          "--size",     "480x270",  "--aa",    "none",
            "--lighting", path,         "-o",       path,      "--json",
            "-",          "--exposure", "fixed",    "--bloom", "off"};
        arguments.insert(arguments.end(), scene.begin(), scene.end());
        const Ended ended = rambla(arguments, scratch.path());
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return nlohmann::json::parse(ended.out);
    }

    void expect_one_picture(const std::vector<std::string>& scene) {
        walk("fullscreen", scene);
        const assets::Image all = picture(scratch.path() / "fullscreen/frame_0000.png");
        for (const std::string path : {"volumes", "volumes:volume=solid", "clustered", "tiled", "forward"}) {
            walk(path, scene);
            const assets::Image other = picture(scratch.path() / path / "frame_0000.png");
            ASSERT_EQ(other.width, all.width);
            const Difference found = difference(all, other);
            // What the renderer promises of its paths. Those that sum in a shader agree to the bit; volumes
            // round each lamp's light to a half float, and forward interpolates positions that deferred
            // shading unprojects.
            EXPECT_LE(found.largest, 4) << path;
            EXPECT_LE(found.beyond_one_pct, 0.01) << path;
            if (path == "clustered" || path == "tiled") {
                EXPECT_EQ(found.largest, 0) << path;
            }
        }
    }
};

TEST_F(LightingPathsProgram, GiveOnePictureOfTheBlocks) {
    expect_one_picture({"--scene", "blocks"});
}

TEST_F(LightingPathsProgram, GiveOnePictureOfTheStreetAtNight) {
    const std::vector<std::string> street{"--scene", "street", "--time", "night"};
    const nlohmann::json lit = walk("tiled", street);
    EXPECT_GE(lit["visible_lights_most"].get<int>(), 200);
    expect_one_picture(street);
}

TEST_F(LightingPathsProgram, DrawTheSameBytesWithOneRasterThreadAndWithTwo) {
    std::string first;
    for (const char* const threads : {"1", "2", "1", "2"}) {
        const std::vector<std::string> command{
            RAMBLA_PROGRAM, "walk",   "--headless",       "--scene", "city:blocks=1x1", "--time",  "night",
            "--frames",     "1",      "--profile-frames", "0",       "--size",          "320x180", "-o",
            "out",          "--quiet"};
        Process process{command, {{"LP_NUM_THREADS", threads}, {"DISPLAY", ""}}, scratch.path()};
        EXPECT_EQ(process.wait(k_patience).exit_code, 0);
        const std::string bytes = file_text(scratch.path() / "out/frame_0000.png");
        ASSERT_FALSE(bytes.empty());
        if (first.empty()) first = bytes;
        EXPECT_TRUE(bytes == first) << threads << " raster threads";
    }
}

}  // namespace
}  // namespace rambla::system_test
