#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace rambla::bench {

/// A glTF file to import, by the name of its benchmark.
struct Input {
    std::string_view operation;
    std::filesystem::path file;
};

/// Operations that inputs() measures, where it finds the corpus of sample files.
inline constexpr std::string_view k_generated_mesh = "import_generated_mesh";
inline constexpr std::string_view k_generated_city = "import_generated_city";
inline constexpr std::string_view k_tokyo = "import_LittlestTokyo";
inline constexpr std::string_view k_helmet = "import_FlightHelmet";
inline constexpr std::string_view k_knight = "import_Knight";
inline constexpr std::string_view k_transmission = "import_TransmissionTest";
inline constexpr std::string_view k_garage = "import_garage";
inline constexpr std::string_view k_morphs = "import_MorphStressTest";

/// Files of the corpus and generated ones, which are written to `folder` without pictures: one mesh of two
/// million triangles, and a city of many meshes and nodes. A missing corpus is told on standard error.
[[nodiscard]] std::vector<Input> inputs(const std::filesystem::path& folder);

}  // namespace rambla::bench
