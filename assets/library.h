#pragma once

#include "assets/scene.h"

namespace rambla::assets {

/// Where the indices of an appended scene begin in the scene that took it.
struct SceneOffsets {
    std::uint32_t images = 0, textures = 0, materials = 0, meshes = 0, models = 0, cameras = 0, lights = 0,
                  emitters = 0, nodes = 0, skeletons = 0, clips = 0;
};

/// Moves all of `from` behind the contents of `into`, so that one scene's indices serve a whole world.
SceneOffsets append(Scene& into, Scene from);

}  // namespace rambla::assets
