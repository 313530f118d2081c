#pragma once

#include "game/study/result.h"
#include "game/study/study.h"

namespace rambla::game::study {

/// What the numbers of a run depend on: processor, threads, driver, compiler, version, date and seed.
[[nodiscard]] RunFacts run_facts(StudyContext& context);

}  // namespace rambla::game::study
