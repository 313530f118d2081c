#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assets/clip.h"
#include "assets/daylight.h"
#include "assets/emitter.h"
#include "assets/image.h"
#include "assets/material.h"
#include "assets/mesh.h"
#include "assets/skeleton.h"

namespace rambla::assets {

/// Local transform of a node: translation · rotation · scale.
struct Transform {
    glm::vec3 translation_m{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
};

[[nodiscard]] inline glm::mat4 matrix(const Transform& t) {
    const glm::mat3 r = glm::mat3_cast(t.rotation);
    return {glm::vec4{r[0] * t.scale.x, 0.0f}, glm::vec4{r[1] * t.scale.y, 0.0f},
            glm::vec4{r[2] * t.scale.z, 0.0f}, glm::vec4{t.translation_m, 1.0f}};
}

struct ModelPart {
    std::uint32_t mesh = k_none;
    std::uint32_t material = k_none;  ///< k_none: the default material of glTF
};

/// What a node shows: one or more meshes, each with its material. Shared by any number of nodes.
struct Model {
    std::string name;
    std::vector<ModelPart> parts;
    std::vector<float>
        morph_weights{};  ///< of its meshes' morph targets, where the node gives none of its own
};

enum class CameraKind : std::uint8_t { perspective, orthographic };

/// Looks along −Z of its node, +Y up.
struct Camera {
    std::string name;
    CameraKind kind = CameraKind::perspective;
    float vertical_fov_rad = 1.0f;  ///< perspective
    float half_height_m = 1.0f;     ///< orthographic
    float half_width_m = 1.0f;      ///< orthographic
    float near_m = 0.05f;
    float far_m = 1000.0f;  ///< orthographic only: perspective cameras see to infinity
};

enum class LightKind : std::uint8_t { directional, point, spot };

/// Shines along −Z of its node.
struct Light {
    std::string name;
    LightKind kind = LightKind::point;
    glm::vec3 colour{1.0f};
    float intensity = 1.0f;  ///< directional: illuminance, π lights white to radiance 1; others: intensity,
                             ///< illuminance · m²
    float range_m = 0.0f;    ///< 0: as far as its light matters
    float inner_cone_rad = 0.0f;
    float outer_cone_rad = 0.785398f;
};

struct Node {
    std::string name;
    std::uint32_t parent = k_none;
    std::vector<std::uint32_t> children;
    Transform local;
    std::uint32_t model = k_none;
    std::uint32_t camera = k_none;
    std::uint32_t light = k_none;
    std::uint32_t emitter = k_none;
    std::uint32_t skeleton = k_none;     ///< what moves the model's skinned meshes
    std::vector<float> morph_weights{};  ///< empty: those of the model
    std::vector<std::uint32_t>
        coarser{};  ///< nodes that show the same with less detail, finest first (MSFT_lod)
    std::vector<float>
        screen_coverage{};  ///< down to which this node and each of `coarser` serve, shares of the picture
};

/// Everything that one file, or one generator, holds. Indices refer to the vectors here; k_none is nothing.
struct Scene {
    std::string name;
    std::vector<Image> images;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Model> models;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<Emitter> emitters{};
    std::vector<Node> nodes;
    std::vector<Skeleton> skeletons;
    std::vector<Clip> clips;
    std::vector<std::uint32_t>
        roots;  ///< nodes shown by default; others are prototypes to be spawned by name or index
    std::optional<TimeOfDay> time{};  ///< of the daylight around it, where it is known
};

}  // namespace rambla::assets
