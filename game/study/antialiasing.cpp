// Methods of anti-aliasing on the street: edges, textures, motion, and what they cost.
#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "game/study/antialiasing_grades.h"
#include "game/study/antialiasing_motion.h"
#include "game/study/antialiasing_stills.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_rounds = 7;
constexpr glm::uvec2 k_size_px{960, 540};
/// Sequences are of hundreds of pictures.
constexpr glm::uvec2 k_sequence_px{640, 360};
/// From the way of the walk down to the pavement on the right, whose tiles are the finest pattern of the
/// street.
constexpr float k_look_down_rad = -0.9f;
constexpr float k_look_right_rad = -0.8f;

systems::Eye looking_down(systems::Eye eye) {
    eye.rotation = glm::angleAxis(k_look_right_rad, glm::vec3{0, 1, 0}) * eye.rotation *
                   glm::angleAxis(k_look_down_rad, glm::vec3{1, 0, 0});
    return eye;
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Anti-aliasing";
    result.question =
        "How jagged does each method leave edges of geometry, what does it blur that is no edge, what "
        "flickers and what trails behind motion, and for how many milliseconds and bytes? The street at "
        "noon, without glow, at a fixed exposure. Milliseconds are those of passes that are not there "
        "without anti-aliasing, and how much longer those take that write more with it. "
        "Those of taa are of a picture at rest: where the eye moves it filters its past, and what moves is "
        "drawn once "
        "more.";
    result.reference =
        "The mean of 64 pixels for one that is shown (ssaa:samples=8; 16 for moving pictures), in linear "
        "light of the display: the pixel of a straight edge is off by 1/16 of its contrast at most. Edges "
        "are "
        "pixels within 1.5 of where the object, the mesh's normal or its distance changes in the renderer's "
        "own captures; textures are those more than 3 away from all of them. RMS errors, local contrast "
        "(standard deviation in 3×3 pixels) and trails are of what a display is sent, sRGB-encoded, in "
        "percent of its range; flicker is of linear light. Finer pixels take finer levels of textures: some "
        "contrast is lost against the reference without any smoothing, and what a method itself takes is "
        "contrast_lost_of_none_pct. trail_frames counts the frames in which pixels that walkers and cars "
        "have uncovered are farther from the reference than without anti-aliasing, by more than 1 % of the "
        "display's range in their mean.";
    result.plotted_metric = "edge_rms_pct";
    Stage stage = make_stage("street", context.options().seed, {}, {});
    static_cast<void>(show(context, stage));
    const std::uint32_t rounds = context.rounds(k_rounds);
    for (const glm::uvec2 size_px : context.sizes({k_size_px})) {
        const EyeOfRound walk = along_the_walk(stage, size_px, rounds);
        measure_stills(context, stage,
                       {.scene = fmt::format("street at noon, {}", size_text(size_px)),
                        .eye = walk,
                        .rounds = rounds,
                        .shown = Stills::Shown::edges},
                       result);
        if (context.stopped()) return;
        measure_stills(context, stage,
                       {.scene = fmt::format("paving at noon, {}", size_text(size_px)),
                        .eye = [&](std::uint32_t round) { return looking_down(walk(round)); },
                        .rounds = rounds,
                        .shown = Stills::Shown::textures},
                       result);
        if (context.stopped()) return;
        result.tables.push_back(held_memory(context, stage, walk(0)));
    }
    for (const glm::uvec2 size_px : context.sizes({k_sequence_px})) {
        if (context.stopped()) return;
        const systems::Eye eye = busiest_eye(context, stage, size_px);
        measure_slow_motion(context, stage, eye, result);
        if (context.stopped()) return;
        measure_trails(context, stage, eye, result);
    }
}

}  // namespace

const Study k_antialiasing_study{
    .name = "antialiasing", .summary = "edges, textures, motion and cost of every --aa", .run = run};

}  // namespace rambla::game::study
