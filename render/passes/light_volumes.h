#pragma once

#include <array>
#include <vector>

#include "render/gl/program.h"
#include "render/gl/query.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"
#include "render/shaders/shared/light_rectangle.h"

namespace rambla::render {

/// The lighting path `volumes` with `quad`: adds the Frame's point and spot lights to `scene_colour`, one
/// quad per light over its rectangle on the screen, as far away as the light reaches, so that the depth test
/// leaves out what lies behind. Without lights that reach the screen there is no pass.
///
/// With queries, a light's rectangle at its near side is tested first, and the light drawn only if some pixel
/// lies behind that: hidden lights cost a query. The GPU, or the driver where it is no GPU, waits for each
/// result.
class LightVolumesPass {
public:
    explicit LightVolumesPass(gl::ProgramRegistry& programs);

    void add(RenderGraph& graph, FrameResources& resources);

private:
    [[nodiscard]] const gl::Program& program(Brdf brdf, GBufferLayout layout);
    [[nodiscard]] const gl::Program& tester();
    void make_rectangles(const FrameResources& resources);
    void test_each();
    void draw_each();

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_brdf_models.size() * k_gbuffer_layouts.size()> variants_{};
    const gl::Program* tester_ = nullptr;
    gl::VertexArray no_vertices_;
    std::vector<shared::LightRectangle> rectangles_;
    std::vector<gl::Query> queries_;  ///< one per light, kept for later frames
};

}  // namespace rambla::render
