#pragma once

#include <string>

#include "game/study/in_turns.h"
#include "game/study/result.h"

namespace rambla::game::study {

/// Eyes at rest, and which of their pictures' parts are shown.
struct Stills {
    std::string scene;
    EyeOfRound eye;
    std::uint32_t rounds = 1;
    enum class Shown : std::uint8_t { edges, textures };
    Shown shown = Shown::edges;
};

/// Times every grade of anti-aliasing, compares its pictures with the reference, and adds the grades and a
/// row of enlarged crops to the result.
void measure_stills(StudyContext& context, Stage& stage, const Stills& stills, StudyResult& result);

}  // namespace rambla::game::study
