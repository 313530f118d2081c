#include "game/caption.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "render/post/hud.h"

namespace rambla::game {
namespace {

render::HudDrawData drawn(CaptionWriter& writer, const std::string& words, glm::uvec2 picture_px) {
    return *std::static_pointer_cast<const render::HudDrawData>(writer.written(words, picture_px));
}

glm::vec4 box_of(const render::HudDrawData& hud) {
    glm::vec4 box{1e9f, 1e9f, -1e9f, -1e9f};
    for (const render::HudDrawData::Vertex& vertex : hud.vertices) {
        box = {glm::min(glm::vec2{box}, vertex.position_px),
               glm::max(glm::vec2{box.z, box.w}, vertex.position_px)};
    }
    return box;
}

TEST(Caption, StandsAtTheLowerLeft) {
    CaptionWriter writer;
    const render::HudDrawData hud = drawn(writer, "Box.glb", {320, 240});
    const glm::vec4 box = box_of(hud);
    EXPECT_EQ(hud.size_px, glm::vec2(320.0f, 240.0f));
    EXPECT_EQ(box.x, 0.0f);
    EXPECT_EQ(box.w, 240.0f);
    EXPECT_LT(box.z, 100.0f);
    EXPECT_GT(box.y, 200.0f) << "one line";
    // A rectangle behind a quad for each of the seven characters.
    EXPECT_EQ(hud.indices.size(), 6u * 8u);
}

TEST(Caption, LongWordsTakeMoreLinesAndStayInThePicture) {
    CaptionWriter writer;
    const glm::vec4 box = box_of(drawn(writer, std::string(150, 'w').append(" end"), {320, 240}));
    EXPECT_LT(box.y, 200.0f);
    EXPECT_LE(box.z, 320.0f);
    EXPECT_LE(box.w, 240.0f);
}

TEST(Caption, MayBeWrittenAgainInAnotherSize) {
    CaptionWriter writer;
    static_cast<void>(drawn(writer, "first", {320, 240}));
    EXPECT_EQ(box_of(drawn(writer, "second", {100, 50})).w, 50.0f);
}

}  // namespace
}  // namespace rambla::game
