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
        const std::vector<unsigned char> glb = glb_of(seed);
        take(seed.name + ".glb", std::as_bytes(std::span{glb}));
    }
}

const Registration k_glb{{"glb", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
