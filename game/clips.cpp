#include "game/clips.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "game/shown_bounds.h"
#include "systems/simulate/animation.h"
#include "systems/simulate/clip_library.h"
#include "systems/simulate/sampling.h"

namespace rambla::game {
namespace {

/// Poses of a clip that its box is made of; what happens between them is small against the frame's rim of
/// air.
constexpr int k_bounds_poses = 32;
/// Clips flow into each other while a user looks for the one he wants.
constexpr float k_fade_s = 0.25f;
constexpr double k_caption_s = 4.0;
/// Speeds that the keys step through.
constexpr std::array k_speeds{-1.0f, 0.0f, 0.1f, 0.25f, 0.5f, 1.0f, 2.0f, 4.0f};

std::string all_clips(const assets::Scene& scene) {
    std::string list;
    for (std::uint32_t i = 0; i < scene.clips.size(); ++i)
        list += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, scene.clips[i].name);
    return list;
}

systems::AnimationPlayer& player_of(Stage& stage) {
    return stage.world->get_mut<systems::AnimationPlayer>(stage.player);
}

const systems::ClipCursor& playing_on(const Stage& stage) {
    return stage.world->get<systems::AnimationPlayer>(stage.player).playing;
}

}  // namespace

std::string clip_label(const assets::Scene& scene, std::uint32_t clip) {
    const std::string& name = scene.clips[clip].name;
    return name.empty() ? fmt::format("clip {}", clip) : name;
}

std::uint32_t find_clip(const assets::Scene& scene, const std::string& wanted, const std::string& file) {
    if (scene.clips.empty())
        throw std::invalid_argument{fmt::format("--clip is '{}', but {} has no clips", wanted, file)};
    for (std::uint32_t i = 0; i < scene.clips.size(); ++i) {
        if (scene.clips[i].name == wanted) return i;
    }
    std::uint32_t number = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, number);
    if (error == std::errc{} && stop == end && number < scene.clips.size()) return number;
    throw std::invalid_argument{fmt::format("--clip is '{}', but the clips of {} are {} (by name or number)",
                                            wanted, file, all_clips(scene))};
}

void show_clip(Stage& stage, std::uint32_t clip, double time_s) {
    const double duration_s = stage.world->resource<systems::ClipLibrary>().duration_s(clip);
    player_of(stage) = {.playing = {.clip = clip, .time_s = systems::time_in_clip(time_s, duration_s, true)},
                        .fading = {}};
    systems::settle_animation(*stage.world);
}

assets::Bounds clip_bounds(Stage& stage, std::uint32_t clip) {
    const systems::AnimationPlayer before = player_of(stage);
    const double duration_s = stage.world->resource<systems::ClipLibrary>().duration_s(clip);
    assets::Bounds box;
    for (int i = 0; i < k_bounds_poses; ++i) {
        show_clip(stage, clip, duration_s * i / (k_bounds_poses - 1));
        box.expand(shown_bounds(*stage.world, *stage.scene, stage.origin));
    }
    player_of(stage) = before;
    systems::settle_animation(*stage.world);
    return box;
}

ClipPlayback::ClipPlayback(Stage& stage) : stage_{stage}, caption_left_s_{k_caption_s} {}

float ClipPlayback::update(const Moment& moment) {
    if (!has_clips()) return 1.0f;
    caption_left_s_ -= moment.elapsed_s;
    if (moment.keys_free) follow_keys(moment.input);
    const std::uint32_t due = clock_.advance(moment.elapsed_s);
    for (std::uint32_t i = 0; i < due; ++i)
        systems::step(*stage_.world);
    steps_ += due;
    return clock_.interpolation();
}

std::uint32_t ClipPlayback::clip() const {
    return playing_on(stage_).clip;
}

double ClipPlayback::time_s() const {
    return playing_on(stage_).time_s;
}

double ClipPlayback::duration_s() const {
    return stage_.world->resource<systems::ClipLibrary>().duration_s(clip());
}

void ClipPlayback::choose(std::uint32_t clip) {
    caption_left_s_ = k_caption_s;
    systems::cross_fade(player_of(stage_), {.clip = clip, .speed = speed_}, k_fade_s);
}

void ClipPlayback::seek(double time_s) {
    caption_left_s_ = k_caption_s;
    show_clip(stage_, clip(), time_s);
    player_of(stage_).playing.speed = speed_;
}

void ClipPlayback::set_speed(float speed) {
    caption_left_s_ = k_caption_s;
    speed_ = speed;
    systems::AnimationPlayer& player = player_of(stage_);
    player.playing.speed = speed;
    player.fading.speed = speed;
}

std::string ClipPlayback::caption() const {
    if (!has_clips() || caption_left_s_ <= 0.0) return {};
    return fmt::format("{} ({} of {}): {:.2f} of {:.2f} s, speed {:g}", clip_label(*stage_.scene, clip()),
                       clip() + 1, stage_.scene->clips.size(), time_s(), duration_s(), speed_);
}

void ClipPlayback::follow_keys(const Input& input) {
    if (input.pressed(Action::next_clip)) {
        const auto count = static_cast<std::uint32_t>(stage_.scene->clips.size());
        const std::uint32_t way = input.with_shift(Action::next_clip) ? count - 1 : 1;
        choose((clip() + way) % count);
    }
    // The slider may stand between two of the keys' speeds.
    if (input.pressed(Action::faster)) {
        const auto* const next = std::upper_bound(k_speeds.begin(), k_speeds.end(), speed_);
        set_speed(next == k_speeds.end() ? speed_ : *next);
    }
    if (input.pressed(Action::slower)) {
        const auto* const here = std::lower_bound(k_speeds.begin(), k_speeds.end(), speed_);
        set_speed(here == k_speeds.begin() ? speed_ : *(here - 1));
    }
}

}  // namespace rambla::game
