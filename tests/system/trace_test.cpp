#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "support/trace_check.h"
#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using tests::ReadSpan;
using tests::ReadTrace;

const std::string k_small_city = "city:blocks=1x1,walkers=6,cars=2";

struct TraceProgram : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();

    nlohmann::json json(const Ended& ended) {
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return nlohmann::json::parse(ended.out);
    }

    ReadTrace trace() {
        ReadTrace read = tests::read_trace(file_text(folder / "t.json"));
        EXPECT_EQ(tests::fault_of(read), "");
        return read;
    }

    /// Names of the systems of the simulation (0) or of looking (1).
    std::vector<std::string> systems(std::size_t schedule) {
        std::vector<std::string> names;
        const nlohmann::json all = json(rambla({"doctor", "--schedule", "--json", "-"}, folder));
        for (const nlohmann::json& system : all["schedules"][schedule]["systems"])
            names.push_back(system["name"]);
        return names;
    }

    void expect_refused(const std::vector<std::string>& arguments, const std::string& said) {
        const Ended ended = rambla(arguments, folder);
        EXPECT_EQ(ended.exit_code, 2) << ended.err;
        EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(said));
    }
};

/// How often spans of a name come for each frame or step.
std::map<std::pair<std::string, std::uint64_t>, std::size_t> runs(const std::vector<ReadSpan>& spans,
                                                                  const char* of) {
    std::map<std::pair<std::string, std::uint64_t>, std::size_t> counts;
    for (const ReadSpan& span : spans) {
        if (span.args.contains(of)) ++counts[{span.name, span.args[of].get<std::uint64_t>()}];
    }
    return counts;
}

TEST_F(TraceProgram, AWalkHasEverySystemAndEveryPassOfEveryFrame) {
    const nlohmann::json result = json(
        rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "4", "--size", "96x54",
                "--profile-frames", "2", "--threads", "2", "-o", "w", "--trace", "t.json", "--json", "-"},
               folder));
    constexpr std::size_t k_frames = 4 + 1 + 2;  // one more warms the timers up
    EXPECT_EQ(result["gl_blocking_calls"], 0) << "the GPU's times are read when they are there";
    const ReadTrace read = trace();
    ASSERT_EQ(read.of("frame,cpu").size(), k_frames);
    ASSERT_EQ(read.of("frame,gpu").size(), k_frames);
    ASSERT_EQ(read.of("look").size(), k_frames);
    const std::uint64_t steps = result["steps"];
    ASSERT_GT(steps, 100u);
    EXPECT_EQ(read.of("step").size(), steps);

    const auto of_steps = runs(read.of("system"), "step");
    for (const std::string& name : systems(0)) {
        for (std::uint64_t step = 1; step <= steps; ++step)
            ASSERT_EQ(of_steps.count({name, step}), 1u) << name << " in step " << step;
    }
    const auto of_looks = runs(read.of("system"), "frame");
    for (const std::string& name : systems(1)) {
        for (std::uint64_t frame = 0; frame < k_frames; ++frame)
            EXPECT_EQ(of_looks.count({name, frame}), 1u) << name << " for frame " << frame;
    }
    EXPECT_EQ(read.of("system").size(), steps * systems(0).size() + k_frames * systems(1).size());

    const nlohmann::json& table = result["pass_table"]["passes"];
    ASSERT_GE(table.size(), 5u);
    // The average luminance is found in steps of one name: from 96 pixels across to 24, 6, 2 and 1.
    const auto wanted = [](const nlohmann::json& pass) {
        return pass["name"] == "luminance" ? 4u : 1u;
    };
    for (const char* const side : {"pass,cpu", "pass,gpu"}) {
        const auto of_frames = runs(read.of(side), "frame");
        for (const nlohmann::json& pass : table) {
            if (pass["name"] == "blend") continue;  // smoke comes into view and goes
            ASSERT_EQ(pass["frames"], 2) << pass["name"] << " comes and goes";
            for (std::uint64_t frame = 0; frame < k_frames; ++frame) {
                const auto found = of_frames.find({pass["name"], frame});
                ASSERT_NE(found, of_frames.end()) << side << ' ' << pass["name"] << ' ' << frame;
                EXPECT_EQ(found->second, wanted(pass)) << side << ' ' << pass["name"] << ' ' << frame;
            }
        }
    }
}

TEST_F(TraceProgram, TheGpuWorksAfterItWasAsked) {
    static_cast<void>(
        json(rambla({"walk", "--headless", "--scene", k_small_city, "--frames", "4", "--size", "96x54",
                     "--profile-frames", "2", "-o", "w", "--trace", "t.json", "--json", "-"},
                    folder)));
    const ReadTrace read = trace();
    const std::vector<ReadSpan> asked = read.of("pass,cpu");
    const std::vector<ReadSpan> done = read.of("pass,gpu");
    ASSERT_EQ(asked.size(), done.size());
    ASSERT_FALSE(asked.empty());
    const auto total_ns = [](const std::vector<ReadSpan>& spans) {
        double sum = 0.0;
        for (const ReadSpan& span : spans)
            sum += static_cast<double>(span.end_ns - span.begin_ns);
        return sum;
    };
    // A pass begins where the one before has ended, so that nothing but the time between two calls is left.
    EXPECT_GT(total_ns(done), 0.8 * total_ns(read.of("frame,gpu")));
    const std::vector<ReadSpan> frames = read.of("frame,cpu");
    for (std::size_t i = 0; i < done.size(); ++i) {
        EXPECT_EQ(done[i].name, asked[i].name);
        EXPECT_GE(done[i].end_ns, asked[i].begin_ns) << done[i].name << ": ended before it was asked for";
        EXPECT_GE(done[i].begin_ns, frames[done[i].args["frame"].get<std::size_t>()].begin_ns);
        // Another clock's zero would be off by the machine's uptime. What a frame of 96x54 takes is 1000
        // times shorter than this, on a machine however loaded.
        EXPECT_LT(done[i].begin_ns - asked[i].begin_ns, 60'000'000'000) << done[i].name;
    }
    EXPECT_NE(read.of("frame,gpu")[0].track, frames[0].track);
    EXPECT_EQ(read.track_names.at(read.of("frame,gpu")[0].track), "GPU");
    EXPECT_EQ(read.track_names.at(frames[0].track), "render");
}

TEST_F(TraceProgram, ASimulationAloneHasStepsOnly) {
    static_cast<void>(json(rambla(
        {"walk", "--no-render", "--steps", "20", "--scene", k_small_city, "--trace", "t.json", "--json", "-"},
        folder)));
    const ReadTrace read = trace();
    EXPECT_EQ(read.of("step").size(), 20u);
    EXPECT_EQ(read.of("system").size(), 20u * systems(0).size());
    EXPECT_EQ(read.spans.size(), 20u * (1u + systems(0).size()));
}

TEST_F(TraceProgram, ATraceThatCannotBeWrittenIsOneLine) {
    write_file(folder / "letter", "not a folder");
    expect_refused({"walk", "--headless", "-o", "w", "--trace", "letter/t.json"},
                   "letter/t.json: cannot be written: Not a directory");
    EXPECT_FALSE(fs::exists(folder / "w")) << "known before the work";
    expect_refused(
        {"walk", "--no-render", "--quiet", "--steps", "2", "--scene", k_small_city, "--trace", "/dev/full"},
        "/dev/full: cannot be written: No space left on device");
    expect_refused({"walk", "--compare", "--trace", "t.json"}, "--trace");
    expect_refused({"view", "a.glb", "b.glb", "--trace", "t.json"}, "--trace is for one file");
}

TEST_F(TraceProgram, AModelsPictureIsOneLookAndOneFrame) {
    ASSERT_EQ(rambla({"generate", k_small_city, "-o", "c.glb", "--quiet"}, folder).exit_code, 0);
    static_cast<void>(json(rambla({"view", "c.glb", "--headless", "--out", "p.png", "--size", "96x54",
                                   "--trace", "t.json", "--json", "-"},
                                  folder)));
    const ReadTrace read = trace();
    EXPECT_EQ(read.of("look").size(), 1u);
    EXPECT_EQ(read.of("frame,gpu").size(), 1u);
    EXPECT_EQ(read.of("step").size(), 0u);
    EXPECT_EQ(ReadTrace::counts(read.of("pass,cpu")), ReadTrace::counts(read.of("pass,gpu")));
    EXPECT_EQ(ReadTrace::counts(read.of("pass,gpu"))["tonemap"], 1u);
}

}  // namespace
}  // namespace rambla::system_test
