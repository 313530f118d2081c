#include "game/study/report/label_placement.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace rambla::game::study {
namespace {

double overlap(const Box& a, const Box& b) {
    const glm::dvec2 size = glm::max(glm::min(a.high, b.high) - glm::max(a.low, b.low), 0.0);
    return size.x * size.y;
}

Box box_around(const glm::dvec2& centre, const glm::dvec2& size) {
    return {centre - size / 2.0, centre + size / 2.0};
}

/// The label's box shifted into the bounds, if it is no larger than they are.
Box kept_inside(Box box, const Box& bounds) {
    const glm::dvec2 shift = glm::max(bounds.low - box.low, 0.0) - glm::max(box.high - bounds.high, 0.0);
    return {box.low + shift, box.high + shift};
}

/// Places around an anchor, the preferred ones first: beside, above and below, then the corners.
std::vector<Box> places_around(const Anchor& anchor, double radius, const Box& bounds, int rings) {
    constexpr std::array<glm::dvec2, 8> k_directions{
        {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}};
    constexpr double k_first_gap = 3.0;
    constexpr double k_ring_gap = 8.0;
    std::vector<Box> places;
    for (int ring = 0; ring < rings; ++ring) {
        for (const glm::dvec2& direction : k_directions) {
            const bool corner = direction.x != 0.0 && direction.y != 0.0;
            const double distance = (radius + k_first_gap + ring * k_ring_gap) * (corner ? 0.7 : 1.0);
            const glm::dvec2 centre = anchor.at + direction * (anchor.label_size / 2.0 + distance);
            places.push_back(kept_inside(box_around(centre, anchor.label_size), bounds));
        }
    }
    return places;
}

}  // namespace

Placement place_labels(std::span<const Anchor> anchors, double radius, const Box& bounds, int rings) {
    Placement placement{std::vector<Box>(anchors.size()), true};
    std::vector<Box> taken;
    for (const Anchor& anchor : anchors)
        taken.push_back(box_around(anchor.at, glm::dvec2{2.0 * radius}));
    std::vector<std::size_t> order(anchors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return anchors[a].at.x < anchors[b].at.x; });
    for (const std::size_t index : order) {
        double least = std::numeric_limits<double>::infinity();
        for (const Box& place : places_around(anchors[index], radius, bounds, rings)) {
            double covered = 0.0;
            for (const Box& other : taken)
                covered += overlap(place, other);
            if (covered >= least) continue;
            least = covered;
            placement.boxes[index] = place;
            if (covered == 0.0) break;
        }
        placement.free = placement.free && least == 0.0;
        taken.push_back(placement.boxes[index]);
    }
    return placement;
}

}  // namespace rambla::game::study
