#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/gl/buffer.h"
#include "render/gl/program.h"
#include "render/gl/query.h"
#include "render/gl/vertex_array.h"
#include "render/pass_context.h"
#include "render/passes/light_hull.h"

namespace rambla::render {

/// The lighting path `volumes` with `solid`: adds the Frame's point and spot lights to `scene_colour`, each
/// over a hull of what it reaches. Hulls that the near plane does not cut show their front faces, and light
/// the pixels that lie behind them; the others show their back faces, and light those before them. Without
/// lights that reach the screen there is no pass.
///
///      front faces                back faces
///     eye ·   ╱‾‾╲                    ╱‾‾╲
///            │    │  lit             │ ·  │ not lit
///      not lit╲__╱                lit ╲__╱
///
/// With queries, the other side of each hull is tested first where there is one, and the light drawn only if
/// some pixel lies before its back faces: lights above an empty place cost a query. The GPU, or the driver
/// where it is no GPU, waits for each result.
class SolidLightVolumesPass {
public:
    explicit SolidLightVolumesPass(gl::ProgramRegistry& programs) : programs_{programs} {}

    void add(RenderGraph& graph, FrameResources& resources);

private:
    struct Indices {
        std::uint32_t count = 0;
        std::uint32_t first = 0;
        std::int32_t base_vertex = 0;
    };
    /// The meshes of all shapes.
    struct Meshes {
        gl::Buffer vertices;
        gl::Buffer indices;
        gl::VertexArray array;
        std::array<Indices, k_hull_shapes> shapes;
    };
    /// Hulls that one call can draw.
    struct Group {
        HullShape shape = HullShape::sphere;
        bool cut = false;  ///< by the near plane
        std::vector<shared::LightHull> hulls;
        gl::BufferRange range;
    };

    [[nodiscard]] static Meshes make_meshes();
    [[nodiscard]] const gl::Program& program(Brdf brdf, GBufferLayout layout);
    [[nodiscard]] const gl::Program& tester();
    void make_groups(const FrameResources& resources);
    void draw(const Group& group, std::uint32_t first, std::uint32_t count) const;
    void test_each();
    void draw_each(const Group& group, std::size_t first_query) const;
    void draw_all(bool queried, DrawCounts& counts) const;

    gl::ProgramRegistry& programs_;
    std::array<const gl::Program*, k_brdf_models.size() * k_gbuffer_layouts.size()> variants_{};
    const gl::Program* tester_ = nullptr;
    std::optional<Meshes> meshes_;  ///< while this way is chosen
    std::array<Group, 2 * k_hull_shapes> groups_{
        {{.shape = HullShape::sphere, .cut = false, .hulls = {}, .range = {}},
         {.shape = HullShape::sphere, .cut = true, .hulls = {}, .range = {}},
         {.shape = HullShape::cone, .cut = false, .hulls = {}, .range = {}},
         {.shape = HullShape::cone, .cut = true, .hulls = {}, .range = {}}}};
    std::vector<gl::Query> queries_;  ///< one per hull that is not cut, kept for later frames
};

}  // namespace rambla::render
