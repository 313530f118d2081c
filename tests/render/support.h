#pragma once

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <vector>

#include "assets/image.h"
#include "assets/scene.h"
#include "render/render_thread.h"
#include "support/quick_process.h"

namespace rambla::tests {

/// A picture with its origin in the upper left corner.
struct Picture {
    glm::uvec2 size{0};               ///< of what is shown
    glm::uvec2 drawn{0};              ///< of what is drawn: another when pictures are supersampled
    std::vector<glm::vec4> linear;    ///< scene colour as it is drawn, exposure taken out
    std::vector<std::uint8_t> bytes;  ///< display, RGBA
    systems::Feedback feedback;

    [[nodiscard]] glm::vec3 radiance(std::uint32_t x, std::uint32_t y) const {
        return glm::vec3{linear[y * drawn.x + x]};
    }
    [[nodiscard]] glm::ivec3 display(std::uint32_t x, std::uint32_t y) const {
        const std::uint8_t* texel = &bytes[4 * (std::size_t{y} * size.x + x)];
        return {texel[0], texel[1], texel[2]};
    }
    [[nodiscard]] bool has_pass(const char* name) const {
        for (const systems::PassTiming& pass : feedback.passes) {
            if (pass.name == name) return true;
        }
        return false;
    }
};

/// A small world: meshes and materials, things placed in it, a camera, and pictures of it. Positions are in
/// the world; the stage makes them relative to the camera, as packing does.
class Stage {
public:
    Stage() {
        frame.view.size_px = {128, 128};
        // A pixel's light shall depend on nothing but what it shows.
        settings.exposure.mode = render::ExposureMode::fixed;
        settings.bloom.method = render::BloomMethod::off;
        look({0, 0, 5}, {0, 0, 0});
    }

    std::uint32_t material(const assets::Material& m) {
        scene.materials.push_back(m);
        return static_cast<std::uint32_t>(scene.materials.size() - 1);
    }
    std::uint32_t mesh(assets::Mesh m) {
        for (const glm::vec3& p : m.positions)
            m.bounds.expand(p);
        scene.meshes.push_back(std::move(m));
        return static_cast<std::uint32_t>(scene.meshes.size() - 1);
    }
    /// A texture from texels, row 0 on top; nearest filter.
    assets::TextureSlot texture(std::uint32_t width, std::uint32_t height,
                                const std::vector<glm::u8vec4>& texels,
                                assets::ColourSpace space = assets::ColourSpace::linear) {
        assets::Image image;
        image.width = width;
        image.height = height;
        image.texels.resize(texels.size() * 4);
        std::memcpy(image.texels.data(), texels.data(), image.texels.size());
        scene.images.push_back(std::move(image));
        scene.textures.push_back({.name = "test",
                                  .image = static_cast<std::uint32_t>(scene.images.size() - 1),
                                  .colour_space = space,
                                  .sampler = {.wrap_u = assets::WrapMode::repeat,
                                              .wrap_v = assets::WrapMode::repeat,
                                              .magnify = assets::Filter::nearest,
                                              .minify = assets::Filter::nearest,
                                              .mip = assets::MipFilter::none}});
        assets::TextureSlot slot;
        slot.texture = static_cast<std::uint32_t>(scene.textures.size() - 1);
        return slot;
    }

    /// Square of half size 1 in the plane z = 0 that faces +Z; u along +X, v along −Y as images have it.
    std::uint32_t square() {
        assets::Mesh m;
        m.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        m.normals.assign(4, {0, 0, 1});
        m.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        m.tangents.assign(4, {1, 0, 0, 1});  // the bitangent w·(n×t) = +Y points up the image, against v
        m.indices = {0, 1, 2, 0, 2, 3};
        return mesh(std::move(m));
    }

    struct Thing {
        std::uint32_t mesh = 0;
        std::uint32_t material = 0;
        glm::mat4 world_from_local{1.0f};
        bool casts = true;
        std::vector<glm::mat4> world_from_mesh{};  ///< by joint; empty: not skinned
        std::vector<systems::MorphTerm> morphs{};  ///< of the mesh's own targets; empty: not morphed
        std::uint8_t faded = 0;                    ///< of 255
    };
    /// Of haze, drawn after the things, in the order of the list.
    struct Ball {
        glm::vec3 centre_m{0.0f};
        float radius_m = 1.0f;
        std::uint32_t material = 0;
        std::uint8_t faded = 0;  ///< of 255
    };
    void place(std::uint32_t mesh_index, std::uint32_t material_index,
               const glm::mat4& world_from_local = glm::mat4{1.0f}, bool casts = true) {
        things.push_back({mesh_index, material_index, world_from_local, casts, {}, {}, 0});
    }

    void look(glm::vec3 from, glm::vec3 to, float vertical_fov_rad = 1.0f, glm::vec3 up = {0, 1, 0}) {
        eye = from;
        frame.view.view_from_world = glm::lookAt(glm::vec3{0.0f}, to - from, up);
        const glm::vec2 size{frame.view.size_px};
        const float f = 1.0f / std::tan(0.5f * vertical_fov_rad);
        glm::mat4& p = frame.view.clip_from_view;
        p = glm::mat4{0.0f};
        p[0][0] = f * size.y / size.x;
        p[1][1] = f;
        p[2][3] = -1.0f;
        p[3][2] = 0.05f;
        frame.view.orthographic = false;
    }
    /// Orthographic from `from`, half_height_m high, depth 1 at z = −0.05, 0 at −100.
    void look_flat(glm::vec3 from, glm::vec3 to, float half_height_m, glm::vec3 up = {0, 1, 0}) {
        look(from, to, 1.0f, up);
        const glm::vec2 size{frame.view.size_px};
        glm::mat4& p = frame.view.clip_from_view;
        p = glm::mat4{1.0f};
        p[0][0] = size.y / (size.x * half_height_m);
        p[1][1] = 1.0f / half_height_m;
        p[2][2] = 1.0f / (100.0f - 0.05f);
        p[3][2] = 100.0f / (100.0f - 0.05f);
        frame.view.orthographic = true;
    }

    /// Where a point of the world lands in the picture, in pixels from the upper left corner.
    [[nodiscard]] glm::vec2 pixel_of(glm::vec3 world) const {
        const glm::vec4 c =
            frame.view.clip_from_view * frame.view.view_from_world * glm::vec4{world - eye, 1.0f};
        const glm::vec2 uv = 0.5f * glm::vec2{c} / c.w + 0.5f;
        return glm::vec2{uv.x, 1.0f - uv.y} * glm::vec2{frame.view.size_px};
    }

    [[nodiscard]] Picture draw() {
        if (!thread_) {
            render::RenderThreadOptions options;
            options.gl_errors_throw = true;
            options.compile_ahead = false;
            thread_ = std::make_unique<render::RenderThread>(options);
        }
        thread_->upload(std::make_shared<assets::Scene>(scene), process(scene));
        return take(draw_uploaded(true));
    }

    /// Draws once more what draw() has uploaded: the next frame of the same scene.
    [[nodiscard]] Picture draw_next() { return take(draw_uploaded(true)); }

    /// The same without taking pictures.
    [[nodiscard]] systems::Feedback redraw() { return draw_uploaded(false).feedback; }

    /// The Frame of what stands in the world now.
    [[nodiscard]] const systems::Frame& packed() {
        pack();
        return frame;
    }

    assets::Scene scene;
    std::vector<Thing> things;
    std::vector<Ball> balls;
    systems::Frame frame;  ///< environment, lights and view are the test's; queues are filled by draw()
    render::Settings settings;
    glm::vec3 eye{0.0f};
    std::function<std::shared_ptr<const assets::ProcessedScene>(const assets::Scene&)> process =
        quick_process;

private:
    render::FrameOutput draw_uploaded(bool captured) {
        render::FrameInput& input = thread_->begin();
        pack();
        input.frame = frame;
        input.frame.capture = {.display = captured, .linear = captured};
        input.settings = settings;
        thread_->submit();
        thread_->finish();
        return std::move(thread_->collect().back());
    }

    void pack() {
        frame.instances.clear();
        frame.joints.clear();
        frame.morphs.clear();
        frame.visible = {};
        frame.opaque.clear();
        frame.blended.clear();
        frame.casters = {};
        frame.needs_emission = false;
        for (const Thing& thing : things)
            pack(thing);
        for (const Ball& ball : balls)
            pack(ball);
    }
    void pack(const Ball& ball) {
        const systems::Pipeline pipeline{.alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend),
                                         .unlit = scene.materials[ball.material].unlit,
                                         .haze = true};
        frame.blended.push_back({.pipeline = systems::pack(pipeline),
                                 .material = ball.material,
                                 .mesh = assets::k_none,
                                 .first_instance = static_cast<std::uint32_t>(frame.instances.size()),
                                 .instance_count = 1});
        const glm::vec3 centre = ball.centre_m - eye;
        const float r = ball.radius_m;
        frame.instances.push_back({.row0 = {r, 0, 0, centre.x},
                                   .row1 = {0, r, 0, centre.y},
                                   .row2 = {0, 0, r, centre.z},
                                   .material = systems::instance_material(ball.material, ball.faded)});
        frame.visible.expand(assets::Bounds{centre - r, centre + r});
    }
    void pack(const Thing& thing) {
        const assets::Material& m = scene.materials[thing.material];
        const bool translucent = assets::drawn_as(m) == assets::AlphaMode::blend;
        const glm::mat4 relative = glm::translate(glm::mat4{1.0f}, -eye) * thing.world_from_local;
        const glm::mat4 rows = glm::transpose(relative);
        const systems::Pipeline pipeline{
            .double_sided = m.double_sided,
            .mirrored = glm::determinant(glm::mat3{relative}) < 0.0f,
            .alpha = static_cast<std::uint8_t>(assets::drawn_as(m)),
            .topology = static_cast<std::uint8_t>(scene.meshes[thing.mesh].topology),
            .unlit = m.unlit,
            .skinned = !thing.world_from_mesh.empty(),
            .morphed = !thing.morphs.empty(),
            .fading = thing.faded > 0 && !translucent};
        const systems::DrawBatch batch{.pipeline = systems::pack(pipeline),
                                       .material = thing.material,
                                       .mesh = thing.mesh,
                                       .first_instance = static_cast<std::uint32_t>(frame.instances.size()),
                                       .instance_count = 1};
        frame.instances.push_back({.row0 = rows[0],
                                   .row1 = rows[1],
                                   .row2 = rows[2],
                                   .material = systems::instance_material(thing.material, thing.faded),
                                   .joints = static_cast<std::uint32_t>(frame.joints.size()),
                                   .morphs = static_cast<std::uint32_t>(frame.morphs.size())});
        const assets::Bounds box = deform(thing, relative);
        frame.visible.expand(box);
        const bool blended = translucent || thing.faded > 0;
        (blended ? frame.blended : frame.opaque).push_back(batch);
        if (m.unlit || glm::dot(m.emissive, glm::vec3{1.0f}) > 0.0f || assets::is_light_mapped(m))
            frame.needs_emission = frame.needs_emission || !blended;
        if (!thing.casts || translucent) return;
        systems::CasterColumns& c = frame.casters;
        c.centre_x.push_back(box.centre().x);
        c.centre_y.push_back(box.centre().y);
        c.centre_z.push_back(box.centre().z);
        c.half_x.push_back(box.half_extents().x);
        c.half_y.push_back(box.half_extents().y);
        c.half_z.push_back(box.half_extents().z);
        systems::Pipeline caster = pipeline;
        caster.fading = false;
        c.pipeline.push_back(systems::pack(caster));
        c.material.push_back(batch.material);
        c.mesh.push_back(batch.mesh);
        c.instance.push_back(batch.first_instance);
    }

    /// Adds joints and morph terms of a thing, and finds a box around it.
    assets::Bounds deform(const Thing& thing, const glm::mat4& relative) {
        std::uint32_t first_target = 0;
        for (std::uint32_t i = 0; i < thing.mesh; ++i)
            first_target += static_cast<std::uint32_t>(scene.meshes[i].morphs.size());
        assets::Bounds local = scene.meshes[thing.mesh].bounds;
        for (const systems::MorphTerm& term : thing.morphs) {
            frame.morphs.push_back({first_target + term.target, term.weight});
            for (const glm::vec3& delta : scene.meshes[thing.mesh].morphs[term.target].positions) {
                local.expand(local.min + term.weight * delta);
                local.expand(local.max + term.weight * delta);
            }
        }
        if (!thing.morphs.empty()) frame.morphs.push_back({});
        if (thing.world_from_mesh.empty()) return assets::transformed(local, relative);
        assets::Bounds box;
        for (const glm::mat4& joint : thing.world_from_mesh) {
            const glm::mat4 from_eye = glm::translate(glm::mat4{1.0f}, -eye) * joint;
            const glm::mat4 rows = glm::transpose(from_eye);
            frame.joints.push_back({rows[0], rows[1], rows[2]});
            box.expand(assets::transformed(local, from_eye));
        }
        return box;
    }

    [[nodiscard]] static Picture take(const render::FrameOutput& output) {
        Picture picture;
        picture.feedback = output.feedback;
        picture.size = {output.display->width, output.display->height};
        picture.drawn = {output.linear->width, output.linear->height};
        picture.linear.resize(std::size_t{picture.drawn.x} * picture.drawn.y);
        std::memcpy(picture.linear.data(), output.linear->texels.data(), output.linear->texels.size());
        picture.bytes.resize(output.display->texels.size());
        std::memcpy(picture.bytes.data(), output.display->texels.data(), picture.bytes.size());
        return picture;
    }

    std::unique_ptr<render::RenderThread> thread_;
};

/// A rough white dielectric: nearly Lambert.
[[nodiscard]] inline assets::Material matte(glm::vec3 colour = glm::vec3{1.0f}) {
    assets::Material m;
    m.base_colour = glm::vec4{colour, 1.0f};
    m.metalness = 0.0f;
    m.roughness = 1.0f;
    return m;
}

/// A sun and nothing else: no sky, no ground.
[[nodiscard]] inline assets::Environment only_sun(glm::vec3 to_sun,
                                                  glm::vec3 illuminance = glm::vec3{3.14159265f}) {
    assets::Environment e;
    e.direction_to_sun = glm::normalize(to_sun);
    e.sun_illuminance = illuminance;
    return e;
}

}  // namespace rambla::tests
