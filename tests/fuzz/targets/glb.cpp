#include "assets/import/gltf_container.h"
#include "fuzz/gltf_seeds.h"
#include "fuzz/import_check.h"
#include "fuzz/scratch.h"
#include "fuzz/target.h"

namespace rambla::fuzz {
namespace {

/// The input is a GLB file.
void run(Bytes bytes) {
    check_import(write_scratch("input.glb", bytes));
}

void seeds(const SeedTaker& take) {
    for (const GltfSeed& seed : gltf_seeds()) {
        const auto* const first = reinterpret_cast<const unsigned char*>(seed.buffer.data());
        const std::vector<unsigned char> glb =
            assets::gltf::join_container(seed.json, {first, seed.buffer.size()});
        take(seed.name + ".glb", std::as_bytes(std::span{glb}));
    }
}

const Registration k_glb{{"glb", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
