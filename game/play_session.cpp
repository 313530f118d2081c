#include "game/play_session.h"

namespace rambla::game {
namespace {

constexpr float k_look_rad_per_px = 0.0022f;  // half a turn for a hand's width of mouse at common resolutions
constexpr float k_turn_rad_s = 1.9f;

Player first_player(const Stage& stage, Surroundings& surroundings) {
    if (stage.walk.empty())
        return player_at(stage.origin, {0.0f, k_eye_height_m, 0.0f}, {0.0f, 0.0f, -1.0f}, surroundings);
    return player_at(stage.origin, stage.walk.front().eye_m, stage.walk.front().target_m, surroundings);
}

float axis(const Input& input, Action positive, Action negative) {
    return (input.held(positive) ? 1.0f : 0.0f) - (input.held(negative) ? 1.0f : 0.0f);
}

}  // namespace

PlaySession::PlaySession(Stage& stage)
    : stage_{stage},
      surroundings_{*stage.world, *stage.scene},
      before_{first_player(stage, surroundings_)},
      now_{before_} {}

void PlaySession::listen(const Moment& moment) {
    const Input& input = moment.input;
    intent_.move = glm::vec2{0.0f};
    intent_.run = input.held(Action::run);
    if (!moment.keys_free) return;
    intent_.move = {axis(input, Action::right, Action::left), axis(input, Action::forward, Action::back)};
    intent_.jump = intent_.jump || input.pressed(Action::jump);
    if (!moment.pointer_free) return;
    intent_.turn_rad -= k_look_rad_per_px * input.pointer_way().x;
    intent_.pitch_rad -= k_look_rad_per_px * input.pointer_way().y;
}

Shot PlaySession::update(const Moment& moment) {
    const bool paused = moment.elapsed_s <= 0.0;
    if (!paused) listen(moment);
    const std::uint32_t due = clock_.advance(moment.elapsed_s);
    for (std::uint32_t i = 0; i < due; ++i) {
        before_ = now_;
        PlayerIntent intent = intent_;
        if (moment.keys_free) {
            intent.turn_rad += axis(moment.input, Action::turn_left, Action::turn_right) * k_turn_rad_s *
                               static_cast<float>(systems::k_step_s);
        }
        step(now_, intent, surroundings_);
        systems::step(*stage_.world);
        ++steps_;
        // The mouse's way and a jump happen once, however many steps lie between two pictures.
        intent_.turn_rad = 0.0f;
        intent_.pitch_rad = 0.0f;
        intent_.jump = false;
    }
    return {.eye = eye_of(before_, now_, clock_.interpolation()),
            .interpolation = clock_.interpolation(),
            .steps = steps_};
}

}  // namespace rambla::game
