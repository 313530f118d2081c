#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "assets/bounds.h"
#include "assets/lod.h"
#include "assets/material.h"
#include "assets/mesh.h"
#include "assets/texture_data.h"

namespace rambla::assets {

/// A ball in metres; a negative radius is an empty one.
struct BoundingSphere {
    glm::vec3 centre{0.0f};
    float radius = -1.0f;
};

/// What hides at most what a closed mesh hides: boxes wholly inside of it.
struct OccluderProxy {
    std::vector<Bounds> boxes;  ///< may overlap; empty for meshes that are open, small or thin
    float volume_share = 0.0f;  ///< of the enclosed volume that the boxes fill
    float gap_m = 0.0f;         ///< no point of the mesh is farther from the boxes; 0 without boxes
};

/// A mesh as it is drawn.
struct ProcessedMesh {
    Mesh mesh;  ///< vertices and triangles in a good order, bounds of what is used
    LodChain lods;
    ShadowMesh shadow;
    BoundingSphere sphere;  ///< of the positions, neither skinned nor morphed
    OccluderProxy occluder;
};

/// What drawing needs of a Scene beyond its nodes, models, cameras, lights, skeletons and clips, which go on
/// referring to meshes and materials by the same indices.
struct ProcessedScene {
    std::vector<ProcessedMesh> meshes;  ///< one for each of the scene
    /// One for each of the scene; slots refer to `textures` below, and roughness is 1 where the texture
    /// contains it.
    std::vector<Material> materials;
    std::vector<Texture> textures;    ///< `image` refers to `images` below
    std::vector<TextureData> images;  ///< each use of a picture once
};

}  // namespace rambla::assets
