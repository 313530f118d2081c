#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

#include "assets/bounds.h"

namespace rambla::assets {

enum class Topology : std::uint8_t { triangles, lines, points };

/// What one morph target adds at weight 1. Columns are either empty or as long as the mesh's positions.
struct MorphTarget {
    std::string name;
    std::vector<glm::vec3> positions;  ///< metres
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;  ///< the handedness does not change
};

/// Indexed geometry of one material. Columns are either empty or as long as `positions`.
struct Mesh {
    std::string name;
    Topology topology = Topology::triangles;
    std::vector<glm::vec3> positions;  ///< metres
    std::vector<glm::vec3> normals;    ///< unit length
    std::vector<glm::vec4> tangents;   ///< xyz unit length, w = ±1: bitangent = w · (normal × tangent)
    std::vector<glm::vec2> uv0;        ///< v = 0 is the top row of an image
    std::vector<glm::vec2> uv1;
    std::vector<glm::vec4> colours;    ///< linear RGBA, multiplied with the base colour; empty means white
    std::vector<glm::u16vec4> joints;  ///< rows of the skeleton's joints that move a vertex, strongest first
    std::vector<glm::vec4> weights;    ///< of those joints, ≥ 0, of sum 1; empty: the mesh is not skinned
    std::vector<MorphTarget> morphs;
    std::vector<std::uint32_t>
        indices;    ///< lists (no strips or fans); counter-clockwise triangles face front
    Bounds bounds;  ///< of the positions, neither skinned nor morphed
};

}  // namespace rambla::assets
