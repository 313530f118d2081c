#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "assets/generate/builder.h"
#include "assets/generate/draws.h"
#include "assets/generate/evening.h"

namespace rambla::assets::generate {

enum class BalconyKind : std::uint8_t { none, single, continuous };

/// What one building's façades have in common.
struct FacadeStyle {
    int upper_storeys = 4;  ///< above the ground floor
    float ground_height_m = 4.0f;
    float storey_height_m = 3.2f;
    float window_width_m = 1.2f;
    float parapet_height_m = 0.9f;
    BalconyKind first_floor_balcony = BalconyKind::continuous;
    bool upper_balconies = true;
    bool surrounds = true;
    bool shutters = true;
    bool dentils = true;
    bool brick = false;
    bool upper_course = false;
    Evening evening;

    [[nodiscard]] float roof_height_m() const {
        return ground_height_m + storey_height_m * static_cast<float>(upper_storeys);
    }
};

/// A style from the seeded family. What it looks like does not depend on the evening, only which panes shine.
[[nodiscard]] FacadeStyle draw_style(Draws& draws, int upper_storeys, const Evening& evening);

/// An opening in a wall at z = 0.
struct Opening {
    glm::vec2 min{0.0f};
    glm::vec2 max{0.0f};
};

/// A part of a shop's pane that no frame covers.
struct Glass {
    Opening at;
    glm::vec2 uv_min{0.0f};  ///< at the lower left corner
    glm::vec2 uv_max{0.0f};
};

/// The light of a shop, in the builder's outermost frame.
struct FacadeLight {
    glm::vec3 position_m{0.0f};
    bool spot = false;         ///< shines downwards
    glm::vec3 window_m{0.0f};  ///< before the lower edge of its shop's window
    bool window_shines = true;
    Opening opening{};           ///< of the shop, in `wall`
    std::vector<Glass> glass{};  ///< k_reveal_m behind the opening
    Frame wall{};                ///< of its façade
};

/// One façade of a building: from x = 0 to width in the builder's frame, pavement at y = 0, wall at z = 0.
struct FacadeSite {
    float width_m = 10.0f;
    int bays = 3;
    float mitre_left = 0.0f;  ///< see Builder::moulding
    float mitre_right = 0.0f;
    bool door = true;  ///< one bay of the ground floor is the house door
};

/// Wall, windows, balconies, mouldings and parapet; returns the lights at shop fronts.
[[nodiscard]] std::vector<FacadeLight> build_facade(Builder& builder, const FacadeSite& site,
                                                    const FacadeStyle& style, Draws& draws);

// Pieces of a façade, one file each.

/// How far windows, doors and shop fronts stand behind the wall.
inline constexpr float k_reveal_m = 0.22f;

/// Fills the wall from x = 0 to width between the lowest and highest of `levels` but for the openings that
/// lie where odd columns meet odd rows of the grid. @param columns  ascending x of all vertical cuts; levels:
/// of the horizontal
void build_pierced_wall(Builder& builder, Surface surface, const std::vector<float>& columns,
                        const std::vector<float>& levels);
/// The four inner sides of an opening.
void build_reveal(Builder& builder, Surface surface, const Opening& opening);
/// French window or sash window with frame, pane and perhaps shutters.
void build_window(Builder& builder, const Opening& opening, const FacadeStyle& style, Draws& draws);
/// Slab, brackets and railing below a row of windows from x0 to x1 at height y.
void build_balcony(Builder& builder, float x0, float x1, float y, Draws& draws);
/// Door leaf with transom in an opening of the ground floor.
void build_door(Builder& builder, const Opening& opening);
/// Glazed shop front with sign and perhaps an awning; returns its light, in the builder's frame.
[[nodiscard]] FacadeLight build_shop_front(Builder& builder, const Opening& opening, const Evening& evening,
                                           Draws& draws);

}  // namespace rambla::assets::generate
