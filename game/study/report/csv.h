#pragma once

#include <string>

#include "game/study/result.h"

namespace rambla::game::study {

/// A study as comma-separated values with a head line: study,scene,grade,metric,value,unit,ms,ms_ratio,bytes.
/// One row for each scene × grade × metric; a grade without metrics has one row whose metric, value and unit
/// are empty, and ms and ms_ratio are empty where nothing was timed. Quoted as RFC 4180 says, but with the
/// line ends of Unix. Numbers read back to the same double in any locale; those that are not finite are inf,
/// -inf and nan.
[[nodiscard]] std::string to_csv(const StudyResult& result);

}  // namespace rambla::game::study
