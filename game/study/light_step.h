#pragma once

#include "game/stage.h"
#include "game/study/study.h"

namespace rambla::game::study {

/// Draws a film in which the scene's light steps up and down by six stops and back each time, and adds to the
/// result how exposure follows: a plot over time, and how far it is from the exponential in closed form and
/// beyond its targets.
/// @param grade  of --exposure, automatic
void follow_light_steps(StudyContext& context, Stage& stage, const std::string& grade, StudyResult& result);

}  // namespace rambla::game::study
