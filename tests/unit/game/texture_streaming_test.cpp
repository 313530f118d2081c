#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "assets/cache/cached_process.h"
#include "game/camera_path.h"
#include "game/scene_cache.h"
#include "game/stage.h"
#include "render/render_thread.h"
#include "systems/frame.h"
#include "systems/look/texture_uses.h"

namespace rambla::game {
namespace {

/// A stage and a thread that draws it.
struct Walk {
    explicit Walk(const std::string& scene) : stage{make_stage(scene, 1, {}, {})} {
        settings.shadows.size_texels = 512;
    }

    /// As the program does it. @return  bytes of all levels of all textures
    std::uint64_t stream() {
        PreparedScene prepared = prepare_scene(*stage.scene, thread.device(), true);
        std::uint64_t bytes = 0;
        for (const assets::TextureData& image : prepared.scene->images) {
            for (const assets::TextureLevel& level : image.levels)
                bytes += level.size;
        }
        hand_over(std::move(prepared), stage, thread);
        return bytes;
    }

    /// All levels at once, for good.
    void upload_whole() {
        assets::Cache cache{cache_folder(), k_cache_limit_bytes};
        assets::ProcessParameters parameters;
        if (!thread.device().block_compression) parameters.textures.compression = assets::Compression::off;
        thread.upload(stage.scene, std::make_shared<const assets::ProcessedScene>(
                                       assets::process_cached(*stage.scene, parameters, cache).scene));
    }

    render::FrameOutput draw(float share, bool complete) {
        render::FrameInput& input = thread.begin();
        systems::Eye eye = walk_eye(stage, share * duration_s(stage.walk));
        eye.size_px = {160, 90};
        systems::build_frame(*stage.world, eye, 1.0f, input.frame);
        demand = input.frame.texture_demand;
        input.settings = settings;
        input.complete_textures = complete;
        input.frame.capture.display = true;
        thread.submit();
        thread.finish();
        return std::move(thread.collect().at(0));
    }

    Stage stage;
    render::Settings settings;
    std::vector<std::uint8_t> demand;  ///< of the last frame
    render::RenderThread thread{
        {.window = {}, .shaders = {}, .gl_errors_throw = true, .compile_ahead = false, .compile_for = {}}};
};

double mean_byte(const assets::Image& image) {
    double sum = 0.0;
    for (const std::byte byte : image.texels)
        sum += std::to_integer<int>(byte);
    return sum / static_cast<double>(image.texels.size());
}

TEST(TextureStreaming, PicturesAreThoseOfWholeTexturesByteByByte) {
    const std::string scene = "city:blocks=1x1,walkers=6,cars=2";
    Walk whole{scene}, streamed{scene};
    whole.upload_whole();
    const std::uint64_t bytes = streamed.stream();
    systems::TextureFeedback textures;
    for (int i = 0; i <= 4; ++i) {
        const float share = static_cast<float>(i) / 4.0f;
        const render::FrameOutput picture = streamed.draw(share, true);
        ASSERT_EQ(picture.display->texels, whole.draw(share, true).display->texels) << i;
        textures = picture.feedback.textures;
        EXPECT_EQ(textures.below_demand, 0u);
    }
    EXPECT_LT(textures.resident_bytes, bytes) << "some levels are never sampled";
}

TEST(TextureStreaming, ATenthOfTheTexturesIsEnoughToGoOnDrawing) {
    Walk walk{"street"};
    const std::uint64_t budget = walk.stream() / 10;
    walk.settings.textures.budget_mib = static_cast<float>(static_cast<double>(budget) / 1048576.0);
    walk.settings.textures.upload_mib = 1.0f;
    constexpr int k_frames = 40;
    std::uint64_t loads = 0;
    for (int i = 0; i < k_frames; ++i) {
        const render::FrameOutput output = walk.draw(static_cast<float>(i) / (k_frames - 1.0f), i % 4 == 3);
        const systems::TextureFeedback& textures = output.feedback.textures;
        ASSERT_LE(textures.resident_bytes, budget) << i;
        ASSERT_LE(textures.peak_bytes, budget) << i;
        ASSERT_TRUE(output.display.has_value());
        // A street at noon: far from black, and not washed out either.
        EXPECT_GT(mean_byte(*output.display), 30.0) << i;
        EXPECT_LT(mean_byte(*output.display), 230.0) << i;
        loads = textures.loads;
    }
    EXPECT_GT(std::count_if(walk.demand.begin(), walk.demand.end(),
                            [](std::uint8_t level) { return level != systems::k_not_demanded; }),
              5);
    EXPECT_GT(loads, 10u);
}

}  // namespace
}  // namespace rambla::game
