#include "game/model_view.h"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "assets/import/gltf.h"
#include "game/clips.h"
#include "game/framing.h"
#include "game/scene_cache.h"
#include "game/scene_camera.h"
#include "game/shown_bounds.h"
#include "game/supersampling.h"
#include "game/walk_report.h"
#include "systems/components.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

constexpr float k_fov_rad = 0.7f;  // 40°: models look natural, neither flat nor bulging

/// The clip that was asked for; else, where something shall move, the first.
std::optional<std::uint32_t> chosen_clip(const fs::path& file, const ViewWishes& wishes, const Stage& stage) {
    const bool asked = wishes.clip || wishes.clip_time_s;
    const std::uint32_t clip = wishes.clip ? find_clip(*stage.scene, *wishes.clip, file.string()) : 0;
    if (stage.player != ecs::Entity{}) return asked || wishes.plays ? std::optional{clip} : std::nullopt;
    if (!asked) return {};
    const std::string option = wishes.clip ? fmt::format("--clip is '{}'", *wishes.clip)
                                           : fmt::format("--clip-time is {} s", *wishes.clip_time_s);
    throw std::invalid_argument{
        stage.scene->clips.empty()
            ? fmt::format("{}, but {} has no clips", option, file.string())
            : fmt::format("{}, but nothing that moves is in the default scene of {}", option, file.string())};
}

/// The node of the file's camera that was asked for, else of its first.
std::optional<std::uint32_t> chosen_camera(const fs::path& file, const ViewWishes& wishes,
                                           const assets::Scene& scene) {
    const std::optional<std::uint32_t> node = find_camera(scene, wishes.camera.value_or(0));
    if (node || !wishes.camera) return node;
    std::uint32_t count = 0;
    while (find_camera(scene, count))
        ++count;
    throw std::invalid_argument{fmt::format(
        "--camera is {}, but {} has {}", *wishes.camera, file.string(),
        count == 0 ? "none" : fmt::format("only {}, counted from 0, in its default scene", count))};
}

systems::Eye eye_on_everything(const assets::Bounds& box, const ViewWishes& wishes) {
    const glm::vec2 size{wishes.size_px};
    systems::Eye eye = eye_of(frame_bounds(box, k_fov_rad, size.x / size.y), wishes.origin);
    eye.vertical_fov_rad = k_fov_rad;
    return eye;
}

/// Shadows reach as far as the model does, whatever its scale, unless the user has said how far.
render::Settings settings_for(const ViewWishes& wishes, const systems::Eye& eye, const assets::Bounds& box,
                              float exposure_ev) {
    render::Settings settings = wishes.settings;
    if (!wishes.own_exposure) settings.exposure.ev = exposure_ev;
    if (wishes.own_shadows || box.empty()) return settings;
    const glm::vec3 to_centre = systems::offset_m(eye.place, wishes.origin) + box.centre();
    settings.shadows.distance_m = glm::length(to_centre) + glm::length(box.half_extents());
    return settings;
}

}  // namespace

ModelView view_model(const fs::path& file, const ViewWishes& wishes) {
    assets::Scene scene = assets::import_gltf(file);
    const ViewingLight light = viewing_light(scene, wishes.time);
    if (wishes.time) remove_suns(scene);
    ModelView view;
    view.stage = make_stage(std::move(scene), light.environment, wishes.origin);
    Stage& stage = view.stage;
    view.camera = chosen_camera(file, wishes, *stage.scene);
    const std::optional<std::uint32_t> clip = chosen_clip(file, wishes, stage);
    if (clip) show_clip(stage, *clip, wishes.clip_time_s.value_or(0.0));
    view.box = clip && wishes.plays ? clip_bounds(stage, *clip)
                                    : shown_bounds(*stage.world, *stage.scene, stage.origin);
    view.eye = view.camera ? camera_eye(stage, *view.camera, 1.0f) : eye_on_everything(view.box, wishes);
    view.eye.size_px = wishes.size_px;
    view.settings = settings_for(wishes, view.eye, view.box, light.exposure_ev);
    return view;
}

ModelPicture draw_model(render::RenderThread& thread, ModelView& view, bool linear, bool quiet,
                        std::shared_ptr<const void> hud, RunTrace* trace) {
    Stage& stage = view.stage;
    hand_over(prepare_scene(*stage.scene, thread.device(), quiet), stage, thread);
    if (trace) trace->listen_to(*stage.world);
    render::FrameInput& input = thread.begin();
    systems::build_frame(*stage.world, sampled(view.eye, view.settings.anti_aliasing, thread.device()), 1.0f,
                         input.frame);
    input.frame.capture = {.display = !linear, .linear = linear};
    input.frame.hud = std::move(hud);
    input.settings = view.settings;
    input.complete_textures = true;
    input.timers = trace ? render::PassTimers::stamped : render::PassTimers::off;
    const systems::FrameCounts counts = input.frame.counts;
    thread.submit();
    thread.finish();
    std::vector<render::FrameOutput> outputs = thread.collect();
    render::FrameOutput& drawn = outputs.at(0);
    if (trace) trace->add(drawn.feedback);
    std::optional<assets::Image>& image = linear ? drawn.linear : drawn.display;
    return {std::move(image.value()), counts, std::move(drawn.feedback)};
}

nlohmann::json picture_facts(const ModelView& view, const ModelPicture& picture) {
    nlohmann::json facts{{"entities", view.stage.world->entity_count()},
                         {"visible", picture.counts.visible},
                         {"lights", picture.counts.lights},
                         {"draws", picture.feedback.draws},
                         {"triangles", picture.feedback.triangles},
                         {"textures", textures_json(picture.feedback.textures)}};
    facts.update(clip_facts(view.stage));
    return facts;
}

nlohmann::json clip_facts(const Stage& stage) {
    nlohmann::json facts{{"clips", stage.scene->clips.size()}, {"clip", nullptr}, {"clip_time_s", nullptr}};
    if (stage.player == ecs::Entity{}) return facts;
    const systems::ClipCursor& playing = stage.world->get<systems::AnimationPlayer>(stage.player).playing;
    if (playing.clip == assets::k_none) return facts;
    facts["clip"] = clip_label(*stage.scene, playing.clip);
    facts["clip_time_s"] = playing.time_s;
    return facts;
}

}  // namespace rambla::game
