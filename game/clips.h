#pragma once

#include <cstdint>
#include <string>

#include "assets/bounds.h"
#include "assets/scene.h"
#include "game/app.h"
#include "game/stage.h"
#include "game/step_clock.h"

namespace rambla::game {

/// What a clip is called where there is a user to read it: its name, or its number if it has none.
[[nodiscard]] std::string clip_label(const assets::Scene& scene, std::uint32_t clip);

/// The clip that a user means: the first of that name, else the one of that number, counted from 0.
/// @param file  for the message
/// @throws std::invalid_argument  naming the clips that there are
[[nodiscard]] std::uint32_t find_clip(const assets::Scene& scene, const std::string& wanted,
                                      const std::string& file);

/// Shows a clip at a time and at rest there; a time beyond its ends enters again at the other end.
void show_clip(Stage& stage, std::uint32_t clip, double time_s);

/// Box around all that a stage shows while a clip plays, seen from the stage's origin.
[[nodiscard]] assets::Bounds clip_bounds(Stage& stage, std::uint32_t clip);

/// Plays the clips of a stage in real time and lets its user choose among them. Does nothing where there are
/// none.
class ClipPlayback {
public:
    /// Goes on from what show_clip() has shown.
    explicit ClipPlayback(Stage& stage);

    /// Follows the keys, and simulates what has become due. @return  the interpolation of the next picture
    float update(const Moment& moment);

    /// Whether there is anything to play; if not, what follows is not for calling.
    [[nodiscard]] bool has_clips() const { return stage_.player != ecs::Entity{}; }
    [[nodiscard]] const assets::Scene& scene() const { return *stage_.scene; }
    [[nodiscard]] std::uint32_t clip() const;
    [[nodiscard]] double time_s() const;
    [[nodiscard]] double duration_s() const;  ///< of the clip
    [[nodiscard]] float speed() const { return speed_; }
    /// Flows into another clip, from its beginning.
    void choose(std::uint32_t clip);
    /// Goes to a time of the clip at once, even while nothing moves.
    void seek(double time_s);
    /// @param speed  1: as the file says; 0 stands, below 0 runs backwards
    void set_speed(float speed);

    [[nodiscard]] std::uint64_t steps() const { return steps_; }
    /// Which clip plays, where and how fast, as one line: for a few seconds after that changed, else empty.
    [[nodiscard]] std::string caption() const;

private:
    void follow_keys(const Input& input);

    Stage& stage_;
    StepClock clock_;
    float speed_ = 1.0f;
    double caption_left_s_;
    std::uint64_t steps_ = 0;
};

}  // namespace rambla::game
