#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "game/study/result.h"

namespace rambla::game::study {

/// A study together with what its numbers depend on.
struct StudyRun {
    StudyResult result;
    RunFacts facts;
};

/// All of a study, every round included, as one JSON object of the schema "rambla.study/1". Numbers that JSON
/// cannot hold are the texts "inf", "-inf" and "nan". Bytes that are no UTF-8 become U+FFFD. Of pictures it
/// has titles, labels and the names of their files.
[[nodiscard]] std::string to_json(const StudyRun& run);

/// What to_json() wrote; pictures are without texels. Members that are not known are passed over.
/// @param text  from anywhere
/// @param file  named in errors
/// @throws assets::Error  naming file and element, what is there and what should be
[[nodiscard]] StudyRun from_json(std::string_view text, const std::string& file);

/// @throws assets::Error  if the file cannot be read, or as from_json() does
[[nodiscard]] StudyRun read_study(const std::filesystem::path& file);

}  // namespace rambla::game::study
