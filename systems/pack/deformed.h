#pragma once

#include <cstdint>
#include <vector>

#include "systems/components.h"
#include "systems/frame.h"
#include "systems/look/observer.h"
#include "systems/simulate/clip_library.h"
#include "systems/simulate/deformation.h"

namespace rambla::systems {

/// What packing reads of skins and morphs.
struct DeformationSource {
    const Deformations& poses;
    const ClipLibrary& library;
};

/// Writes the joints and morph terms of what is drawn to the Frame: each skin and each morph once, however
/// many renderables share it, and nothing of what is neither seen nor casts a shadow. Keeps its memory.
class PackDeformed {
public:
    /// Empties the Frame's columns.
    void begin(const DeformationSource& source, Frame& frame);

    /// Instance::joints of a renderable with this skin.
    [[nodiscard]] std::uint32_t joints_of(const DeformationSource& source, const SkinPose& pose,
                                          const Observer& observer, Frame& frame);
    /// Instance::morphs of a renderable.
    [[nodiscard]] static std::uint32_t morphs_of(const DeformationSource& source, const Morphed& morphed,
                                                 std::uint32_t mesh, float interpolation, Frame& frame);

private:
    std::vector<std::uint32_t> row_of_skin_;  ///< k_none until written
};

}  // namespace rambla::systems
