#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "support/trace_check.h"
#include "system/pictures.h"
#include "system/program.h"
#include "system/sample_clips.h"
#include "system/x11_client.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;

/// An X server of its own on a free display, with a window of rambla on it, and fingers on its
/// keyboard.
struct Window : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();
    std::unique_ptr<Process> server;
    std::unique_ptr<Process> program;
    std::string display;
    std::string window;

    void SetUp() override {
        std::array<int, 2> pipe_ends{};
        ASSERT_EQ(pipe(pipe_ends.data()), 0);
        ASSERT_NE(fcntl(pipe_ends[0], F_SETFD, FD_CLOEXEC), -1);
        // Without -noreset the server starts anew whenever its last client leaves, and refuses whoever comes
        // just then.
        server = std::make_unique<Process>(
            std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(pipe_ends[1]), "-noreset",
                                     "-screen", "0", "800x600x24"},
            Environment{}, folder);
        close(pipe_ends[1]);
        // The server writes its number once it takes connections; if it fails instead, the pipe just ends.
        std::string started;
        for (char c = 0; read(pipe_ends[0], &c, 1) == 1 && c != '\n';)
            started += c;
        close(pipe_ends[0]);
        ASSERT_FALSE(started.empty()) << "Xvfb does not start";
        display = ":" + started;
    }

    void TearDown() override {
        program.reset();
        if (!server) return;
        server->terminate();
        static_cast<void>(server->wait(std::chrono::seconds{20}));
    }

    void start(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), RAMBLA_PROGRAM);
        program = std::make_unique<Process>(
            arguments, Environment{{"DISPLAY", display}, {"WAYLAND_DISPLAY", ""}}, folder);
        ASSERT_TRUE(eventually([&] {
            window = xdotool({"search", "--onlyvisible", "--name", "^Rambla"});
            return !window.empty() || !program->running();
        }));
        ASSERT_TRUE(program->running()) << program->wait(k_patience).err;
        window = window.substr(0, window.find('\n'));
        static_cast<void>(xdotool({"windowfocus", "--sync", window}));
    }

    std::string xdotool(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "xdotool");
        return Process{arguments, {{"DISPLAY", display}}, folder}.wait(std::chrono::seconds{30}).out;
    }

    /// What the window shows now.
    assets::Image screenshot() {
        std::string number = std::to_string(screenshots_++);
        number.insert(0, 4 - number.size(), '0');
        const fs::path file = folder / "out" / ("screenshot_" + number + ".png");
        static_cast<void>(xdotool({"key", "F12"}));
        EXPECT_TRUE(eventually([&] { return fs::exists(file) || !program->running(); }));
        return picture(file);
    }

    Ended quit() {
        static_cast<void>(xdotool({"key", "Escape"}));
        return program->wait(k_patience);
    }

private:
    int screenshots_ = 0;
};

const std::vector<std::string> k_play{"play",       "--scene",   "city:blocks=1x1,walkers=0,cars=0",
                                      "--size",     "160x90",    "--json",
                                      "state.json", "--shadows", "focused:size=256,taps=4"};

TEST_F(Window, AHeldKeyWalksAndEscapeQuits) {
    start(k_play);
    const assets::Image before = screenshot();
    static_cast<void>(xdotool({"keydown", "w"}));
    // Nothing but the camera can move here.
    EXPECT_TRUE(eventually([&] { return mean_difference(before, screenshot()) > 4.0; }));
    static_cast<void>(xdotool({"keyup", "w"}));
    const Ended ended = quit();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json walked = nlohmann::json::parse(file_text(folder / "state.json"));

    // The same place, left at once, tells where the walk began.
    fs::remove(folder / "state.json");
    start(k_play);
    EXPECT_EQ(quit().exit_code, 0);
    const nlohmann::json stood = nlohmann::json::parse(file_text(folder / "state.json"));
    const double x = walked["eye_m"][0].get<double>() - stood["eye_m"][0].get<double>();
    const double z = walked["eye_m"][2].get<double>() - stood["eye_m"][2].get<double>();
    EXPECT_GT(std::hypot(x, z), 0.1);
    EXPECT_NEAR(walked["eye_m"][1].get<double>(), stood["eye_m"][1].get<double>(), 0.5)
        << "still on the street";
    // W leads where the eye looks.
    const double yaw = stood["yaw_deg"].get<double>() * M_PI / 180.0;
    EXPECT_GT(-std::sin(yaw) * x - std::cos(yaw) * z, 0.1);
}

TEST_F(Window, ClosedByItsUserEndsAsByEscape) {
    start(k_play);
    static_cast<void>(screenshot());  // it is being drawn
    ASSERT_TRUE(ask_to_close(display, window));
    const Ended ended = program->wait(k_patience);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_TRUE(fs::exists(folder / "state.json"));
}

TEST_F(Window, DestroyedFromOutsideEndsAsByEscape) {
    for (int moment = 0; moment < 6; ++moment) {  // another one in a frame each time
        fs::remove(folder / "state.json");
        start(k_play);
        static_cast<void>(screenshot());
        static_cast<void>(xdotool({"windowclose", window}));
        const Ended ended = program->wait(k_patience);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_TRUE(fs::exists(folder / "state.json"));
    }
}

TEST_F(Window, WithoutItsServerEndsByOneLine) {
    start(k_play);
    static_cast<void>(screenshot());
    server->terminate();
    const Ended ended = program->wait(k_patience);
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_THAT(ended.err,
                testing::EndsWith("error: the X server '" + display + "' is gone, and the window with it\n"));
}

TEST_F(Window, MayChangeItsSizeToAnythingWhileItIsDrawn) {
    start(k_play);
    for (const auto& [width, height] :
         {std::pair{"161", "91"}, {"1", "1"}, {"640", "1"}, {"1", "480"}, {"333", "217"}}) {
        static_cast<void>(xdotool({"windowsize", "--sync", window, width, height}));
        const assets::Image picture = screenshot();
        EXPECT_EQ(std::to_string(picture.width) + "x" + std::to_string(picture.height),
                  std::string{width} + "x" + height);
    }
    const Ended ended = quit();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST_F(Window, ShiftMakesTheScreenshotLinear) {
    start(k_play);
    const fs::path file = folder / "out" / "screenshot_0000.exr";
    static_cast<void>(xdotool({"key", "shift+F12"}));
    EXPECT_TRUE(eventually([&] { return fs::exists(file) || !program->running(); }));
    const assets::Image linear = picture(file);
    EXPECT_EQ(linear.width, 160u);
    EXPECT_EQ(non_finite_texels(linear), 0u);
    EXPECT_EQ(quit().exit_code, 0);
    EXPECT_FALSE(fs::exists(folder / "out" / "screenshot_0000.png"));
}

TEST_F(Window, HelpAndTimingsAreDrawnOverThePictureAndGoAgain) {
    start({"play", "--scene", "city:blocks=1x1,walkers=0,cars=0", "--size", "640x400", "--shadows", "off"});
    const assets::Image plain = screenshot();
    // The help panel stands in the middle, the timings at the upper right: each of these squares lies in one
    // only.
    const auto differs = [&](std::uint32_t left, std::uint32_t top) {
        const assets::Image now = screenshot();
        double sum = 0.0;
        for (std::uint32_t y = top; y < top + 20; ++y) {
            for (std::uint32_t x = left; x < left + 20; ++x)
                sum += std::abs(byte_at(now, x, y, 0) - byte_at(plain, x, y, 0));
        }
        return sum / 400.0 > 8.0;
    };
    const auto help_shown = [&] {
        return differs(150, 190);
    };
    const auto timings_shown = [&] {
        return differs(610, 20);
    };
    EXPECT_FALSE(help_shown());
    EXPECT_FALSE(timings_shown());
    static_cast<void>(xdotool({"key", "F1"}));
    EXPECT_TRUE(eventually(help_shown));
    EXPECT_FALSE(timings_shown());
    static_cast<void>(xdotool({"key", "F3"}));
    EXPECT_TRUE(eventually(timings_shown));
    static_cast<void>(xdotool({"key", "F1"}));
    EXPECT_TRUE(eventually([&] { return !help_shown(); }));
    EXPECT_TRUE(timings_shown());
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(Window, ATraceHoldsEveryFrameAndStepOfAWalkOfOnesOwn) {
    std::vector<std::string> arguments = k_play;
    arguments.insert(arguments.end(), {"--trace", "t.json"});
    start(arguments);
    static_cast<void>(screenshot());
    const Ended ended = quit();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json result = nlohmann::json::parse(file_text(folder / "state.json"));
    const tests::ReadTrace trace = tests::read_trace(file_text(folder / "t.json"));
    EXPECT_EQ(tests::fault_of(trace), "");
    EXPECT_EQ(trace.of("frame,gpu").size(), result["frames"].get<std::size_t>());
    EXPECT_EQ(trace.of("look").size(), result["frames"].get<std::size_t>());
    EXPECT_EQ(trace.of("step").size(), result["steps"].get<std::size_t>());
    EXPECT_EQ(tests::ReadTrace::counts(trace.of("pass,gpu"))["tonemap"], result["frames"].get<std::size_t>());
}

TEST_F(Window, AGivenNumberOfFramesEndsByItself) {
    start({"play", "--scene", "city:blocks=1x1,walkers=2,cars=1", "--size", "96x54", "--frames", "20",
           "--json", "-"});
    const Ended ended = program->wait(k_patience);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(nlohmann::json::parse(ended.out)["frames"], 20);
}

TEST_F(Window, AModelIsShownAndEscapeQuits) {
    const Ended made =
        rambla({"generate", "city:blocks=1x1,walkers=1,cars=1", "-o", "city.glb", "--quiet"}, folder);
    ASSERT_EQ(made.exit_code, 0) << made.err;
    start({"view", "city.glb", "--size", "160x90"});
    EXPECT_GT(mean_byte(screenshot()), 20.0);
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(Window, TheFilesCameraMovesUntilTheMouseIsUsed) {
    write_ride(folder / "ride.glb");
    start({"view", "ride.glb", "--size", "160x90", "--clip-time", "0"});
    const auto middle = [&] {
        return byte_at(screenshot(), 80, 45, 1);
    };
    EXPECT_TRUE(eventually([&] { return middle() > 200; })) << "the white tile, time and again";
    EXPECT_TRUE(eventually([&] { return middle() < 60; })) << "the black one";
    EXPECT_TRUE(eventually([&] { return middle() > 200; }));
    static_cast<void>(xdotool({"mousemove", "--window", window, "80", "45", "click", "4"}));
    // Screenshots go through the same pictures as the wheel: from some picture on, all are equal but for
    // the caption's line at the bottom.
    const auto upper_half_rests = [&] {
        const assets::Image first = screenshot();
        const assets::Image second = screenshot();
        for (std::uint32_t y = 0; y < 40; ++y)
            for (std::uint32_t x = 0; x < 160; ++x)
                if (byte_at(first, x, y, 1) != byte_at(second, x, y, 1)) return false;
        return true;
    };
    EXPECT_TRUE(eventually(upper_half_rests));
    EXPECT_TRUE(upper_half_rests());
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(Window, ClipsPlayAndKeysChooseAmongThem) {
    write_clips(folder / "clips.glb");
    start({"view", "clips.glb", "--size", "160x90", "--json", "view.json"});
    const assets::Image before = screenshot();
    EXPECT_TRUE(eventually([&] { return mean_difference(before, screenshot()) > 1.0; })) << "the first clip";
    static_cast<void>(xdotool({"key", "c"}));
    static_cast<void>(screenshot());  // quitting at once could come before the key's picture
    EXPECT_EQ(quit().exit_code, 0);
    const nlohmann::json json = nlohmann::json::parse(file_text(folder / "view.json"));
    EXPECT_EQ(json["clip"], "spin");
    EXPECT_EQ(json["clips"], 2);
}

}  // namespace
}  // namespace rambla::system_test
