#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <thread>

#include "assets/error.h"
#include "game/run_trace.h"
#include "game/stage.h"
#include "game/trace_file.h"
#include "support/trace_check.h"
#include "systems/simulation.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using tests::fault_of;
using tests::read_trace;
using tests::ReadSpan;
using tests::ReadTrace;

const Clock::time_point k_zero = Clock::now();

struct TraceFolder : testing::Test {
    fs::path folder =
        fs::temp_directory_path() / ("rambla-" + std::to_string(getpid()) +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::path file = folder / "deeper" / "trace.json";
    void TearDown() override { fs::remove_all(folder); }

    std::string text() {
        std::ifstream stream{file};
        return {std::istreambuf_iterator<char>{stream}, {}};
    }
};

using TraceFiles = TraceFolder;
using RunTraces = TraceFolder;

TEST_F(TraceFiles, WithoutEventsIsAnEmptyArray) {
    TraceFile{file, k_zero}.close();
    EXPECT_EQ(nlohmann::json::parse(text()), nlohmann::json::array());
}

TEST_F(TraceFiles, TimesComeBackToTheNanosecond) {
    TraceFile trace{file, k_zero};
    trace.name_track(7, "here");
    // A second, so that a float's digits or a default precision of six would not do.
    trace.add({.name = "a",
               .category = "c,d",
               .track = 7,
               .begin = k_zero + 1s + 1ns,
               .duration = 2us + 30ns,
               .of = "step",
               .number = 18'000'000'000'000'000'000u});
    trace.close();
    const nlohmann::json events = nlohmann::json::parse(text());
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0]["name"], "thread_name");
    EXPECT_EQ(events[0]["ph"], "M");
    EXPECT_EQ(events[0]["tid"], 7);
    EXPECT_EQ(events[0]["args"]["name"], "here");
    EXPECT_EQ(events[1]["ph"], "X");
    EXPECT_EQ(events[1]["cat"], "c,d");
    EXPECT_EQ(events[1]["pid"], events[0]["pid"]);
    EXPECT_EQ(events[1]["args"]["step"], 18'000'000'000'000'000'000u);
    EXPECT_THAT(text(), testing::HasSubstr(R"("ts":1000000.001,"dur":2.030,)"));
    const ReadTrace read = read_trace(text());
    EXPECT_EQ(read.spans.at(0).begin_ns, 1'000'000'001);
    EXPECT_EQ(read.spans.at(0).end_ns, 1'000'002'031);
}

TEST_F(TraceFiles, AnyNameCanBeWritten) {
    const std::string name = "\"quoted\" \\ back\nline\ttab \x01 Größe";
    TraceFile trace{file, k_zero};
    trace.name_track(1, name);
    trace.add({.name = name, .category = name, .track = 1, .begin = k_zero, .duration = 1ns, .of = name});
    trace.add({.name = "no UTF-8: \xff", .category = "c", .track = 1, .begin = k_zero + 1ns, .of = "step"});
    trace.close();
    const ReadTrace read = read_trace(text());
    ASSERT_EQ(read.spans.size(), 2u);
    EXPECT_EQ(read.track_names.at(1), name);
    EXPECT_EQ(read.spans[0].name, name);
    EXPECT_EQ(read.spans[0].category, name);
    EXPECT_TRUE(read.spans[0].args.contains(name));
    EXPECT_EQ(read.spans[1].name, "no UTF-8: \uFFFD");
}

TEST_F(TraceFiles, OneThatIsNotClosedIsWholeAllTheSame) {
    {
        TraceFile trace{file, k_zero};
        trace.name_track(1, "main");
    }
    EXPECT_EQ(nlohmann::json::parse(text()).size(), 1u);
}

/// What close() or the constructor says of a file.
std::string error_of(const fs::path& file) {
    try {
        TraceFile{file, k_zero}.close();
    } catch (const assets::Error& error) {
        return error.what();
    }
    return {};
}

TEST_F(TraceFiles, AFailureNamesFileAndReason) {
    fs::create_directories(folder);
    std::ofstream{folder / "letter"} << "not a folder";
    EXPECT_EQ(error_of(folder / "letter" / "t.json"),
              (folder / "letter" / "t.json").string() + ": cannot be written: Not a directory");
    EXPECT_EQ(error_of(folder), folder.string() + ": cannot be written: Is a directory");
    EXPECT_EQ(error_of("/dev/full"), "/dev/full: cannot be written: No space left on device");
}

TEST_F(TraceFiles, AFailureInTheMiddleIsToldAtTheEnd) {
    TraceFile trace{"/dev/full", k_zero};
    for (int i = 0; i < 10'000; ++i)  // more than any buffer holds
        trace.name_track(1, "main");
    EXPECT_THROW(trace.close(), assets::Error);
}

TEST_F(TraceFiles, HoldsWholeEventsAtAnyMoment) {
    TraceFile trace{file, k_zero};
    std::uintmax_t size = 0;
    std::size_t most = 0;
    for (int i = 0; i < 3000; ++i) {
        trace.name_track(1, "main " + std::to_string(i));
        const std::uintmax_t now = fs::file_size(file);
        if (now == size) continue;
        size = now;
        const std::string so_far = text();
        const nlohmann::json events = nlohmann::json::parse(so_far + "]", nullptr, false);
        ASSERT_FALSE(events.is_discarded()) << "after " << i << ": " << so_far.substr(so_far.size() - 60);
        most = std::max(most, events.size());
    }
    EXPECT_GT(most, 1000u) << "it is written as it grows";
    trace.close();
}

/// A frame of two passes that begins at `begin_ms` after the trace, on the GPU by `gpu_late_ms` later.
systems::Feedback frame(std::uint64_t number, double begin_ms, double gpu_late_ms) {
    // One for all frames, or they would overlap by chance, and later than any test of the program begins its
    // trace: what lies before a trace's own begin is cut off.
    static const Clock::time_point first = Clock::now() + 24h;
    const auto at = [](double ms) {
        return first + std::chrono::microseconds{std::llround(1000.0 * ms)};
    };
    systems::Feedback feedback;
    feedback.frame = number;
    feedback.cpu_begin = at(begin_ms);
    feedback.cpu_frame_ms = 4.0;
    feedback.gpu_begin = feedback.cpu_begin + std::chrono::microseconds{std::llround(1000.0 * gpu_late_ms)};
    feedback.gpu_frame_ms = 8.0;
    for (const double pass : {0.0, 1.0}) {
        const auto later = [&](double ms) {
            return std::chrono::microseconds{std::llround(1000.0 * pass * ms)};
        };
        feedback.passes.push_back({.name = pass == 0.0 ? "sky" : "light",
                                   .gpu_ms = 4.0,
                                   .cpu_ms = 2.0,
                                   .cpu_begin = feedback.cpu_begin + later(2.0),
                                   .gpu_begin = feedback.gpu_begin + later(4.0)});
    }
    return feedback;
}

TEST_F(RunTraces, FramesHoldTheirPassesOnBothSides) {
    RunTrace trace{file};
    trace.add(frame(5, 10.0, 1.0));
    trace.add(frame(6, 20.0, 1.0));
    trace.finish();
    const ReadTrace read = read_trace(text());
    EXPECT_EQ(fault_of(read), "");
    for (const char* const side : {"cpu", "gpu"}) {
        const std::vector<ReadSpan> frames = read.of(std::string{"frame,"} + side);
        const std::vector<ReadSpan> passes = read.of(std::string{"pass,"} + side);
        ASSERT_EQ(frames.size(), 2u);
        ASSERT_EQ(passes.size(), 4u);
        EXPECT_EQ(frames[0].args["frame"], 5);
        EXPECT_EQ(frames[1].args["frame"], 6);
        EXPECT_EQ(passes[3].name, "light");
        EXPECT_EQ(passes[3].args["frame"], 6);
        EXPECT_EQ(read.track_names.at(passes[3].track), side == std::string{"cpu"} ? "render" : "GPU");
    }
    EXPECT_EQ(read.of("frame,gpu")[0].begin_ns - read.of("frame,cpu")[0].begin_ns, 1'000'000);
    EXPECT_EQ(read.of("pass,gpu")[1].begin_ns - read.of("pass,gpu")[0].begin_ns, 4'000'000);
}

TEST_F(RunTraces, AGpuClockThatIsSetBackLetsNothingOverlap) {
    RunTrace trace{file};
    trace.add(frame(0, 10.0, 0.5));
    trace.add(frame(1, 18.0, 0.4));  // begins 0.1 ms before the end of the one before
    systems::Feedback early = frame(2, 28.0, 0.0);
    early.passes[1].gpu_begin -= 300us;  // begins in the pass before, and ends where the frame has ended
    early.gpu_frame_ms = 7.0;
    trace.add(early);
    trace.finish();
    const ReadTrace read = read_trace(text());
    EXPECT_EQ(fault_of(read), "");
    EXPECT_EQ(read.of("pass,gpu").size(), 6u);
    EXPECT_EQ(read.of("frame,gpu")[1].begin_ns, read.of("frame,gpu")[0].end_ns);
}

TEST_F(RunTraces, AFrameWithoutTimersHasNothingOnTheGpu) {
    RunTrace trace{file};
    systems::Feedback untimed = frame(0, 10.0, 0.0);
    untimed.gpu_begin = {};
    trace.add(untimed);
    trace.finish();
    const ReadTrace read = read_trace(text());
    EXPECT_EQ(read.of("pass,cpu").size(), 2u);
    EXPECT_TRUE(read.of("pass,gpu").empty());
    EXPECT_TRUE(read.of("frame,gpu").empty());
}

TEST_F(RunTraces, EachThreadHasATrackOfItsOwn) {
    std::thread other{[] {
    }};
    const std::thread::id other_id = other.get_id();
    ecs::World world;
    RunTrace trace{file};
    trace.listen_to(world);
    const Clock::time_point begin = Clock::now();
    // They overlap, which they could not on one thread; and the plan's order is not that of their begins.
    const std::vector<systems::SystemTiming> ran{
        {.name = "last", .ms = 3.0, .begin = begin + 4ms, .thread = std::this_thread::get_id()},
        {.name = "there", .ms = 4.0, .begin = begin + 1ms, .thread = other_id},
        {.name = "here", .ms = 2.0, .begin = begin, .thread = std::this_thread::get_id()}};
    world.resource<systems::SystemsListener>().heard(
        {.number = 1, .begin = begin, .end = begin + 8ms, .systems = ran});
    trace.finish();
    other.join();
    const ReadTrace read = read_trace(text());
    EXPECT_EQ(fault_of(read), "");
    std::map<std::string, std::string> tracks;
    for (const ReadSpan& span : read.of("system"))
        tracks[span.name] = read.track_names.at(span.track);
    EXPECT_EQ(tracks, (std::map<std::string, std::string>{
                          {"here", "main"}, {"last", "main"}, {"there", "worker 1"}}));
}

TEST_F(RunTraces, EverySystemOfEveryStepIsThere) {
    constexpr std::uint64_t k_steps = 3;
    Stage stage = make_stage("city:blocks=1x1,walkers=6,cars=2", 1, {}, {});
    RunTrace trace{file};
    systems::step(*stage.world);  // before it listens
    trace.listen_to(*stage.world);
    for (std::uint64_t i = 0; i < k_steps; ++i)
        systems::step(*stage.world);
    systems::Frame looked;
    systems::build_frame(*stage.world, systems::Eye{}, 1.0f, looked);
    trace.finish();
    const ReadTrace read = read_trace(text());
    EXPECT_EQ(fault_of(read), "");
    std::set<std::pair<std::string, std::uint64_t>> runs;
    for (const ReadSpan& span : read.of("system")) {
        if (span.args.contains("step")) runs.insert({span.name, span.args["step"]});
    }
    const systems::Simulation simulation = systems::make_simulation();
    for (const ecs::PlannedSystem& system : simulation.schedule->plan().systems) {
        for (const std::uint64_t step : {2u, 3u, 4u})
            EXPECT_EQ(runs.count({system.name, step}), 1u) << system.name << " in step " << step;
    }
    EXPECT_EQ(runs.size(), k_steps * simulation.schedule->plan().systems.size());
    const std::vector<ReadSpan> steps = read.of("step");
    ASSERT_EQ(steps.size(), k_steps);
    ASSERT_EQ(read.of("look").size(), 1u);
    EXPECT_EQ(read.track_names.at(steps[0].track), "main");
    // A step lasts from before its first system to after its last.
    for (const ReadSpan& span : read.of("system")) {
        if (!span.args.contains("step")) continue;
        const ReadSpan& step = steps[span.args["step"].get<std::size_t>() - 2];
        EXPECT_GE(span.begin_ns, step.begin_ns) << span.name;
        EXPECT_LE(span.end_ns, step.end_ns) << span.name;
    }
}

}  // namespace
}  // namespace rambla::game
