#pragma once

#include "assets/generate/builder.h"

namespace rambla::assets::generate {

/// Street furniture, each with its foot at the origin and its face towards +z.
void build_lamp_post(Builder& builder);  ///< cast iron, lantern at k_lamp_height_m
void build_bench(Builder& builder);      ///< iron legs, timber slats; 1.6 m long
void build_bollard(Builder& builder);
void build_litter_bin(Builder& builder);
void build_tree_pit(Builder& builder);  ///< earth in a kerb-stone frame of 90 cm
/// A lantern on a bracket, to hang on a wall at z = 0; origin where the bracket meets the wall.
void build_wall_lantern(Builder& builder);

inline constexpr float k_lamp_height_m = 3.75f;

/// Where the light of a lamp post and of a wall lantern comes from: the middle of the lantern's glass.
inline constexpr glm::vec3 k_post_flame_m{0.0f, k_lamp_height_m - 0.16f, 0.0f};
inline constexpr glm::vec3 k_wall_flame_m{0.0f, 0.26f, 0.50f};

}  // namespace rambla::assets::generate
