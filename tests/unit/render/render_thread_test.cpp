#include "render/render_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "render/gl/context.h"
#include "render/gl/object.h"
#include "support/texture_levels.h"

namespace rambla::render {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RenderThreadOptions quick() {
    RenderThreadOptions options;
    options.gl_errors_throw = true;
    options.compile_ahead = false;
    return options;
}

/// An empty world under a grey sky.
void fill(FrameInput& input, std::uint64_t number, glm::uvec2 size = {16, 8}) {
    input = {};
    systems::Frame& frame = input.frame;
    frame.number = number;
    frame.view.size_px = size;
    frame.view.clip_from_view = glm::mat4{0.0f};
    frame.view.clip_from_view[0].x = 1.0f;
    frame.view.clip_from_view[1].y = 1.0f;
    frame.view.clip_from_view[2].w = -1.0f;
    frame.view.clip_from_view[3].z = 0.1f;
    frame.environment.sky_horizon_radiance = glm::vec3{0.5f};
    frame.environment.sky_zenith_radiance = glm::vec3{0.5f};
    frame.environment.ground_radiance = glm::vec3{0.5f};
}

std::vector<std::uint64_t> numbers_of(const std::vector<FrameOutput>& outputs) {
    std::vector<std::uint64_t> numbers;
    for (const FrameOutput& output : outputs)
        numbers.push_back(output.feedback.frame);
    return numbers;
}

TEST(RenderThread, HandsOutTwoSlotsInTurns) {
    RenderThread thread{quick()};
    std::vector<const FrameInput*> slots;
    for (std::uint64_t i = 0; i < 4; ++i) {
        FrameInput& input = thread.begin();
        slots.push_back(&input);
        fill(input, i);
        thread.submit();
    }
    EXPECT_NE(slots[0], slots[1]);
    EXPECT_EQ(slots[0], slots[2]);
    EXPECT_EQ(slots[1], slots[3]);
}

TEST(RenderThread, DrawsEverythingInOrderBeforeFinishReturns) {
    RenderThread thread{quick()};
    for (std::uint64_t i = 0; i < 5; ++i) {
        fill(thread.begin(), i);
        thread.submit();
    }
    thread.finish();
    EXPECT_THAT(numbers_of(thread.collect()), ElementsAre(0, 1, 2, 3, 4));
    EXPECT_TRUE(thread.collect().empty()) << "each output is handed out once";
}

TEST(RenderThread, DeliversOutputsWithoutFurtherFrames) {
    RenderThread thread{quick()};
    fill(thread.begin(), 7);
    thread.submit();
    std::vector<FrameOutput> outputs;
    // Generous: compiling on a busy machine may take seconds.
    for (int i = 0; i < 3000 && outputs.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
        outputs = thread.collect();
    }
    EXPECT_THAT(numbers_of(outputs), ElementsAre(7));
}

TEST(RenderThread, ReturnsCapturesOfTheFramesThatAskedForThem) {
    RenderThread thread{quick()};
    for (std::uint64_t i = 0; i < 3; ++i) {
        FrameInput& input = thread.begin();
        fill(input, i, {5, 3});  // rows of no round size
        input.settings.exposure.ev = 2.0f;
        input.frame.capture = {.display = i == 1, .linear = i == 1};
        thread.submit();
    }
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    ASSERT_EQ(outputs.size(), 3u);
    EXPECT_FALSE(outputs[0].display.has_value());
    EXPECT_FALSE(outputs[2].linear.has_value());
    ASSERT_TRUE(outputs[1].display.has_value());
    ASSERT_TRUE(outputs[1].linear.has_value());
    EXPECT_EQ(outputs[1].display->texels.size(), 5u * 3u * 4u);
    EXPECT_EQ(outputs[1].linear->texels.size(), 5u * 3u * 16u);
    EXPECT_EQ(outputs[1].linear->width, 5u);
    EXPECT_EQ(outputs[1].linear->height, 3u);
}

TEST(RenderThread, TakesExposureOutOfLinearCaptures) {
    RenderThread thread{quick()};
    for (const float exposure : {0.0f, 3.0f}) {
        FrameInput& input = thread.begin();
        fill(input, 0);
        input.settings.exposure.ev = exposure;
        input.frame.capture.linear = true;
        thread.submit();
    }
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    ASSERT_EQ(outputs.size(), 2u);
    const auto* one = reinterpret_cast<const float*>(outputs[0].linear->texels.data());
    const auto* other = reinterpret_cast<const float*>(outputs[1].linear->texels.data());
    EXPECT_GT(one[0], 0.0f);
    // Scaling by a power of two is exact in every float, so the pictures agree to half a float's last place.
    for (std::size_t i = 0; i < 16u * 8u * 4u; ++i)
        ASSERT_NEAR(one[i], other[i], one[i] / 1024.0f);
}

TEST(RenderThread, SurvivesSizesOfNothingAndOfOnePixel) {
    RenderThread thread{quick()};
    for (const glm::uvec2 size : {glm::uvec2{0, 0}, glm::uvec2{1, 1}, glm::uvec2{0, 7}, glm::uvec2{3, 5}}) {
        FrameInput& input = thread.begin();
        fill(input, 0, size);
        input.frame.capture.display = true;
        thread.submit();
    }
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    ASSERT_EQ(outputs.size(), 4u);
    EXPECT_FALSE(outputs[0].display.has_value());
    EXPECT_EQ(outputs[1].display->texels.size(), 4u);
    EXPECT_EQ(outputs[3].display->texels.size(), 3u * 5u * 4u);
}

TEST(RenderThread, DrawsTheGraphAndTimesPassesOnRequest) {
    RenderThread thread{quick()};
    FrameInput& input = thread.begin();
    fill(input, 0);
    input.draw_graph = true;
    input.timers = PassTimers::alone;
    thread.submit();
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    ASSERT_EQ(outputs.size(), 1u);
    EXPECT_THAT(outputs[0].graph_svg, HasSubstr("tonemap"));
    EXPECT_FALSE(outputs[0].feedback.passes.empty());
    EXPECT_GT(outputs[0].feedback.gpu_frame_ms, 0.0);
}

TEST(RenderThread, HoldsNoMoreAfterHundredFramesThanAfterTwenty) {
    RenderThread thread{quick()};
    for (std::uint64_t i = 0; i < 100; ++i) {
        fill(thread.begin(), i);
        thread.submit();
    }
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    ASSERT_EQ(outputs.size(), 100u);
    EXPECT_EQ(outputs[99].feedback.gl_objects, outputs[20].feedback.gl_objects);
    EXPECT_EQ(outputs[99].feedback.gpu_memory_bytes, outputs[20].feedback.gpu_memory_bytes);
}

TEST(RenderThread, ReturnsEveryGlObjectWhenItEnds) {
    const gl::LiveCounts before = gl::live_counts();
    {
        RenderThread thread{quick()};
        fill(thread.begin(), 0);
        thread.submit();
        thread.finish();
        EXPECT_GT(gl::live_counts().objects, before.objects);
    }
    EXPECT_EQ(gl::live_counts().objects, before.objects);
    EXPECT_EQ(gl::live_counts().bytes, before.bytes);
}

TEST(RenderThread, CarriesTheFailureOfItsShadersToTheNextCalls) {
    RenderThreadOptions options = quick();
    options.shaders = [](const std::string&) -> std::string {
        throw std::runtime_error("the disk is gone");
    };
    RenderThread thread{options};
    try {
        thread.finish();
        for (int i = 0; i < 3; ++i) {  // whichever call comes after the failure
            fill(thread.begin(), 0);
            thread.submit();
        }
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("the disk is gone"));
    }
    EXPECT_THROW(static_cast<void>(thread.collect()), std::runtime_error) << "a failure stays";
}

TEST(RenderThread, CarriesTheFailureOfAWindowsContext) {
    RenderThreadOptions options = quick();
    options.window.make_current = [] {
        throw MissingFeature("no window today");
    };
    RenderThread thread{options};
    const auto draw_three = [&] {  // the third must wait for the first, or for the failure
        for (std::uint64_t i = 0; i < 3; ++i) {
            fill(thread.begin(), i);
            thread.submit();
        }
    };
    EXPECT_THROW(draw_three(), MissingFeature);
}

TEST(RenderThread, EndsInPeaceWithFramesUndrawn) {
    RenderThread thread{quick()};
    fill(thread.begin(), 0);
    thread.submit();
    fill(thread.begin(), 1);
    thread.submit();
}

TEST(RenderThread, KeepsDrawingWithTheOldProgramsWhenAReloadFails) {
    auto broken = std::make_shared<std::atomic<bool>>(false);
    RenderThreadOptions options = quick();
    options.shaders = [broken](const std::string& path) {
        return embedded_shader(path) + (*broken && path == "tonemap.frag.glsl" ? "\nmistake\n" : "");
    };
    RenderThread thread{options};
    fill(thread.begin(), 0);
    thread.submit();
    thread.finish();
    *broken = true;
    for (const bool reload : {true, false}) {
        FrameInput& input = thread.begin();
        fill(input, 1);
        input.reload_shaders = reload;
        input.frame.capture.display = true;
        thread.submit();
    }
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    ASSERT_EQ(outputs.size(), 3u);
    EXPECT_THAT(outputs[1].shader_error, HasSubstr("tonemap.frag.glsl:"));
    EXPECT_EQ(outputs[2].shader_error, "");
    EXPECT_TRUE(outputs[2].display.has_value());
}

/// Hands over a scene of one image whose finer levels come from the source that is returned.
std::shared_ptr<tests::TestLevels> upload_image(
    RenderThread& thread,
    assets::TextureSlot assets::Material::*slot = &assets::Material::base_colour_texture) {
    const std::vector<assets::TextureData> images{tests::noise_texture(256, 256, 1)};
    auto source = std::make_shared<tests::TestLevels>(images);
    auto processed = std::make_shared<assets::ProcessedScene>();
    processed->images = tests::floors_of(images);
    processed->textures.push_back({.name = "", .image = 0, .sampler = {}});
    (processed->materials.emplace_back().*slot).texture = 0;
    thread.upload(std::make_shared<assets::Scene>(), processed, source);
    return source;
}

void fill_textured(FrameInput& input, std::uint64_t number) {
    fill(input, number);
    input.frame.texture_demand = {0};
}

TEST(RenderThread, NoFrameWaitsForLevelsOfTextures) {
    RenderThread thread{quick()};
    const std::shared_ptr<tests::TestLevels> source = upload_image(thread);
    source->allow(0);
    for (std::uint64_t i = 0; i < 6; ++i) {
        fill_textured(thread.begin(), i);
        thread.submit();
    }
    thread.finish();
    std::vector<FrameOutput> outputs = thread.collect();
    EXPECT_THAT(numbers_of(outputs), ElementsAre(0, 1, 2, 3, 4, 5));
    for (const FrameOutput& output : outputs) {
        EXPECT_EQ(output.feedback.textures.pending_loads, 1u);
        EXPECT_EQ(output.feedback.textures.below_demand, 1u);
    }
    source->allow(1);
    fill_textured(thread.begin(), 6);
    thread.submit();
    thread.finish();
    outputs = thread.collect();
    EXPECT_EQ(outputs.at(0).feedback.textures.below_demand, 0u);
    EXPECT_EQ(outputs.at(0).feedback.textures.loads, 1u);
    EXPECT_EQ(outputs.at(0).feedback.gl_objects, gl::live_counts().objects)
        << "the texture that was replaced is gone when the frame is drawn";
}

TEST(RenderThread, LoadsNoTexturesThatTheGradeOfDetailDoesNotSample) {
    const struct {
        assets::TextureSlot assets::Material::*slot;
        DetailGrade grade;
        std::uint64_t loads;
    } cases[] = {{&assets::Material::base_colour_texture, DetailGrade::flat, 1},
                 {&assets::Material::normal_texture, DetailGrade::flat, 0},
                 {&assets::Material::normal_texture, DetailGrade::normal, 1},
                 {&assets::Material::height_texture, DetailGrade::normal, 0},
                 {&assets::Material::height_texture, DetailGrade::parallax, 1},
                 {&assets::Material::height_texture, DetailGrade::occlusion, 1}};
    for (const auto& test : cases) {
        RenderThread thread{quick()};
        const std::shared_ptr<tests::TestLevels> source = upload_image(thread, test.slot);
        source->allow(1);
        FrameInput& input = thread.begin();
        fill_textured(input, 0);
        input.complete_textures = true;
        input.settings.detail.grade = test.grade;
        thread.submit();
        thread.finish();
        const systems::TextureFeedback found = thread.collect().at(0).feedback.textures;
        EXPECT_EQ(found.loads, test.loads) << static_cast<int>(test.grade);
        EXPECT_EQ(found.below_demand, 0u) << static_cast<int>(test.grade);
    }
}

TEST(RenderThread, APictureThatIsKeptWaitsForItsTextures) {
    RenderThread thread{quick()};
    const std::shared_ptr<tests::TestLevels> source = upload_image(thread);
    source->allow(0);
    FrameInput& input = thread.begin();
    fill_textured(input, 0);
    input.complete_textures = true;
    thread.submit();
    fill_textured(thread.begin(), 1);  // the other slot is free meanwhile
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    EXPECT_TRUE(thread.collect().empty());
    source->allow(1);
    thread.submit();
    thread.finish();
    const std::vector<FrameOutput> outputs = thread.collect();
    EXPECT_THAT(numbers_of(outputs), ElementsAre(0, 1));
    EXPECT_EQ(outputs[0].feedback.textures.below_demand, 0u);
}

TEST(RenderThread, EndsInPeaceWithLoadsPending) {
    for (const bool waiting : {false, true}) {
        RenderThread thread{quick()};
        const std::shared_ptr<tests::TestLevels> source = upload_image(thread);
        source->allow(0);
        FrameInput& input = thread.begin();
        fill_textured(input, 0);
        input.complete_textures = waiting;
        thread.submit();
        for (int i = 0; i < 3000 && source->asked() == 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds{10});
        EXPECT_EQ(source->asked(), 1u);
    }
}

}  // namespace
}  // namespace rambla::render
