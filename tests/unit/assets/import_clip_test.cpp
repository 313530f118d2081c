#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "assets/import/gltf_keys.h"
#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinity = std::numeric_limits<float>::infinity();

/// One channel of node 0, from accessors 0 (times) and 1 (values).
std::string animated(const std::string& path, const std::string& interpolation = "LINEAR",
                     const std::string& nodes = "{}") {
    return R"(,"nodes":[)" + nodes + R"(],"animations":[{"name":"move","channels":[{"sampler":0,"target":)" +
           R"({"node":0,"path":")" + path + R"("}}],"samplers":[{"input":0,"output":1,"interpolation":")" +
           interpolation + R"("}]}])";
}

Draft draft_of(const std::vector<float>& times, const std::vector<float>& values, const std::string& type) {
    Draft draft;
    draft.add(times, "SCALAR");
    draft.add(values, type);
    return draft;
}

TEST(GltfClips, EachInterpolationOfEachPathIsRead) {
    const LogCapture log;
    const Scene moved =
        draft_of({0, 0.5f, 2}, {1, 2, 3, 4, 5, 6, 7, 8, 9}, "VEC3").load(animated("translation"));
    ASSERT_EQ(moved.clips.size(), 1u);
    EXPECT_EQ(moved.clips[0].name, "move");
    EXPECT_EQ(moved.clips[0].duration_s, 2.0f);
    const Channel& channel = moved.clips[0].channels.at(0);
    EXPECT_EQ(channel.node, 0u);
    EXPECT_EQ(channel.path, AnimatedPath::translation);
    EXPECT_EQ(channel.interpolation, Interpolation::linear);
    EXPECT_EQ(channel.width, 3u);
    EXPECT_THAT(channel.times_s, ElementsAre(0, 0.5f, 2));
    EXPECT_THAT(channel.values, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));

    const Channel scaled =
        draft_of({1}, {1, 2, 3}, "VEC3").load(animated("scale", "STEP")).clips[0].channels.at(0);
    EXPECT_EQ(scaled.path, AnimatedPath::scale);
    EXPECT_EQ(scaled.interpolation, Interpolation::step);

    const Channel turned = draft_of({0, 1}, {9, 9, 9, 9, 0, 0, 0, 1, 8, 8, 8, 8,  //
                                             7, 7, 7, 7, 1, 0, 0, 0, 6, 6, 6, 6},
                                    "VEC4")
                               .load(animated("rotation", "CUBICSPLINE"))
                               .clips[0]
                               .channels.at(0);
    EXPECT_EQ(turned.interpolation, Interpolation::cubic_spline);
    EXPECT_EQ(turned.width, 4u);
    EXPECT_EQ(turned.values.size(), 24u);
    EXPECT_EQ(turned.values[4 + 3], 1.0f);
    EXPECT_EQ(turned.values[0], 9.0f);
    EXPECT_EQ(log.text(), "");
}

TEST(GltfClips, NormalisedIntegersBecomeFloats) {
    Draft draft;
    draft.add<float>({0, 1}, "SCALAR");
    draft.add<std::int16_t>({0, 0, 0, 32767, 32767, 0, 0, 0}, "VEC4", R"(,"normalized":true)");
    const Channel turned = draft.load(animated("rotation")).clips[0].channels.at(0);
    EXPECT_THAT(turned.values, ElementsAre(0, 0, 0, 1, 1, 0, 0, 0));
}

TEST(GltfClips, WeightsHaveOneNumberForEachMorphTarget) {
    Draft draft;
    draft.add<float>({0, 1}, "SCALAR");
    draft.add<std::uint8_t>({255, 0, 51, 102}, "SCALAR", R"(,"normalized":true)");
    draft.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    const std::string mesh =
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":2},"targets":[{"POSITION":2},{"POSITION":2}]}]}])";
    const Channel channel =
        draft.load(animated("weights", "LINEAR", R"({"mesh":0})") + mesh).clips[0].channels.at(0);
    EXPECT_EQ(channel.path, AnimatedPath::weights);
    EXPECT_EQ(channel.width, 2u);
    EXPECT_THAT(channel.values, ElementsAre(1, 0, 0.2f, 0.4f));
    // Instances take the mesh, but the weights still belong to the node.
    const LogCapture log;
    const Scene without = draft.load(animated("weights", "LINEAR"));
    EXPECT_THAT(without.clips[0].channels, IsEmpty());
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), HasSubstr("1 channels for nodes without morph targets"));
}

TEST(GltfClips, BrokenKeysAreMendedWithOneWarning) {
    const LogCapture log;
    const Scene scene =
        draft_of({3, 1, 1, k_nan, -1, 2, 2}, {30, 0, 0, 10,         0, 0, 11, 0, 0, 5, 5, 5, 6, 6, 6,  //
                                              20, 0, 0, k_infinity, 0, 0},
                 "VEC3")
            .load(animated("translation"));
    const Channel& channel = scene.clips[0].channels.at(0);
    ASSERT_EQ(channel.times_s.size(), 4u);
    EXPECT_EQ(channel.times_s[0], 1.0f);
    EXPECT_GT(channel.times_s[1], 1.0f);
    EXPECT_LT(channel.times_s[1], 1.00001f);
    EXPECT_EQ(channel.times_s[2], 2.0f);
    EXPECT_EQ(channel.times_s[3], 3.0f);
    EXPECT_THAT(channel.values, ElementsAre(10, 0, 0, 11, 0, 0, 20, 0, 0, 30, 0, 0));
    EXPECT_EQ(scene.clips[0].duration_s, 3.0f);
    EXPECT_EQ(log.lines(), 1);
    EXPECT_THAT(log.text(), AllOf(HasSubstr("animations[0]: mended: 1 keys repeat the time before them"),
                                  HasSubstr("1 keys are out of order"), HasSubstr("3 keys are no finite")));
}

TEST(GltfClips, ChannelsThatCannotPlayAreLeftOutWithOneWarning) {
    const LogCapture log;
    Draft draft = draft_of({0}, {1, 2, 3}, "VEC3");
    draft.add_text(R"({"componentType":5126,"count":0,"type":"SCALAR"})");
    draft.add_text(R"({"componentType":5126,"count":0,"type":"VEC3"})");
    const Scene scene = draft.load(
        R"(,"nodes":[{},{}],"animations":[{"samplers":[{"input":0,"output":1},{"input":2,"output":3}],"channels":[)"
        R"({"sampler":0,"target":{"node":0,"path":"translation"}},)"
        R"({"sampler":0,"target":{"node":0,"path":"translation"}},)"
        R"({"sampler":0,"target":{"node":0,"path":"colour"}},{"sampler":1,"target":{"node":1,"path":"scale"}}]},{}])");
    ASSERT_EQ(scene.clips.size(), 2u);
    EXPECT_EQ(scene.clips[0].channels.size(), 1u);
    EXPECT_THAT(scene.clips[1].channels, IsEmpty());
    EXPECT_EQ(scene.clips[1].duration_s, 0.0f);
    EXPECT_EQ(log.lines(), 2);
    EXPECT_THAT(log.text(), AllOf(HasSubstr("animations[0]: mended: "), HasSubstr("known path"),
                                  HasSubstr("another one moves"), HasSubstr("without keys"),
                                  HasSubstr("animations[1]: moves nothing")));
}

TEST(GltfClips, RotationsAreMadeUnitLength) {
    const LogCapture log;
    const Channel channel = draft_of({0, 1, 2}, {0, 0, 0, 2, 0, 0, 0, 0, 0, 1.001f, 0, 0}, "VEC4")
                                .load(animated("rotation"))
                                .clips[0]
                                .channels.at(0);
    EXPECT_THAT(channel.times_s, ElementsAre(0, 2));
    EXPECT_THAT(channel.values, ElementsAre(0, 0, 0, 1, 0, 1, 0, 0));
    EXPECT_THAT(log.text(),
                AllOf(HasSubstr("1 rotations are not of unit length"), HasSubstr("1 keys are no")));
}

TEST(GltfClips, ReferencesAndFormsThatDoNotFitAreRefused) {
    Draft draft = draft_of({0, 1}, {1, 2, 3, 4, 5, 6}, "VEC3");
    draft.add<std::uint16_t>({0, 1}, "SCALAR");
    EXPECT_EQ(draft.error(animated("translation")), "");
    EXPECT_THAT(draft.error(animated("rotation")),
                HasSubstr("animations[0].samplers[0].output: 3 components, expected 4"));
    EXPECT_THAT(draft.error(animated("translation", "CUBICSPLINE")),
                HasSubstr("output: 2 elements, expected 3 for each of 2 keys"));
    EXPECT_THAT(draft.error(animated("translation", "SMOOTH")), HasSubstr("interpolation: \"SMOOTH\""));
    const auto error = [&](const std::string& channel, const std::string& sampler) {
        return draft.error(R"(,"nodes":[{}],"animations":[{"channels":[)" + channel + R"(],"samplers":[)" +
                           sampler + "]}]");
    };
    const std::string channel = R"({"sampler":0,"target":{"node":0,"path":"translation"}})";
    EXPECT_THAT(error(channel, R"({"input":2,"output":1})"), HasSubstr("samplers[0].input"));
    EXPECT_THAT(error(channel, R"({"input":1,"output":1})"), HasSubstr("input: 3 components"));
    EXPECT_THAT(error(channel, R"({"input":0,"output":8})"), HasSubstr("samplers[0].output: accessor 8"));
    EXPECT_THAT(error(channel, R"({"input":-3,"output":1})"),
                HasSubstr("samplers[0].input: -3, expected a whole number"));
    EXPECT_THAT(error(R"({"sampler":4,"target":{"node":0,"path":"scale"}})", R"({"input":0,"output":1})"),
                HasSubstr("channels[0].sampler: sampler 4"));
    EXPECT_THAT(error(R"({"sampler":0,"target":{"node":5,"path":"scale"}})", R"({"input":0,"output":1})"),
                HasSubstr("channels[0].target.node: node 5"));
}

TEST(GltfClips, ManyChannelsOfTheSameKeysCannotFillTheMemory) {
    Draft draft;
    draft.add_text(R"({"componentType":5126,"count":60000,"type":"SCALAR"})");
    draft.add_text(R"({"componentType":5126,"count":60000,"type":"VEC3"})");
    std::string channels;
    std::string nodes;
    for (int n = 0; n < 8; ++n) {
        channels.append(n > 0 ? "," : "").append(R"({"sampler":0,"target":{"path":"scale","node":)");
        channels.append(std::to_string(n)).append("}}");
        nodes.append(n > 0 ? ",{}" : "{}");
    }
    EXPECT_THAT(draft.error(R"(,"nodes":[)" + nodes + R"(],"animations":[{"channels":[)" + channels +
                            R"(],"samplers":[{"input":0,"output":1}]}])"),
                HasSubstr("more vertices, indices or particles"));
}

Channel channel_of(std::vector<float> times, std::vector<float> values) {
    return {
        .path = AnimatedPath::weights, .width = 1, .times_s = std::move(times), .values = std::move(values)};
}

TEST(GltfKeys, RepeatedTimesKeepAJumpWhereThereIsRoom) {
    Channel jump = channel_of({0, 1, 1, 1, 2}, {0, 1, 2, 3, 4});
    EXPECT_EQ(gltf::mend_keys(jump).repeated, 2u);
    EXPECT_THAT(jump.values, ElementsAre(0, 1, 3, 4));
    Channel equal = channel_of({0, 1, 1, 2}, {0, 1, 1, 2});
    gltf::mend_keys(equal);
    EXPECT_THAT(equal.times_s, ElementsAre(0, 1, 2));
    Channel tight = channel_of({1, 1, std::nextafter(1.0f, 2.0f)}, {0, 1, 2});
    gltf::mend_keys(tight);
    EXPECT_THAT(tight.values, ElementsAre(1, 2));
    Channel last = channel_of({1e30f, 1e30f}, {0, 1});
    gltf::mend_keys(last);
    EXPECT_GT(last.times_s[1], last.times_s[0]);
    Channel sound = channel_of({0, 1}, {5, 5});
    EXPECT_FALSE(gltf::mend_keys(sound).any());
    EXPECT_THAT(sound.times_s, ElementsAre(0, 1));
}

}  // namespace
}  // namespace rambla::assets::test
