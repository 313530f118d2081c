#pragma once

#include <cstdint>
#include <vector>

#include "render/render_thread.h"

namespace rambla::game::study {

/// Where the geometry of a picture has edges: neighbours that show different objects, surfaces that bend by
/// more than 20° from one to the next, or a surface that another one of the same object hides from there on.
/// @param objects   of the picture as it is drawn
/// @param surfaces  of the same size; normals of the mesh, without normal maps
/// @param samples   pixels drawn for one that is shown, across and down: thinner things are found with more
/// @return          per pixel that is shown, row-major: 1 where an edge crosses it or its rim, on both sides
[[nodiscard]] std::vector<std::uint8_t> geometric_edges(const render::ObjectImage& objects,
                                                        const render::SurfaceImages& surfaces,
                                                        std::uint32_t samples);

}  // namespace rambla::game::study
