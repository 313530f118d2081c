#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "system/program.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Starts walks with a cache of the test's own.
struct CacheProgram : testing::Test {
    ScratchFolder scratch;
    fs::path cache = scratch.path() / "made" / "cache";

    /// A folder for the walk's frames, and for what it prints.
    fs::path folder(const std::string& name) {
        fs::create_directories(scratch.path() / name);
        return scratch.path() / name;
    }
    Process start(const fs::path& into) {
        return Process{
            {RAMBLA_PROGRAM, "walk", "--headless", "--scene", "city:blocks=1x1,walkers=3,cars=1", "--frames",
             "2", "--size", "160x90", "--profile-frames", "0", "-o", "w", "--json", "-"},
            {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"RAMBLA_CACHE_DIR", cache.string()}},
            into};
    }
    Ended walk(const fs::path& into) {
        Ended ended = start(into).wait(k_patience);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return ended;
    }
    static nlohmann::json json(const Ended& ended) { return nlohmann::json::parse(ended.out); }

    static void expect_same_frames(const fs::path& a, const fs::path& b) {
        for (const char* const frame : {"w/frame_0000.png", "w/frame_0001.png"}) {
            const std::string content = file_text(a / frame);
            EXPECT_FALSE(content.empty());
            EXPECT_TRUE(content == file_text(b / frame)) << frame << " of " << b;
        }
    }
};

TEST_F(CacheProgram, TheSecondStartProcessesNothingAndDrawsTheSameBytes) {
    const Ended first = walk(folder("first"));
    const nlohmann::json made = json(first);
    EXPECT_EQ(made["cache_hits"], 0);
    EXPECT_GT(made["cache_misses"].get<int>(), 10);
    EXPECT_GT(made["start_ms"]["processing"].get<double>(), 0.0);
    EXPECT_THAT(first.err, HasSubstr("(0 cache hits)"));

    const nlohmann::json loaded = json(walk(folder("second")));
    EXPECT_EQ(loaded["cache_misses"], 0);
    EXPECT_EQ(loaded["cache_hits"], made["cache_misses"]);
    EXPECT_EQ(loaded["state_hash"], made["state_hash"]);
    expect_same_frames(folder("first"), folder("second"));

    // Damage to every entry, of several kinds.
    int number = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator{cache}) {
        if (number % 3 == 0) fs::resize_file(entry.path(), entry.file_size() - 1);
        if (number % 3 == 1) write_file(entry.path(), "");
        if (number % 3 == 2) fs::remove(entry.path());
        ++number;
    }
    const nlohmann::json healed = json(walk(folder("third")));
    EXPECT_EQ(healed["cache_hits"], 0);
    EXPECT_EQ(healed["cache_misses"], made["cache_misses"]);
    expect_same_frames(folder("first"), folder("third"));
    EXPECT_EQ(json(walk(folder("fourth")))["cache_misses"], 0);
}

TEST_F(CacheProgram, TwoAtOnceShareTheFolderAndDrawTheSame) {
    Process one = start(folder("one"));
    Process other = start(folder("other"));
    EXPECT_EQ(one.wait(k_patience).exit_code, 0);
    EXPECT_EQ(other.wait(k_patience).exit_code, 0);
    expect_same_frames(folder("one"), folder("other"));
    EXPECT_EQ(json(walk(folder("later")))["cache_misses"], 0);
    for (const fs::directory_entry& entry : fs::directory_iterator{cache})
        EXPECT_EQ(entry.path().extension(), ".rambla") << "nothing unfinished stays";
}

TEST_F(CacheProgram, WithoutAFolderToWriteToItDrawsTheSameAfterOneWarning) {
    // Below a file there can be none, not even for those who may write everywhere.
    const Ended with = walk(folder("with"));
    write_file(scratch.path() / "file", "");
    cache = scratch.path() / "file" / "cache";
    const Ended without = walk(folder("without"));
    EXPECT_THAT(without.err, HasSubstr(cache.string()));
    EXPECT_THAT(with.err, Not(HasSubstr("not kept")));
    EXPECT_EQ(without.err.find("not kept"), without.err.rfind("not kept"));
    EXPECT_NE(without.err.find("not kept"), std::string::npos);
    expect_same_frames(folder("with"), folder("without"));
}

TEST_F(CacheProgram, SimulatingAloneProcessesNothing) {
    const Environment environment{{"DISPLAY", ""}, {"RAMBLA_CACHE_DIR", cache.string()}};
    const Ended ended = Process{{RAMBLA_PROGRAM, "walk", "--no-render", "--steps", "1", "--scene",
                                 "city:blocks=1x1,walkers=3,cars=1"},
                                environment,
                                scratch.path()}
                            .wait(k_patience);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_FALSE(fs::exists(cache));
}

TEST_F(CacheProgram, DoctorNamesTheFolderAndLeavesItAlone) {
    const auto doctor = [&](const Environment& environment) {
        const Ended ended =
            Process{{RAMBLA_PROGRAM, "doctor", "--json", "-"}, environment, scratch.path()}.wait(k_patience);
        EXPECT_THAT(ended.err, HasSubstr("of at most 2.0 GiB"));
        return json(ended);
    };
    const nlohmann::json own = doctor({{"RAMBLA_CACHE_DIR", cache.string()}});
    EXPECT_EQ(own["cache"]["folder"], cache.string());
    EXPECT_EQ(own["cache"]["bytes"], 0);
    EXPECT_EQ(own["cache"]["limit_bytes"], std::uint64_t{2} << 30);
    EXPECT_FALSE(fs::exists(cache));
    EXPECT_FALSE(own["block_compression_reason"].get<std::string>().empty());
    if (own["software"].get<bool>()) {
        EXPECT_FALSE(own["block_compression"].get<bool>());
    }
    fs::create_directories(cache);
    write_file(cache / "0123.rambla", "twelve bytes");
    EXPECT_EQ(doctor({{"RAMBLA_CACHE_DIR", cache.string()}})["cache"]["bytes"], 12);
    const nlohmann::json xdg =
        doctor({{"RAMBLA_CACHE_DIR", ""}, {"XDG_CACHE_HOME", scratch.path().string()}});
    EXPECT_EQ(xdg["cache"]["folder"], (scratch.path() / "rambla").string());
}

}  // namespace
}  // namespace rambla::system_test
