#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "system/pictures.h"
#include "system/program.h"
#include "system/sample_clips.h"

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct ViewedClip : testing::Test {
    ScratchFolder scratch;
    fs::path folder = scratch.path();

    void SetUp() override { write_clips(folder / "clips.glb"); }

    Ended view(std::vector<std::string> options) {
        std::vector<std::string> arguments{"view",   "clips.glb", "--headless", "--out",  "p.png",
                                           "--size", "96x72",     "--quiet",    "--json", "-"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return rambla(arguments, folder);
    }
    assets::Image shown(const std::vector<std::string>& options) {
        const Ended ended = view(options);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        json = nlohmann::json::parse(ended.out);
        return picture(folder / "p.png");
    }
    void expect_refused(const std::vector<std::string>& options, const std::string& named) {
        const Ended ended = view(options);
        EXPECT_EQ(ended.exit_code, 2) << ended.err;
        EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
        EXPECT_THAT(ended.err, HasSubstr(named));
    }

    nlohmann::json json;
};

TEST_F(ViewedClip, IsShownAtTheTimeAskedFor) {
    const assets::Image begin = shown({"--clip", "slide"});
    EXPECT_EQ(json["clip"], "slide");
    EXPECT_EQ(json["clip_time_s"], 0.0);
    EXPECT_EQ(json["clips"], 2);
    const assets::Image middle = shown({"--clip", "slide", "--clip-time", "1"});
    EXPECT_EQ(json["clip_time_s"], 1.0);
    EXPECT_GT(mean_difference(begin, middle), 2.0);
    EXPECT_EQ(mean_difference(middle, shown({"--clip", "0", "--clip-time", "-3"})), 0.0) << "it starts over";
    EXPECT_EQ(mean_difference(middle, shown({"--clip-time", "1"})), 0.0) << "the first clip, of itself";
    EXPECT_GT(mean_difference(begin, shown({"--clip", "spin", "--clip-time", "0.25"})), 0.3);
}

TEST_F(ViewedClip, IsNoneUnlessAskedFor) {
    static_cast<void>(shown({}));
    EXPECT_TRUE(json["clip"].is_null());
    EXPECT_TRUE(json["clip_time_s"].is_null());
    EXPECT_EQ(json["clips"], 2);
}

TEST_F(ViewedClip, MovesTheCameraThatHangsFromWhatItMoves) {
    write_ride(folder / "clips.glb");
    const assets::Image begin = shown({"--clip-time", "0"});
    const assets::Image end = shown({"--clip-time", "2"});
    // The camera starts in front of the white tile and ends in front of the black one.
    EXPECT_GT(byte_at(begin, 48, 36, 1), 200);
    EXPECT_LT(byte_at(end, 48, 36, 1), 60);
    EXPECT_EQ(mean_difference(begin, shown({})), 0.0) << "where the file has it";
}

TEST_F(ViewedClip, MustBeThere) {
    expect_refused({"--clip", "dance"}, "0 'slide', 1 'spin'");
    expect_refused({"--clip", "2"}, "0 'slide', 1 'spin'");
    expect_refused({"--clip-time", "soon"}, "soon");
    expect_refused({"--clip-time", "nan"}, "nan");
    ASSERT_EQ(rambla({"generate", "city:blocks=1x1,walkers=1,cars=0", "-o", "clips.glb", "--quiet"}, folder)
                  .exit_code,
              0);
    expect_refused({"--clip", "slide"}, "no clips");
    expect_refused({"--clip-time", "1"}, "no clips");
}

}  // namespace
}  // namespace rambla::system_test
