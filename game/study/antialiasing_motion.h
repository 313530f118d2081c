#pragma once

#include "game/study/in_turns.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// Of eyes along the walk, the one before which most pixels show what moves.
[[nodiscard]] systems::Eye busiest_eye(StudyContext& context, Stage& stage, glm::uvec2 size_px);

/// What flickers while an eye turns by a fraction of a pixel from picture to picture.
void measure_slow_motion(StudyContext& context, Stage& stage, const systems::Eye& eye, StudyResult& result);

/// Traces of what moves before an eye at rest. The stage's world walks on, and is afterwards as it was.
void measure_trails(StudyContext& context, Stage& stage, const systems::Eye& eye, StudyResult& result);

}  // namespace rambla::game::study
