#pragma once

#include <string>
#include <vector>

#include "game/study/report/json.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// The page that shows studies: one HTML file with everything inside that opens from disk and needs no
/// scripts.
/// @param runs   in the page's order
/// @param facts  of the newest run; a section whose own facts are others states them
[[nodiscard]] std::string to_page(const std::vector<StudyRun>& runs, const RunFacts& facts);

}  // namespace rambla::game::study
