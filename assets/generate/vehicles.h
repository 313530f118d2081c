#pragma once

#include "assets/generate/draws.h"
#include "assets/generate/palette.h"

namespace rambla::assets::generate {

enum class CarKind : std::uint8_t { hatchback, saloon, van };
inline constexpr std::uint32_t k_car_kinds = 3;

/// Outline of a car, in metres.
struct CarSize {
    float length_m = 4.0f;
    float width_m = 1.74f;
    float wheel_radius_m = 0.31f;
    float front_axle_m = 1.25f;  ///< before the middle
    float rear_axle_m = 1.25f;   ///< behind it
};
[[nodiscard]] CarSize car_size(CarKind kind);

/// Body of a car facing −z, wheels apart; the ground is y = 0.
void build_car_body(Builder& builder, CarKind kind);
/// A wheel about the origin that turns about x; `side` is +1 for one whose rim faces +x, −1 for the other.
void build_wheel(Builder& builder, const CarSize& size, float side);

/// Geometry of one kind of car, which cars of several colours share.
struct CarMeshes {
    std::vector<StoredPart> body, left_wheel, right_wheel;
};

/// Adds a car to the scene: a node `car` with its children `wheel_fl`, `wheel_fr`, `wheel_rl` and `wheel_rr`.
/// It is no root: whoever calls decides. Returns the node.
std::uint32_t add_car(Scene& scene, const CarMeshes& meshes, CarKind kind, const Scheme& scheme);

}  // namespace rambla::assets::generate
