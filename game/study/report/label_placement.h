#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace rambla::game::study {

/// A rectangle, y downwards.
struct Box {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};
};

/// Something that wants a label near it.
struct Anchor {
    glm::dvec2 at{0.0};
    glm::dvec2 label_size{0.0};
};

/// Where labels go.
struct Placement {
    std::vector<Box> boxes;  ///< of the anchors, in their order
    bool free = true;        ///< no label covers another, or an anchor
};

/// Puts a label beside each anchor: at the nearest of some rings of places around it that is inside the
/// bounds and free, else where it covers least. Greedy from left to right, so that a label stays where it is
/// when an anchor to its right is added.
/// @param radius  of an anchor, that labels keep off
/// @param rings   how many distances are tried
[[nodiscard]] Placement place_labels(std::span<const Anchor> anchors, double radius, const Box& bounds,
                                     int rings);

}  // namespace rambla::game::study
