#include <algorithm>
#include <string>

#include "assets/error.h"
#include "assets/export/gltf.h"
#include "assets/import/gltf.h"
#include "fuzz/gltf_seeds.h"
#include "fuzz/scratch.h"
#include "fuzz/target.h"
#include "support/scene_check.h"

namespace rambla::fuzz {
namespace {

/// The exporter writes PNG, and compressing large pictures would take the time.
bool has_small_pictures(const assets::Scene& scene) {
    constexpr std::uint32_t k_small_px = 64;
    return std::all_of(scene.images.begin(), scene.images.end(), [](const assets::Image& image) {
        return image.format == assets::PixelFormat::rgba8 && image.width <= k_small_px &&
               image.height <= k_small_px;
    });
}

/// glTF has no meshes without triangles, lines or points.
std::ptrdiff_t shown_models(const assets::Scene& scene) {
    return std::count_if(scene.models.begin(), scene.models.end(), [&](const assets::Model& model) {
        return std::any_of(model.parts.begin(), model.parts.end(), [&](const assets::ModelPart& part) {
            return !scene.meshes[part.mesh].indices.empty();
        });
    });
}

assets::Scene import_again(const std::filesystem::path& file) {
    try {
        return assets::import_gltf(file);
    } catch (const assets::Error& error) {
        broken("what was exported can be imported: " + std::string{error.what()});
    }
}

void expect_same(const assets::Scene& first, const assets::Scene& back) {
    if (const std::string problem = assets::test::problem_of(back); !problem.empty())
        broken("what was exported is sound: " + problem);
    if (first.nodes.size() != back.nodes.size() || first.materials.size() != back.materials.size() ||
        shown_models(first) != shown_models(back) || first.roots != back.roots)
        broken("an export holds what the scene held");
}

/// The input is a GLB file. One that loads can be exported, and loads again.
void run(Bytes bytes) {
    constexpr std::uint32_t k_largest_picture_px = 2048;
    assets::Scene first;
    try {
        first =
            assets::import_gltf(write_scratch("input.glb", bytes), {.image_size_px = k_largest_picture_px});
    } catch (const assets::Error&) {
        return;
    }
    if (!has_small_pictures(first)) return;
    const std::filesystem::path file = scratch_folder() / "exported.glb";
    assets::export_gltf(file, first);
    expect_same(first, import_again(file));
}

void seeds(const SeedTaker& take) {
    for (const GltfSeed& seed : gltf_seeds()) {
        const std::vector<unsigned char> glb = glb_of(seed);
        take(seed.name + ".glb", std::as_bytes(std::span{glb}));
    }
}

const Registration k_export{{"export", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
