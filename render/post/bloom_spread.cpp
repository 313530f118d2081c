#include "render/post/bloom_spread.h"

#include <array>
#include <cmath>
#include <string>

#include "render/shaders/shared/bindings.h"

namespace rambla::render {
namespace {

struct ProgramFiles {
    const char* vertex;
    const char* fragment;
    const char* compute;
    const char* define;
    const char* value;
    const char* second_define = "";
    const char* second_value = "";
};

constexpr const char* k_full_screen = "full_screen.vert.glsl";
constexpr const char* k_tile = "bloom_tile.vert.glsl";

/// By BloomProgram.
constexpr std::array<ProgramFiles, k_bloom_programs> k_files{{
    {"", "", "bloom_find.comp.glsl", "", ""},
    {k_tile, "bloom_bright.frag.glsl", "", "FIREFLIES", "0", "DRAW", "k_bloom_draw_bright"},
    {k_tile, "bloom_bright.frag.glsl", "", "FIREFLIES", "1", "DRAW", "k_bloom_draw_bright"},
    {"", "", "bloom_visible.comp.glsl", "", ""},
    {k_tile, "bloom_add.frag.glsl", "", "DRAW", "k_bloom_draw_visible"},
    {k_full_screen, "bloom_reduce.frag.glsl", "", "", ""},
    {k_full_screen, "bloom_blur.frag.glsl", "", "PAIRS", "5", "ONTO", "0"},
    {k_full_screen, "bloom_blur.frag.glsl", "", "PAIRS", "5", "ONTO", "1"},
    {k_full_screen, "bloom_blur.frag.glsl", "", "PAIRS", "3", "ONTO", "0"},
    {k_full_screen, "bloom_kawase.frag.glsl", "", "", ""},
    {k_full_screen, "bloom_dual.frag.glsl", "", "DOWN", "1"},
    {k_full_screen, "bloom_dual.frag.glsl", "", "DOWN", "0"},
    {k_full_screen, "bloom_sum.frag.glsl", "", "ONTO", "0"},
    {k_full_screen, "bloom_sum.frag.glsl", "", "ONTO", "1"},
}};

}  // namespace

const gl::Program& BloomTools::program(BloomProgram which) {
    const gl::Program*& program = programs_[static_cast<std::size_t>(which)];
    if (program == nullptr) {
        const ProgramFiles& files = k_files[static_cast<std::size_t>(which)];
        gl::ProgramDesc desc{.name = "bloom",
                             .vertex = files.vertex,
                             .fragment = files.fragment,
                             .compute = files.compute,
                             .defines = {}};
        if (*files.define != '\0') desc.defines.emplace_back(files.define, files.value);
        if (*files.second_define != '\0') desc.defines.emplace_back(files.second_define, files.second_value);
        program = &registry_.get(desc);
    }
    return *program;
}

const gl::VertexArray& BloomTools::no_vertices() {
    if (!no_vertices_) no_vertices_.emplace("bloom");
    return *no_vertices_;
}

BloomLight BloomSteps::step(const char* name, BloomProgram which, glm::uvec2 size, BloomLight source,
                            const shared::BloomStep& constants, BloomLight other) {
    const gl::Program& program = tools_.program(which);
    const gl::VertexArray& no_vertices = tools_.no_vertices();
    const gl::BufferRange uniforms = resources_.stream.upload_value(constants);
    BloomLight made{.size = size};
    graph_.add_pass(
        name,
        [&](PassBuilder& pass) {
            pass.read(draws_, graph::Use::indirect);
            pass.read(source.texture);
            if (other.texture.valid()) pass.read(other.texture);
            const TextureHandle target =
                pass.create_texture("bloom light", {.format = GL_RGBA16F, .size = size});
            made.texture = pass.write_colour(0, target, LoadOp::discard);
        },
        [&program, &no_vertices, &samplers = resources_.samplers, uniforms, draws = draws_,
         source = source.texture, other = other.texture](PassContext& context) {
            context.bind_texture(UNIT_PASS, source, samplers.linear);
            if (other.valid()) context.bind_texture(UNIT_PASS + 1, other, samplers.linear);
            uniforms.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glBindBuffer(GL_DRAW_INDIRECT_BUFFER, context.buffer(draws));
            no_vertices.bind();
            program.use();
            draw_tiles(shared::k_bloom_draw_spread);
        });
    resources_.counts.draws += 1;
    resources_.counts.calls += 1;
    return made;
}

shared::BloomStep blur_step(const BlurKernel& kernel, glm::vec2 axis) {
    shared::BloomStep step{};
    step.share = {1.0f, 1.0f, static_cast<float>(kernel.middle), 0.0f};
    step.axis = {axis, 0.0f, 0.0f};
    for (std::size_t i = 0; i < kernel.pairs.size(); ++i) {
        const auto [offset, weight] = kernel.pairs[i];
        const double farther = std::floor(offset) + 1.0;
        step.taps[i] = {static_cast<float>(offset), static_cast<float>(weight),
                        static_cast<float>(weight * (farther - offset)), static_cast<float>(farther)};
    }
    return step;
}

}  // namespace rambla::render
