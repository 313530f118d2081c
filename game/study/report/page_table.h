#pragma once

#include <string>

#include "game/study/report/timing.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// The grades of a scene as an HTML block: what each cost, what it keeps, how far it was off; the cheapest
/// grade and those on the Pareto front are marked.
/// @param plotted_metric  whose front is meant; may be empty
[[nodiscard]] std::string grades_block(const SceneGrades& scene, const std::string& plotted_metric);

/// A study's further table as an HTML block. Columns in which every cell begins like a number are aligned
/// right.
[[nodiscard]] std::string table_block(const Table& table);

}  // namespace rambla::game::study
