#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "game/study/report/json.h"
#include "game/study/report/order.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// Writes NAME.csv, NAME.json and, where there is something to draw, NAME.svg for each study, its pictures as
/// NAME-ROW-PICTURE.png, and index.html with the sections of these studies and of those of earlier runs whose
/// NAME.json lies in the folder. An earlier file that cannot be read is warned of and left out. Each file
/// appears whole or not at all; a missing folder is made.
/// @param results  with names of lower-case letters, digits, - and _ that differ
/// @param facts    of the run that they come from
/// @param order    names of studies in the page's order; those that it does not have follow by name
/// @throws assets::Error  naming the file that cannot be written
void write_report(const std::filesystem::path& folder, std::span<const StudyResult> results,
                  const RunFacts& facts, std::span<const std::string> order = {});

}  // namespace rambla::game::study
