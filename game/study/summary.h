#pragma once

#include <string>

#include "game/study/result.h"

namespace rambla::game::study {

/// A study's grades as aligned text, for a terminal: by scene, milliseconds with the interval of their
/// rounds, the ratio to the cheapest, bytes, and metrics.
[[nodiscard]] std::string to_text(const StudyResult& result);

}  // namespace rambla::game::study
