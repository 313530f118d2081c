#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/scene.h"
#include "render/render_thread.h"

namespace rambla::render {

/// Small frames that between them make every pass draw with every material of a scene, under every choice of
/// tone curve, anti-aliasing and shadows that picks another program, and else under the given settings:
/// drivers compile for the state in which a program is first used, up to 400 ms on the software rasteriser,
/// so this is spent before the first real frame.
/// @param fading  materials that are also drawn as what fades
[[nodiscard]] std::vector<FrameInput> warm_up_frames(const assets::Scene& scene, const Settings& settings,
                                                     std::span<const std::uint32_t> fading = {});

}  // namespace rambla::render
