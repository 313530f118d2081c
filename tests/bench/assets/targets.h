#pragma once

#include "bench/assets/inputs.h"
#include "bench/harness/target.h"

namespace rambla::bench {

/// Of the time that importing a file takes without pictures and mesh processing, tinygltf's share: what we
/// add on top must cost less than reading and parsing.
inline constexpr Target import_target(std::string_view operation, std::string_view reason) {
    return {.operation = operation, .measure = Measure::share, .solid = 0.5, .goal = 0.67, .reason = reason};
}

inline constexpr Target k_assets_targets[]{
    import_target(k_generated_mesh, "2 million triangles in one mesh: copying is all there is to do"),
    import_target(k_generated_city, "many meshes and nodes"),
    import_target(k_tokyo, "a dense scene with a clip that must be mended"),
    import_target(k_helmet, "three million bytes of vertices in one file beside the document"),
    import_target(k_knight, "76 clips, a skin"),
    import_target(k_transmission, "primitives that share accessors"),
    import_target(k_garage, "many small primitives, a large document"),
    import_target(k_morphs, "morph targets"),
};

}  // namespace rambla::bench
