#include "fuzz/import_check.h"

#include <string>

#include "assets/error.h"
#include "assets/import/gltf.h"
#include "fuzz/target.h"
#include "support/scene_check.h"

namespace rambla::fuzz {

void check_import(const std::filesystem::path& file) {
    // Time goes into pictures that are large and empty otherwise.
    constexpr std::uint32_t k_largest_picture_px = 2048;
    try {
        const assets::Scene scene = assets::import_gltf(file, {.image_size_px = k_largest_picture_px});
        const std::string problem = assets::test::problem_of(scene);
        if (!problem.empty()) broken("an imported scene is sound: " + problem);
    } catch (const assets::Error& error) {
        if (std::string{error.what()}.find('\n') != std::string::npos)
            broken("an error is one line: " + std::string{error.what()});
    }
}

}  // namespace rambla::fuzz
