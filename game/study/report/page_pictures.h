#pragma once

#include <string>

#include "game/study/result.h"

namespace rambla::game::study {

/// A study's rows of pictures as HTML blocks with the pictures inside, side by side where there is room, each
/// a link to its file. Small ones are enlarged by a whole factor, so that every pixel is a square. One that
/// cannot be shown is a sentence that says why.
[[nodiscard]] std::string pictures_html(const StudyResult& study);

}  // namespace rambla::game::study
