#pragma once

#include "assets/generate/builder.h"

namespace rambla::assets::generate {

/// Sizes that all parts of a city agree on, in metres.
struct StreetPlan {
    float street_width_m = 9.0f;
    float block_m = 60.0f;

    [[nodiscard]] float pitch_m() const { return block_m + street_width_m; }
    /// Half of the street is carriageway, within what one lane and parking need.
    [[nodiscard]] float carriageway_m() const { return glm::clamp(0.5f * street_width_m, 2.8f, 12.0f); }
    [[nodiscard]] float pavement_m() const { return 0.5f * (street_width_m - carriageway_m()); }
    /// Middle of the strip that walkers use, from the façade.
    [[nodiscard]] float walkway_m() const { return 0.42f * pavement_m(); }
    /// Wide enough for one line of people each way, as far as half a person fits beside the furniture.
    [[nodiscard]] float walkway_half_width_m() const {
        const float beside_furniture = furniture_m() - walkway_m() - 0.34f;
        const float wanted = glm::max(0.14f * pavement_m(), glm::min(0.21f * pavement_m(), beside_furniture));
        return glm::clamp(wanted, 0.1f, 1.5f);
    }
    /// Where trees, lamps and benches stand, from the façade.
    [[nodiscard]] float furniture_m() const { return pavement_m() - 0.48f; }
};

inline constexpr float k_kerb_height_m = 0.12f;
inline constexpr float k_gutter_m = 0.28f;

/// Corners of a block's outline, pushed outwards by `offset_m`: counter-clockwise from above, centred at the
/// origin. Corner 2k and 2k + 1 are the ends of side k; sides face +x, −z, −x, +z; chamfers lie between them.
[[nodiscard]] std::array<glm::vec2, 8> block_outline(const StreetPlan& plan, float offset_m);

/// Pavement with kerb around a block, courtyard floor, gutter and the carriageways up to the middle of the
/// streets around it. Road at y = 0, pavement at k_kerb_height_m.
void build_block_ground(Builder& builder, const StreetPlan& plan);

/// Pavement with kerb along a row of houses at the city's edge and half a street before it: façades at z = 0,
/// street towards +z. Four of them close a city like a pinwheel: each begins one pavement after its corner,
/// its pavement ends at the next (x = length) and its road half a street before that, where the next one's
/// begin.
void build_edge_ground(Builder& builder, const StreetPlan& plan, float length_m);

/// Zebra across a street that runs along z, centred at the origin: bars from kerb to kerb.
void build_crossing(Builder& builder, const StreetPlan& plan);

/// Manhole cover of 64 cm and a kerb drain at the origin.
void build_manhole(Builder& builder);
void build_drain(Builder& builder);

}  // namespace rambla::assets::generate
