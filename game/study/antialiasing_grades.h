#pragma once

#include <cstdint>
#include <vector>

#include "game/study/in_turns.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// How much of the past a picture of a grade wants.
enum class Past : std::uint8_t {
    moment,  ///< enough for what it does each time: it is timed
    settled  ///< enough to look as it will for as long as nothing moves
};

/// Every method of --aa with its presets; the first is `none`, without anti-aliasing. Those that take from
/// earlier pictures draw some before each.
[[nodiscard]] std::vector<PictureGrade> antialiasing_grades(const StudyContext& context, Past past);

/// The same picture from `samples` × `samples` pixels for each that is shown.
[[nodiscard]] PictureGrade supersampled(const StudyContext& context, std::uint32_t samples);

/// The picture from which true edges are taken: what is on the meshes would look like some.
[[nodiscard]] PictureGrade bare_surfaces(const StudyContext& context, std::uint32_t samples);

/// What anti-aliasing takes of each round: passes that are not there without it, and how much longer those
/// take that write more bytes with it.
/// @param plain  the costs of `none` in the same rounds
[[nodiscard]] std::vector<double> antialiasing_ms(const PictureCost& cost, const PictureCost& plain);

/// Its share of the frame, how much longer the whole frame takes, and the most transient memory of a frame
/// more than without it.
[[nodiscard]] std::vector<Metric> cost_metrics(const PictureCost& cost, const PictureCost& plain);

/// Memory that the renderer holds for each grade when it draws nothing else, textures of the scene left out:
/// targets, history and buffers.
[[nodiscard]] Table held_memory(StudyContext& context, Stage& stage, const systems::Eye& eye);

}  // namespace rambla::game::study
