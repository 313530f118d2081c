#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/stage.h"
#include "game/study/study.h"

namespace rambla::game::study {

/// A way to draw a picture that is compared with others.
struct PictureGrade {
    std::string name;  ///< as the command line takes it
    render::Settings settings;
    /// Takes something out of the Frame that the scene put there; may be empty.
    std::function<void(systems::Frame&)> change{};
    bool follows =
        false;  ///< the picture drawn before, as in a film; else pictures know nothing of each other
    /// Drawn of the same moment before each picture, for what takes from earlier ones.
    std::uint32_t frames_before = 0;
};

/// What a grade told of each round.
struct PictureCost {
    std::vector<systems::Feedback> rounds;
};

/// Gives a stage's scene to the context's renderer, and waits until it is there.
/// @return  what was made of it
std::shared_ptr<const assets::ProcessedScene> show(StudyContext& context, Stage& stage);

/// Draws one picture, each pass timed alone, and waits for it; before it, those that the grade wants before.
/// The Frame's steps are the newest.
[[nodiscard]] render::FrameOutput draw(render::RenderThread& thread, Stage& stage, const PictureGrade& grade,
                                       const systems::Eye& eye, systems::CaptureRequest capture = {});

using EyeOfRound = std::function<systems::Eye(std::uint32_t)>;

/// Draws a picture in each grade, round after round, A B C A B C, so that what slows the machine for a while
/// slows all of them; who begins changes from round to round, and a round before the first does not count.
/// Ends early when the context is stopped: all grades then have the same rounds, or there is nothing at all.
[[nodiscard]] std::vector<PictureCost> draw_in_turns(StudyContext& context, Stage& stage,
                                                     std::span<const PictureGrade> grades,
                                                     const EyeOfRound& eye, std::uint32_t rounds,
                                                     const std::string& what);

/// Eyes of a stage's walk, `rounds` of them evenly spread over it.
[[nodiscard]] EyeOfRound along_the_walk(const Stage& stage, glm::uvec2 size_px, std::uint32_t rounds);

/// Time of the passes of these names in a picture.
[[nodiscard]] double sum_ms(const systems::Feedback& feedback, std::span<const std::string_view> passes);
/// The same of each round.
[[nodiscard]] std::vector<double> sums_ms(const PictureCost& cost, std::span<const std::string_view> passes);
/// First command to last, of each round.
[[nodiscard]] std::vector<double> frames_ms(const PictureCost& cost);
/// Most transient memory that is alive at one time of a picture, of all rounds.
[[nodiscard]] double transient_bytes(const PictureCost& cost);

/// "1280x720"
[[nodiscard]] std::string size_text(glm::uvec2 size_px);

}  // namespace rambla::game::study
