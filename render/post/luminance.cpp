#include "render/post/luminance.h"

#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/luminance.h"

namespace rambla::render {
namespace {

constexpr std::uint32_t k_block = 4;  // of luminance_chain.frag.glsl

glm::uvec2 groups_over(glm::uvec2 size) {
    return (size + shared::k_luminance_square_px - 1u) / shared::k_luminance_square_px;
}

}  // namespace

bool estimates_curve(const ToneParameters& tone) {
    return tone.curve == ToneCurve::extended && tone.estimate;
}

bool wants_luminance(const Settings& settings) {
    if (settings.debug.view != DebugView::off) return false;
    return settings.exposure.mode == ExposureMode::automatic || estimates_curve(settings.tone);
}

const gl::Program& LuminancePass::program(Shader shader) {
    const gl::Program*& variant = variants_[static_cast<std::size_t>(shader)];
    if (variant != nullptr) return *variant;
    gl::ProgramDesc desc{.name = "luminance", .vertex = {}, .fragment = {}, .compute = {}, .defines = {}};
    const auto draws = [&](const char* fragment) {
        desc.vertex = "full_screen.vert.glsl";
        desc.fragment = fragment;
    };
    const bool first = shader == Shader::first_blocks || shader == Shader::squares;
    switch (shader) {
        case Shader::first_blocks:
        case Shader::blocks:
            draws("luminance_chain.frag.glsl");
            desc.defines = {{"FIRST", first ? "1" : "0"}};
            break;
        case Shader::squares:
        case Shader::sum_of_squares:
            desc.compute = "luminance_sum.comp.glsl";
            desc.defines = {{"FIRST", first ? "1" : "0"}};
            break;
        case Shader::logarithm:
            draws("log_luminance.frag.glsl");
            break;
        case Shader::histogram:
            desc.compute = "luminance_histogram.comp.glsl";
            break;
    }
    variant = &programs_.get(desc);
    return *variant;
}

void LuminancePass::add(RenderGraph& graph, FrameResources& resources) {
    if (!wants_luminance(resources.settings)) return;
    const ExposureParameters& parameters = resources.settings.exposure;
    const glm::uvec2 groups = groups_over(graph.desc(resources.scene_colour).size);
    const gl::BufferRange constants = resources.stream.upload_value(
        shared::LuminanceConstants{.delta = glm::vec4{parameters.delta, 0.0f, 0.0f, 0.0f},
                                   .groups = glm::uvec4{groups, groups.x * groups.y, 0u}});
    switch (parameters.luminance) {
        case LuminanceMethod::chain:
            add_chain(graph, resources, constants);
            break;
        case LuminanceMethod::compute:
            add_compute(graph, resources, constants);
            break;
        case LuminanceMethod::mips:
        case LuminanceMethod::mips16:
            add_mips(graph, resources, constants);
            break;
    }
    if (estimates_curve(resources.settings.tone)) add_histogram(graph, resources, constants);
}

void LuminancePass::add_chain(RenderGraph& graph, FrameResources& resources,
                              const gl::BufferRange& constants) {
    TextureHandle sums = add_step(graph, resources, resources.scene_colour, Shader::first_blocks, constants);
    while (graph.desc(sums).size != glm::uvec2{1})
        sums = add_step(graph, resources, sums, Shader::blocks, constants);
    resources.luminance.texture = sums;
}

TextureHandle LuminancePass::add_step(RenderGraph& graph, const FrameResources& resources,
                                      TextureHandle source, Shader shader, const gl::BufferRange& constants) {
    TextureHandle sums;
    const glm::uvec2 size = (graph.desc(source).size + k_block - 1u) / k_block;
    graph.add_pass(
        "luminance",
        [&](PassBuilder& pass) {
            pass.read(source);
            const TextureHandle target =
                pass.create_texture("luminance sums", {.format = GL_RG32F, .size = size});
            sums = pass.write_colour(0, target, LoadOp::discard);
        },
        [&resources, &step = program(shader), source, constants](PassContext& context) {
            context.bind_texture(UNIT_PASS, source, resources.samplers.nearest);
            constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            step.use();
            context.draw_full_screen();
        });
    return sums;
}

void LuminancePass::add_compute(RenderGraph& graph, FrameResources& resources,
                                const gl::BufferRange& constants) {
    const TextureHandle source = resources.scene_colour;
    const glm::uvec2 groups = groups_over(graph.desc(source).size);
    graph.add_pass(
        "luminance",
        [&](PassBuilder& pass) {
            pass.read(source);
            const std::size_t squares = std::size_t{groups.x} * groups.y;
            resources.luminance.buffer =
                pass.write_storage(pass.create_buffer("luminance sums", (1 + squares) * sizeof(glm::vec2)));
        },
        [&resources, &squares = program(Shader::squares), &sum = program(Shader::sum_of_squares), source,
         constants, groups](PassContext& context) {
            context.bind_texture(UNIT_PASS, source, resources.samplers.nearest);
            constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE,
                             context.buffer(resources.luminance.buffer));
            squares.use();
            glDispatchCompute(groups.x, groups.y, 1);
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
            sum.use();
            glDispatchCompute(1, 1, 1);
        });
}

void LuminancePass::add_mips(RenderGraph& graph, FrameResources& resources,
                             const gl::BufferRange& constants) {
    const TextureHandle source = resources.scene_colour;
    const glm::uvec2 size = graph.desc(source).size;
    const bool halves = resources.settings.exposure.luminance == LuminanceMethod::mips16;
    resources.luminance.means = true;
    graph.add_pass(
        "luminance",
        [&](PassBuilder& pass) {
            pass.read(source);
            const TextureHandle target =
                pass.create_texture("log luminance", {.format = halves ? GLenum{GL_RG16F} : GLenum{GL_RG32F},
                                                      .size = size,
                                                      .levels = gl::full_levels(size)});
            resources.luminance.texture = pass.write_colour(0, target, LoadOp::discard);
        },
        [&resources, &logarithm = program(Shader::logarithm), source, constants](PassContext& context) {
            context.bind_texture(UNIT_PASS, source, resources.samplers.nearest);
            constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            logarithm.use();
            context.draw_full_screen();
            glGenerateTextureMipmap(context.texture(resources.luminance.texture));
        });
}

void LuminancePass::add_histogram(RenderGraph& graph, FrameResources& resources,
                                  const gl::BufferRange& constants) {
    const TextureHandle source = resources.scene_colour;
    const glm::uvec2 groups = groups_over(graph.desc(source).size);
    graph.add_pass(
        "luminance histogram",
        [&](PassBuilder& pass) {
            pass.read(source);
            resources.luminance.histogram = pass.write_storage(
                pass.create_buffer("luminance histogram", shared::k_luminance_bins * sizeof(std::uint32_t)));
        },
        [&resources, &count = program(Shader::histogram), source, constants, groups](PassContext& context) {
            const GLuint bins = context.buffer(resources.luminance.histogram);
            constexpr std::uint32_t none = 0;
            glClearNamedBufferSubData(bins, GL_R32UI, 0, shared::k_luminance_bins * sizeof(none),
                                      GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
            context.bind_texture(UNIT_PASS, source, resources.samplers.nearest);
            constants.bind(GL_UNIFORM_BUFFER, BINDING_PASS_UNIFORMS);
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, BINDING_PASS_STORAGE, bins);
            count.use();
            glDispatchCompute(groups.x, groups.y, 1);
        });
}

}  // namespace rambla::render
