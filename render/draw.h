#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/gl/buffer.h"
#include "render/gl/program.h"
#include "render/scene_store.h"
#include "systems/frame.h"

namespace rambla::render {

/// What was drawn.
struct DrawCounts {
    std::uint32_t draws = 0;  ///< indirect commands
    std::uint32_t calls = 0;  ///< GL draw calls
    std::uint64_t triangles = 0;

    DrawCounts& operator+=(const DrawCounts& other) {
        draws += other.draws;
        calls += other.calls;
        triangles += other.triangles;
        return *this;
    }
};

/// How a list is split into runs that share their GL state.
enum class DrawKind : std::uint8_t {
    shaded,   ///< a run per pipeline and material, with the material's textures
    blended,  ///< as shaded, but thing by thing what is drawn twice: what is seen from both sides, back faces
              ///< first, and what fades, its depth first
    depth_only  ///< opaque materials merge into one run per cull state, and draw shadow meshes unless they
                ///< deform; masked ones bind their base colour
};

/// Meshes to draw, as indirect commands: one glMultiDrawElementsIndirect per run of equal state. Keeps its
/// memory, so fill one per pass and frame: clear(), add() in sorted order, upload(), then draw() any number
/// of times.
class DrawList {
public:
    void clear(DrawKind kind);

    /// @param first_instance  row of the instance buffer; further instances follow it
    void add(const SceneStore& scene, std::uint32_t pipeline, std::uint32_t material, std::uint32_t mesh,
             std::uint32_t first_instance, std::uint32_t instance_count);
    void add(const SceneStore& scene, std::span<const systems::DrawBatch> batches);
    /// Rows of `casters` (ascending), of which neighbours with the same mesh and consecutive instances merge.
    void add(const SceneStore& scene, const systems::CasterColumns& casters,
             std::span<const std::uint32_t> rows);

    void upload(gl::StreamBuffer& stream);

    [[nodiscard]] bool empty() const { return commands_.empty(); }

    /// Draws everything with the programs that `program_of(systems::Pipeline, material)` chooses; it is asked
    /// once per run and returns a `const gl::Program&`. Sets culling, winding, vertex array and material
    /// textures; depth and blend state are the caller's. What fades writes its depth and is blended where
    /// that is the nearest; then depth is tested by GL_GREATER and not written.
    template <class ProgramOf>
    DrawCounts draw(const SceneStore& scene, ProgramOf&& program_of) const {
        DrawCounts counts;
        begin();
        for (const Run& run : runs_) {
            program_of(systems::unpack_pipeline(run.pipeline), run.material).use();
            draw_run(scene, run, counts);
        }
        end();
        return counts;
    }

private:
    /// Layout that glMultiDrawElementsIndirect asks for.
    struct Command {
        std::uint32_t index_count;
        std::uint32_t instance_count;
        std::uint32_t first_index;
        std::int32_t base_vertex;
        std::uint32_t base_instance;
    };
    struct Run {
        std::uint32_t pipeline;  ///< of its first member
        std::uint32_t material;  ///< of its first member
        std::uint32_t first_command;
        std::uint32_t command_count;
        std::uint64_t triangles;
    };

    [[nodiscard]] bool is_drawn_twice(std::uint32_t pipeline) const;
    void draw_sides(const Run& run, DrawCounts& counts) const;
    void draw_fading(const Run& run, DrawCounts& counts) const;
    [[nodiscard]] bool draws_shadow_meshes(systems::Pipeline pipeline) const;
    [[nodiscard]] bool continues(const Run& run, std::uint32_t pipeline, std::uint32_t material) const;
    void begin() const;
    void draw_run(const SceneStore& scene, const Run& run, DrawCounts& counts) const;
    void draw_commands(const Run& run, DrawCounts& counts) const;
    static void end();

    DrawKind kind_ = DrawKind::shaded;
    std::vector<Command> commands_;
    std::vector<Run> runs_;
    gl::BufferRange range_;
};

}  // namespace rambla::render
