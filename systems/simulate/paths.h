#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "assets/place.h"
#include "systems/components.h"

namespace rambla::systems {

/// A path network as its followers use it: points anywhere in the world, links with their directions, and who
/// leaves from where.
class PathGraph {
public:
    struct Link {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        float half_width_m = 0.0f;
        float length_m = 0.0f;
        glm::vec3 direction{0.0f};  ///< unit vector from `from` to `to`
        glm::vec3 right{0.0f};      ///< horizontal unit vector to the right of it
    };
    /// A way out of a point.
    struct Exit {
        std::uint32_t link = 0;
        bool backwards = false;
    };

    /// Adds a network whose points count from `origin`. Links that are vertical or shorter than a millimetre
    /// lead nowhere; nobody turns into them.
    /// @return  index that the network's first link has here
    std::uint32_t add(const assets::PathNetwork& network, const WorldPosition& origin);

    [[nodiscard]] std::span<const Link> links() const { return links_; }
    [[nodiscard]] const WorldPosition& point(std::uint32_t index) const { return points_[index]; }
    [[nodiscard]] std::span<const Exit> exits(std::uint32_t point) const {
        return std::span{exits_}.subspan(first_exit_[point], first_exit_[point + 1] - first_exit_[point]);
    }
    [[nodiscard]] bool usable(std::uint32_t link) const { return links_[link].length_m > 0.0f; }

    [[nodiscard]] std::uint32_t start_of(const PathLeg& leg) const;
    [[nodiscard]] std::uint32_t end_of(const PathLeg& leg) const;
    [[nodiscard]] glm::vec3 direction_of(const PathLeg& leg) const;
    /// From the middle of the leg's start to the point `along_m` after it, on the leg's line.
    [[nodiscard]] glm::vec3 point_on(const PathLeg& leg, float along_m) const;

private:
    std::vector<WorldPosition> points_;
    std::vector<Link> links_;
    std::vector<bool> both_ways_;  ///< by link
    std::vector<std::uint32_t> first_exit_;
    std::vector<Exit> exits_;
};

/// Resource: the ways of a world.
struct Paths {
    PathGraph pavements;
    PathGraph lanes;
    std::uint64_t seed = 0;  ///< of all choices on the way
};

/// A cubic Bézier curve, relative to the point that it goes around.
struct TurnCurve {
    glm::vec3 p0{0.0f}, p1{0.0f}, p2{0.0f}, p3{0.0f};

    [[nodiscard]] glm::vec3 at(float u) const;
    [[nodiscard]] glm::vec3 derivative(float u) const;
};

/// How far from its ends a leg turns into curves: its half width, so that a walker who keeps aside by up to
/// half of that meets neighbouring legs at right angles within both; at least `minimum_m`, at most 45 % of
/// the link.
[[nodiscard]] float trim_m(const PathGraph::Link& link, float minimum_m);

/// The curve around the end of `from` into `to`: leaves along the one and arrives along the other.
[[nodiscard]] TurnCurve turn_curve(const PathGraph& graph, const PathLeg& from, const PathLeg& to,
                                   float minimum_m);

}  // namespace rambla::systems
