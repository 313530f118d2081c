#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "game/study/result.h"

namespace rambla::game::study {

/// Largest width and height of a picture in the report. A picture of this size and 16:9 makes about a
/// megabyte of the page: a study cuts out what there is to see instead.
inline constexpr std::uint32_t k_most_picture_px = 960;

/// Why a picture of a row cannot be shown, as half a sentence: "it has 2 × 3000 pixels, …". Empty: it can.
/// Pictures have the size of the row's first one that can be shown.
/// @param index  below the number of the row's pictures
[[nodiscard]] std::string picture_fault(const PictureRow& row, std::size_t index);

/// The file that holds a picture, beside the study's other files: "bloom-2-1.png".
/// @param study        its name
/// @param row, picture  counted from 0
[[nodiscard]] std::string picture_file(const std::string& study, std::size_t row, std::size_t picture);

/// Writes every picture of a study that can be shown, warns of those that cannot, and removes what an earlier
/// run of the study has left besides. @throws assets::Error  naming the file that cannot be written
void write_pictures(const std::filesystem::path& folder, const StudyResult& study);

/// Reads the pictures of a study that has only their labels. One that is not there stays without texels, and
/// so does one that cannot be read, which is warned of.
void read_pictures(const std::filesystem::path& folder, StudyResult& study);

}  // namespace rambla::game::study
