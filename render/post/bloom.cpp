#include "render/post/bloom.h"

#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

/// Texels of the finest bright light along a tile's edge, which then is 64 pixels long, as are the bins of
/// the software rasteriser.
constexpr std::uint32_t k_tile_texels = 8;
/// Light that is not seen, of display white, which is about 1: from there to twice as much, glow fades in.
constexpr float k_unseen_light = 1.0f / 8192.0f;

/// Where a picture is drawn larger than it is shown, its glow is as many times wider.
std::uint32_t pixels_drawn_for_one(const Settings& settings) {
    return settings.anti_aliasing.method == AntiAliasing::ssaa
               ? static_cast<std::uint32_t>(settings.anti_aliasing.samples)
               : 1u;
}

glm::uvec2 divided_up(glm::uvec2 size, std::uint32_t by) {
    return (size + by - 1u) / by;
}

shared::BloomFrameConstants constants_of(const FrameResources& resources) {
    const BloomParameters& bloom = resources.settings.bloom;
    const std::uint32_t scale = pixels_drawn_for_one(resources.settings);
    const std::uint32_t tile_px = scale * k_tile_texels * k_bloom_texel_px;
    const std::uint32_t texel_px =
        bloom.method == BloomMethod::iterated ? k_bloom_half_texel_px : k_bloom_texel_px;
    const float knee = bloom.knee * bloom.threshold;
    return {.bright = {bloom.threshold - knee, bloom.threshold + knee, bloom.threshold, 0.0f},
            .shown = {bloom.intensity, k_unseen_light, 0.0f, 0.0f},
            .tiles = {divided_up(resources.size_px(), tile_px), tile_px, scale * texel_px},
            .size_px = {resources.size_px(), 0u, 0u}};
}

/// Draws of nothing yet.
void clear_draws(GLuint buffer) {
    static_assert(shared::k_bloom_draw_spread == 2, "the draws of quads come first");
    constexpr shared::TileDraw no_quads{4, 0, 0, 0};
    constexpr shared::TileDraw no_triangle{3, 0, 0, 0};
    constexpr auto quads_bytes = static_cast<GLsizeiptr>(2 * sizeof(no_quads));
    glClearNamedBufferSubData(buffer, GL_RGBA32UI, 0, quads_bytes, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                              &no_quads);
    glClearNamedBufferSubData(buffer, GL_RGBA32UI, quads_bytes, sizeof(no_triangle), GL_RGBA_INTEGER,
                              GL_UNSIGNED_INT, &no_triangle);
}

void read_tiles(PassBuilder& pass, BufferHandle tiles) {
    pass.read(tiles, graph::Use::indirect);
    pass.read(tiles, graph::Use::storage);
}

}  // namespace

void BloomPass::add(RenderGraph& graph, FrameResources& resources) {
    if (resources.settings.bloom.method == BloomMethod::off) return;
    constants_ = constants_of(resources);
    uniforms_ = resources.stream.upload_value(constants_);
    find_bright(graph, resources);
    const BloomLight bright = draw_bright(graph, resources);
    const BloomLight light = spread(graph, resources, bright);
    find_visible(graph, resources, light);
    add_light(graph, resources, light);
}

void BloomPass::bind_tiles(const PassContext& context) const {
    const GLuint tiles = context.buffer(tiles_);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE, tiles);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, tiles);
    uniforms_.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
}

void BloomPass::find_bright(RenderGraph& graph, FrameResources& resources) {
    const gl::Program& program = tools_.program(BloomProgram::find);
    const std::size_t list_bytes = sizeof(shared::uint) * constants_.tiles.x * constants_.tiles.y;
    graph.add_pass(
        "bloom find",
        [&](PassBuilder& pass) {
            pass.read(resources.scene_colour);
            tiles_ = pass.write_storage(pass.create_buffer(
                "bloom tiles", sizeof(shared::TileDraw) * shared::k_bloom_draws + 2 * list_bytes));
        },
        [this, &resources, &program, scene = resources.scene_colour](PassContext& context) {
            clear_draws(context.buffer(tiles_));
            context.bind_texture(UNIT_PASS, scene, resources.samplers.nearest);
            bind_tiles(context);
            program.use();
            glDispatchCompute(constants_.tiles.x, constants_.tiles.y, 1);
        });
}

BloomLight BloomPass::draw_bright(RenderGraph& graph, FrameResources& resources) {
    const gl::Program& program = tools_.program(
        resources.settings.bloom.fireflies ? BloomProgram::bright_weighted : BloomProgram::bright);
    const gl::VertexArray& no_vertices = tools_.no_vertices();
    BloomLight bright{.size = divided_up(resources.size_px(), constants_.tiles.w)};
    graph.add_pass(
        "bloom bright",
        [&](PassBuilder& pass) {
            pass.read(resources.scene_colour);
            read_tiles(pass, tiles_);
            const TextureHandle target =
                pass.create_texture("bloom light", {.format = GL_RGBA16F, .size = bright.size});
            bright.texture = pass.write_colour(0, target, LoadOp::clear);
        },
        [this, &resources, &program, &no_vertices, scene = resources.scene_colour](PassContext& context) {
            context.bind_texture(UNIT_PASS, scene, resources.samplers.nearest);
            bind_tiles(context);
            no_vertices.bind();
            program.use();
            draw_tiles(shared::k_bloom_draw_bright);
        });
    return bright;
}

BloomLight BloomPass::spread(RenderGraph& graph, FrameResources& resources, BloomLight bright) {
    BloomSteps steps{graph, resources, tools_, tiles_};
    const BloomParameters& bloom = resources.settings.bloom;
    switch (bloom.method) {
        case BloomMethod::iterated:
            return spread_by_iteration(steps, bright, bloom.passes);
        case BloomMethod::kawase:
            return spread_by_kawase(steps, bright, bloom.passes, kawase_);
        case BloomMethod::dual:
            return spread_by_dual_filter(steps, bright, dual_);
        case BloomMethod::off:
        case BloomMethod::pyramid:
            break;
    }
    return spread_by_pyramid(steps, bright);
}

void BloomPass::find_visible(RenderGraph& graph, FrameResources& resources, BloomLight light) {
    const gl::Program& program = tools_.program(BloomProgram::visible);
    graph.add_pass(
        "bloom visible",
        [&](PassBuilder& pass) {
            pass.read(light.texture);
            tiles_ = pass.write_storage(tiles_);
        },
        [this, &resources, &program, light = light.texture](PassContext& context) {
            context.bind_texture(UNIT_PASS, light, resources.samplers.nearest);
            bind_tiles(context);
            program.use();
            glDispatchCompute(constants_.tiles.x, constants_.tiles.y, 1);
        });
}

void BloomPass::add_light(RenderGraph& graph, FrameResources& resources, BloomLight light) {
    const gl::Program& program = tools_.program(BloomProgram::add);
    const gl::VertexArray& no_vertices = tools_.no_vertices();
    graph.add_pass(
        "bloom add",
        [&](PassBuilder& pass) {
            pass.read(light.texture);
            read_tiles(pass, tiles_);
            resources.scene_colour = pass.write_colour(0, resources.scene_colour, LoadOp::load);
        },
        [this, &resources, &program, &no_vertices, light = light.texture](PassContext& context) {
            context.bind_texture(UNIT_PASS, light, resources.samplers.linear);
            bind_tiles(context);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            no_vertices.bind();
            program.use();
            draw_tiles(shared::k_bloom_draw_visible);
        });
    resources.counts.draws += 2;
    resources.counts.calls += 2;
}

}  // namespace rambla::render
