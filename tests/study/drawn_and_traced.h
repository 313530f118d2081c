#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "game/scene_cache.h"
#include "game/stage.h"
#include "game/study/frame_tracer.h"
#include "render/render_thread.h"
#include "systems/pipeline.h"

namespace rambla::game::study::test {

/// How far two pictures of object ids agree. Silhouettes are left out: pixels whose 3×3 neighbourhood in the
/// traced picture shows more than one object, or hangs over its rim. There, half a rounding decides.
struct Agreement {
    std::size_t inside = 0;        ///< pixels that are compared
    std::size_t wrong_inside = 0;  ///< of those
    std::size_t wrong = 0;         ///< of all pixels, silhouettes included
    std::size_t pixels = 0;
    std::size_t objects = 0;  ///< different ones inside
    glm::uvec2 first_wrong{0};

    [[nodiscard]] double wrong_inside_pct() const {
        return inside == 0 ? 100.0 : 100.0 * static_cast<double>(wrong_inside) / static_cast<double>(inside);
    }
    [[nodiscard]] double inside_pct() const {
        return 100.0 * static_cast<double>(inside) / static_cast<double>(pixels);
    }
    [[nodiscard]] double wrong_pct() const {
        return 100.0 * static_cast<double>(wrong) / static_cast<double>(pixels);
    }
};

[[nodiscard]] inline Agreement agreement(const std::vector<std::uint32_t>& traced,
                                         const render::ObjectImage& drawn) {
    const std::uint32_t width = drawn.width, height = drawn.height;
    Agreement result;
    result.pixels = traced.size();
    std::set<std::uint32_t> objects;
    const auto is_inside = [&](std::uint32_t x, std::uint32_t y) {
        if (x == 0 || y == 0 || x + 1 == width || y + 1 == height) return false;
        for (std::uint32_t j = y - 1; j <= y + 1; ++j) {
            for (std::uint32_t i = x - 1; i <= x + 1; ++i) {
                if (traced[j * width + i] != traced[y * width + x]) return false;
            }
        }
        return true;
    };
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const bool wrong = traced[y * width + x] != drawn.ids[y * width + x];
            result.wrong += wrong ? 1u : 0u;
            if (!is_inside(x, y)) continue;
            ++result.inside;
            objects.insert(traced[y * width + x]);
            if (wrong && result.wrong_inside++ == 0) result.first_wrong = {x, y};
        }
    }
    result.objects = objects.size();
    return result;
}

/// One renderer for all stages, and what it drew last.
class Drawer {
public:
    /// Gives a stage's scene to the renderer.
    void show(Stage& stage) {
        stage_ = &stage;
        PreparedScene prepared = prepare_scene(*stage.scene, thread_.device(), true);
        processed_ = prepared.scene;
        hand_over(std::move(prepared), stage, thread_);
    }

    /// Draws what an eye sees, and keeps the Frame.
    [[nodiscard]] render::ObjectImage draw(const systems::Eye& eye) {
        render::FrameInput& input = thread_.begin();
        systems::build_frame(*stage_->world, eye, 1.0f, input.frame);
        input.frame.capture = {.objects = true};
        input.complete_textures = true;
        frame_ = input.frame;
        thread_.submit();
        thread_.finish();
        return thread_.collect().back().objects.value();
    }

    [[nodiscard]] const systems::Frame& frame() const { return frame_; }
    [[nodiscard]] FrameTracer tracer() const { return {frame_, *stage_->scene, *processed_}; }

private:
    render::RenderThread thread_{
        {.window = {}, .shaders = {}, .gl_errors_throw = true, .compile_ahead = false, .compile_for = {}}};
    Stage* stage_ = nullptr;
    std::shared_ptr<const assets::ProcessedScene> processed_;
    systems::Frame frame_;
};

}  // namespace rambla::game::study::test
