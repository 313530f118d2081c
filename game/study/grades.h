#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "game/parameters.h"
#include "game/study/in_turns.h"

namespace rambla::game::study {

/// Settings under which a pixel's colour depends on nothing but what it shows: for pictures that are compared
/// with others, or with what was computed for each pixel alone.
[[nodiscard]] inline render::Settings plain_settings() {
    render::Settings settings;
    settings.exposure.mode = render::ExposureMode::fixed;
    settings.bloom.method = render::BloomMethod::off;
    return settings;
}

/// The grade that one option of the command line makes: everything else stays as `settings` has it.
/// @param name   of the grade, such as "tiled:prepass=1", which is also what the option is given
/// @param table  of the option's struct, `part` that struct within the settings
template <class Struct, std::size_t Count>
[[nodiscard]] PictureGrade grade_of(std::string name, const std::array<Parameter<Struct>, Count>& table,
                                    Struct render::Settings::*part, const render::Settings& settings) {
    PictureGrade grade{.name = std::move(name), .settings = settings};
    set_from_method_text(bind(table, grade.settings.*part), grade.name);
    return grade;
}

}  // namespace rambla::game::study
