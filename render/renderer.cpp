#include "render/renderer.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "assets/assert.h"
#include "render/draw.h"
#include "render/frame_captures.h"
#include "render/frame_uniforms.h"
#include "render/gl/calls.h"
#include "render/gl/context.h"
#include "render/gl/framebuffer.h"
#include "render/graph/graph.h"
#include "render/pass_context.h"
#include "render/passes/all_passes.h"
#include "render/shaders/shared/bindings.h"
#include "render/shaders/shared/deformation.h"
#include "render/shaders/shared/instance.h"
#include "render/shaders/shared/light.h"
#include "render/temporal_history.h"
#include "render/warm_up.h"

namespace rambla::render {

namespace {

static_assert(sizeof(systems::Instance) == sizeof(shared::Instance));
static_assert(offsetof(systems::Instance, row2) == offsetof(shared::Instance, row2));
static_assert(offsetof(systems::Instance, material) == offsetof(shared::Instance, material));
static_assert(systems::k_instance_material_mask == shared::k_instance_material_mask);
static_assert(systems::k_instance_fade_shift == shared::k_instance_fade_shift);
static_assert(offsetof(systems::Instance, object) == offsetof(shared::Instance, object));
static_assert(offsetof(systems::Instance, joints) == offsetof(shared::Instance, joints));
static_assert(offsetof(systems::Instance, morphs) == offsetof(shared::Instance, morphs));
static_assert(sizeof(systems::JointMatrix) == sizeof(shared::JointMatrix));
static_assert(sizeof(systems::MorphTerm) == sizeof(shared::MorphTerm));
static_assert(offsetof(systems::MorphTerm, weight) == offsetof(shared::MorphTerm, weight));
static_assert(sizeof(systems::FrameLight) == sizeof(shared::Light));
static_assert(offsetof(systems::FrameLight, intensity) == offsetof(shared::Light, intensity_cos_outer));
static_assert(offsetof(systems::FrameLight, direction) == offsetof(shared::Light, direction_cos_inner));

/// One is drawn while the next is being submitted; a third would only add latency.
constexpr std::size_t k_max_in_flight = 2;
/// What a street's frame takes; StreamBuffer grows where it is not enough.
constexpr std::size_t k_stream_bytes = std::size_t{1} << 20;

using Clock = std::chrono::steady_clock;

PassSamplers make_samplers() {
    return {.nearest = gl::Sampler{"nearest", {}},
            .linear = gl::Sampler{"linear", {.minify = GL_LINEAR, .magnify = GL_LINEAR}},
            .depth_compare = gl::Sampler{"depth compare",
                                         {.minify = GL_LINEAR, .magnify = GL_LINEAR, .compare = GL_GEQUAL}}};
}

DeviceInfo tell_device(const std::function<void(const DeviceInfo&)>& on_device) {
    DeviceInfo device = gl::describe_device();
    if (on_device) on_device(device);
    return device;
}

/// A submitted frame whose fence has not been seen to pass.
struct InFlight {
    GLsync fence = nullptr;
    bool is_warm_up = false;
    FrameOutput output;
    FrameCaptures captures;
};

}  // namespace

struct Renderer::State {
    State(const RenderThreadOptions& options, const std::function<void(const DeviceInfo&)>& on_device)
        : context{options.window, options.gl_errors_throw},
          device{tell_device(on_device)},
          compile_ahead{options.compile_ahead},
          compile_for{options.compile_for},
          programs{options.shaders},
          samplers{make_samplers()},
          scene_passes{programs},
          display_passes{programs} {
        context.check_errors();
    }
    ~State() {
        for (InFlight& frame : in_flight)
            glDeleteSync(frame.fence);
    }

    gl::Context context;
    DeviceInfo device;
    bool compile_ahead;
    Settings compile_for;
    gl::ProgramRegistry programs;
    SceneStore scene;
    gl::StreamBuffer stream{"stream", k_stream_bytes};
    PassSamplers samplers;
    ScenePasses scene_passes;
    DisplayPasses display_passes;
    RenderGraph graph;
    DrawList opaque;
    DrawList blended;
    DrawCounts counts;
    std::optional<TemporalHistory> temporal;  ///< only with temporal anti-aliasing
    bool continues = false;                   ///< the next frame shows the scene of the last one
    gl::CallCounts calls_before;              ///< at the end of the last frame
    gl::Texture backbuffer;                   ///< where pixels are wanted back, or no window is
    gl::Framebuffer backbuffer_reader;        ///< to copy it to the window

    std::array<InFlight, k_max_in_flight> in_flight;  ///< a ring
    std::size_t first = 0;
    std::size_t count = 0;
    std::uint64_t finished = 0;      ///< frames since the beginning, as the fences have told
    std::uint32_t thickness_px = 1;  ///< of points and lines, as GL has been told

    void draw(const FrameInput& input, bool is_warm_up);
    void bring_textures(const FrameInput& input);
    void draw_passes(const FrameInput& input, InFlight& slot);
    void set_thickness(std::uint32_t pixels);
    [[nodiscard]] const TemporalFrame* follow(const FrameInput& input, float exposure, bool cut);
    void bind_frame(const FrameInput& input, FrameResources& resources);
    [[nodiscard]] TextureHandle import_backbuffer(glm::uvec2 size, bool as_texture);
    [[nodiscard]] bool take_oldest(std::vector<FrameOutput>& outputs, bool wait);
    std::vector<FrameOutput> overtaken;  ///< finished because draw() had to wait
};

Renderer::Renderer(const RenderThreadOptions& options,
                   const std::function<void(const DeviceInfo&)>& on_device)
    : state_{std::make_unique<State>(options, on_device)} {}
Renderer::~Renderer() = default;

void Renderer::upload(const assets::Scene& scene, const assets::ProcessedScene& processed,
                      std::shared_ptr<assets::LevelSource> source, std::span<const std::uint32_t> fading) {
    state_->scene.upload(processed, std::move(source));
    state_->continues = false;
    if (!state_->compile_ahead) return;
    for (const FrameInput& input : warm_up_frames(scene, state_->compile_for, fading))
        state_->draw(input, true);
    state_->continues = false;
}

void Renderer::draw(const FrameInput& input) {
    state_->draw(input, false);
}

void Renderer::take_finished(std::vector<FrameOutput>& outputs, bool wait) {
    for (FrameOutput& output : state_->overtaken)
        outputs.push_back(std::move(output));
    state_->overtaken.clear();
    while (state_->take_oldest(outputs, wait)) {
    }
}

bool Renderer::frames_in_flight() const {
    return state_->count > 0 || !state_->overtaken.empty();
}

void Renderer::State::draw(const FrameInput& input, bool is_warm_up) {
    const Clock::time_point begin = Clock::now();
    if (count == k_max_in_flight) static_cast<void>(take_oldest(overtaken, true));
    InFlight& slot = in_flight[(first + count) % k_max_in_flight];
    slot.is_warm_up = is_warm_up;
    slot.output = {};
    if (input.reload_shaders) slot.output.shader_error = programs.reload();
    const glm::uvec2 size = input.frame.view.size_px;
    graph.begin_frame();
    counts = {};
    stream.begin_frame();
    if (!is_warm_up) bring_textures(input);
    if (size.x > 0 && size.y > 0) {  // a minimised window has no pixels
        draw_passes(input, slot);
    } else {
        graph.execute();
    }
    stream.end_frame();
    if (!is_warm_up) context.swap();
    slot.fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    ++count;

    systems::Feedback& feedback = slot.output.feedback;
    const gl::LiveCounts live = gl::live_counts();
    feedback.frame = input.frame.number;
    feedback.draws = counts.draws;
    feedback.triangles = counts.triangles;
    const gl::CallCounts calls = gl::calls() - calls_before;
    calls_before = gl::calls();
    feedback.gl_calls = calls.total() - calls[gl::CallKind::poll] - calls[gl::CallKind::pace];
    feedback.gl_state_changes = calls[gl::CallKind::bind] + calls[gl::CallKind::state];
    feedback.gl_blocking_calls = calls[gl::CallKind::wait];
    feedback.gl_pacing_waits = calls[gl::CallKind::pace];
    feedback.gl_objects = live.objects - scene.textures().passing_textures();
    feedback.gpu_memory_bytes = live.bytes;
    feedback.textures = scene.textures().feedback();
    feedback.cpu_begin = begin;
    feedback.cpu_frame_ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    context.check_errors();
}

void Renderer::State::bring_textures(const FrameInput& input) {
    const std::uint64_t number = finished + count;
    const std::vector<std::uint8_t>& demand = input.frame.texture_demand;
    if (input.complete_textures) {
        scene.complete_textures(demand, input.settings, number);
    } else {
        scene.update_textures(demand, input.settings, number);
    }
}

void Renderer::State::draw_passes(const FrameInput& input, InFlight& slot) {
    const systems::Frame& frame = input.frame;
    const systems::CaptureRequest& wanted = frame.capture;
    const float exposure = std::exp2(input.settings.exposure.ev);
    set_thickness(frame.view.samples);
    const bool cut = input.cut || !std::exchange(continues, true);
    const TemporalFrame* const followed = follow(input, exposure, cut);
    opaque.clear(DrawKind::shaded);
    opaque.add(scene, frame.opaque);
    opaque.upload(stream);
    blended.clear(DrawKind::blended);
    blended.add(scene, frame.blended);
    blended.upload(stream);

    FrameResources resources{.frame = frame,
                             .view = followed != nullptr ? followed->view : frame.view,
                             .settings = input.settings,
                             .scene = scene,
                             .samplers = samplers,
                             .stream = stream,
                             .opaque = opaque,
                             .blended = blended,
                             .counts = counts,
                             .exposure = exposure,
                             .cut = cut,
                             .temporal = followed};
    bind_frame(input, resources);
    const bool as_texture = context.headless() || wanted.display;
    resources.backbuffer = import_backbuffer(frame.view.shown_px(), as_texture);
    scene_passes.add(graph, resources);
    slot.captures.add_from_scene(graph, resources);
    display_passes.add(graph, resources);
    slot.captures.add_from_display(graph, resources);
    graph.execute(input.timers);
    if (as_texture && !context.headless()) {
        const auto width = static_cast<GLint>(frame.view.shown_px().x);
        const auto height = static_cast<GLint>(frame.view.shown_px().y);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glBlitNamedFramebuffer(backbuffer_reader.name(), 0, 0, 0, width, height, 0, 0, width, height,
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    if (input.draw_graph) slot.output.graph_svg = graph.svg();
}

const TemporalFrame* Renderer::State::follow(const FrameInput& input, float exposure, bool cut) {
    if (!is_temporal(input.settings)) {
        temporal.reset();
        return nullptr;
    }
    if (!temporal) temporal.emplace();
    return &temporal->follow(input.frame, exposure, !cut);
}

void Renderer::State::bind_frame(const FrameInput& input, FrameResources& resources) {
    const systems::Frame& frame = input.frame;
    static const MovedThings k_none_moved;
    if (resources.temporal != nullptr) {
        resources.temporal_constants =
            stream.upload_value(make_temporal_constants(*resources.temporal, input.settings.anti_aliasing));
    }
    const MovedThings& moved = resources.temporal != nullptr ? *resources.temporal->moved : k_none_moved;
    stream.upload_value(make_frame_uniforms(frame, resources.view, resources.exposure, input.settings.detail))
        .bind(GL_UNIFORM_BUFFER, BINDING_FRAME_UNIFORMS);
    stream
        .upload(std::span<const systems::Instance>{frame.instances},
                std::span<const systems::Instance>{moved.instances})
        .bind(GL_SHADER_STORAGE_BUFFER, BINDING_INSTANCES);
    scene.materials().bind(GL_SHADER_STORAGE_BUFFER, BINDING_MATERIALS);
    stream.upload(std::span<const systems::JointMatrix>{frame.joints}, moved.joints)
        .bind(GL_SHADER_STORAGE_BUFFER, BINDING_JOINTS);
    stream.upload(std::span<const systems::MorphTerm>{frame.morphs}, moved.morphs)
        .bind(GL_SHADER_STORAGE_BUFFER, BINDING_MORPH_TERMS);
    scene.morphs().bind(GL_SHADER_STORAGE_BUFFER, BINDING_MORPHS);
    using Lights = std::span<const systems::FrameLight>;
    stream.upload(Lights{frame.lights}, Lights{frame.directional_lights})
        .bind(GL_SHADER_STORAGE_BUFFER, BINDING_LIGHTS);
}

/// Points and lines are as thick as a pixel that is shown.
void Renderer::State::set_thickness(std::uint32_t pixels) {
    if (pixels == thickness_px) return;
    thickness_px = pixels;
    glPointSize(static_cast<GLfloat>(pixels));
    glLineWidth(static_cast<GLfloat>(pixels));
}

TextureHandle Renderer::State::import_backbuffer(glm::uvec2 size, bool as_texture) {
    if (!as_texture) {
        backbuffer_reader = {};
        backbuffer = {};
        return graph.import_default_framebuffer("backbuffer", size);
    }
    const gl::TextureDesc desc{.format = GL_RGBA8, .size = size};
    if (backbuffer.desc() != desc || !backbuffer) {
        backbuffer = gl::Texture{"backbuffer", desc};
        gl::FramebufferDesc reader;
        reader.colours[0] = {.texture = backbuffer.name()};
        backbuffer_reader = gl::Framebuffer{"backbuffer", reader};
    }
    return graph.import_texture("backbuffer", backbuffer, true);
}

bool Renderer::State::take_oldest(std::vector<FrameOutput>& outputs, bool wait) {
    if (count == 0) return false;
    InFlight& frame = in_flight[first];
    constexpr GLuint64 one_second_ns = 1'000'000'000;
    GLenum status = glClientWaitSync(frame.fence, 0, wait ? one_second_ns : 0);
    while (wait && status == GL_TIMEOUT_EXPIRED)
        status = glClientWaitSync(frame.fence, 0, one_second_ns);
    if (status == GL_TIMEOUT_EXPIRED) return false;
    glDeleteSync(frame.fence);
    frame.fence = nullptr;
    first = (first + 1) % k_max_in_flight;
    --count;
    scene.release_textures(++finished);

    const FrameCost& cost = graph.take_cost();
    systems::Feedback& feedback = frame.output.feedback;
    feedback.gpu_frame_ms = cost.gpu_ms;
    feedback.gpu_begin = cost.gpu_begin;
    feedback.passes.reserve(cost.passes.size());
    for (const PassCost& pass : cost.passes) {
        feedback.passes.push_back({.name = pass.name,
                                   .gpu_ms = pass.gpu_ms,
                                   .cpu_ms = pass.cpu_ms,
                                   .bytes_written = pass.bytes_written,
                                   .memory_bytes = pass.memory_bytes,
                                   .cpu_begin = pass.cpu_begin,
                                   .gpu_begin = pass.gpu_begin});
    }
    frame.captures.take(frame.output);
    if (!frame.is_warm_up) outputs.push_back(std::move(frame.output));
    return true;
}

}  // namespace rambla::render
