#include "assets/process/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "assets/process/polygon.h"

namespace rambla::assets {

namespace {

constexpr double k_relative_tolerance = 0.02;

/// What is nearest to a point on the other side.
struct Nearest {
    std::uint32_t target = 0;
    double distance = std::numeric_limits<double>::infinity();
};

/// What Refinement asks of the other side, for triangles.
struct TriangleTarget {
    const Surface& surface;

    [[nodiscard]] std::size_t count() const { return surface.triangle_count(); }

    [[nodiscard]] Nearest nearest(glm::dvec3 point) const {
        const PointOnSurface found = surface.nearest(point);
        return {found.triangle, found.place.distance};
    }

    [[nodiscard]] double distance(glm::dvec3 point, std::uint32_t triangle) const {
        return nearest_on_triangle(point, surface.corners(triangle)).distance;
    }

    /// The sides of what lies above and below a triangle: there the distance is that to its plane.
    [[nodiscard]] std::vector<Plane> sides(std::uint32_t triangle) const {
        const TriangleCorners t = surface.corners(triangle);
        const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
        std::vector<Plane> planes;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 inwards = glm::cross(normal, t[(i + 1) % 3] - t[i]);
            const double length = glm::length(inwards);
            if (length > 0.0) planes.push_back({inwards / length, t[i]});
        }
        return planes;
    }
};

/// For solid boxes.
struct BoxTarget {
    std::span<const Bounds> boxes;

    [[nodiscard]] std::size_t count() const { return boxes.size(); }

    [[nodiscard]] Nearest nearest(glm::dvec3 point) const {
        Nearest best;
        for (std::uint32_t box = 0; box < boxes.size(); ++box)
            if (const double found = distance(point, box); found < best.distance) best = {box, found};
        return best;
    }

    [[nodiscard]] double distance(glm::dvec3 point, std::uint32_t box) const {
        return glm::distance(point,
                             glm::clamp(point, glm::dvec3{boxes[box].min}, glm::dvec3{boxes[box].max}));
    }

    [[nodiscard]] std::vector<Plane> sides(std::uint32_t) const { return {}; }
};

/// Part of a triangle, with an upper bound of its points' distances.
struct Piece {
    Polygon polygon;
    double at_most = 0.0;
    std::uint32_t middle_target = 0;  ///< what is nearest to the polygon's middle
    std::uint64_t number = 0;         ///< decides among equals, so that the work is the same everywhere

    bool operator<(const Piece& other) const {
        return at_most != other.at_most ? at_most < other.at_most : number > other.number;
    }
};

template <class Target>
class Refinement {
public:
    Refinement(const Surface& from, const Target& to, double tolerance_m)
        : from_{from}, to_{to}, tolerance_m_{tolerance_m} {}

    Deviation run() {
        if (from_.triangle_count() == 0) return {};
        if (to_.count() == 0) {
            const double infinity = std::numeric_limits<double>::infinity();
            return {infinity, infinity};
        }
        offer_triangles();
        // Enough in practice; the limit only keeps time in proportion for surfaces made to defeat it.
        std::size_t splits_left = 1'000 + 8 * (from_.triangle_count() + to_.count());
        while (!pieces_.empty() && splits_left > 0 && pieces_.top().at_most > good_enough()) {
            const Piece worst = pieces_.top();
            pieces_.pop();
            refine(worst);
            --splits_left;
        }
        const double open = pieces_.empty() ? 0.0 : pieces_.top().at_most;
        return {at_least_, std::max({open, settled_, at_least_})};
    }

private:
    [[nodiscard]] double good_enough() const {
        return at_least_ + std::max(tolerance_m_, k_relative_tolerance * at_least_);
    }

    Nearest probe(glm::dvec3 point) {
        const Nearest found = to_.nearest(point);
        at_least_ = std::max(at_least_, found.distance);
        return found;
    }

    /// Vertices first: the more is known from below, the less needs refinement.
    void offer_triangles() {
        std::vector<Nearest> at_vertex(from_.positions().size());
        for (const std::uint32_t index : from_.indices())
            if (std::isinf(at_vertex[index].distance))
                at_vertex[index] = probe(glm::dvec3{from_.positions()[index]});
        for (std::uint32_t triangle = 0; triangle < from_.triangle_count(); ++triangle) {
            const std::uint32_t* const i = &from_.indices()[std::size_t{3} * triangle];
            const Polygon polygon = polygon_of(from_.corners(triangle));
            double at_most = std::numeric_limits<double>::infinity();
            for (std::size_t c = 0; c < 3; ++c)
                at_most = std::min(at_most, farthest_from(at_vertex[i[c]].target, polygon));
            offer(polygon, at_most);
        }
    }

    [[nodiscard]] double farthest_from(std::uint32_t target, const Polygon& polygon) const {
        double farthest = 0.0;
        for (const glm::dvec3 corner : polygon.points())
            farthest = std::max(farthest, to_.distance(corner, target));
        return farthest;
    }

    /// Keeps a polygon for refinement, unless its bound is good enough.
    void offer(const Polygon& polygon, double at_most) {
        std::uint32_t target = 0;
        if (at_most > good_enough()) {
            target = probe(polygon.middle()).target;
            at_most = std::min(at_most, farthest_from(target, polygon));
        }
        if (at_most > good_enough())
            pieces_.push({polygon, at_most, target, offered_++});
        else
            settled_ = std::max(settled_, at_most);
    }

    /// Looks closer at a piece's corners; if that does not do, cuts out what its middle's nearest thing
    /// faces, or halves the piece.
    void refine(const Piece& piece) {
        double at_most = piece.at_most;
        for (const glm::dvec3 corner : piece.polygon.points())
            at_most = std::min(at_most, farthest_from(probe(corner).target, piece.polygon));
        if (at_most <= good_enough()) {
            settled_ = std::max(settled_, at_most);
            return;
        }
        if (piece.polygon.points().size() < Polygon::k_most_points - 3 && cut_out(piece, at_most)) return;
        const auto [one, other] = cut(piece.polygon, middle_plane(piece.polygon));
        offer(one, at_most);
        offer(other, at_most);
    }

    bool cut_out(const Piece& piece, double at_most) {
        const std::vector<Plane> sides = to_.sides(piece.middle_target);
        const glm::dvec3 middle = piece.polygon.middle();
        const double margin_m = 0.5 * tolerance_m_;
        bool crosses = false;
        for (const Plane& side : sides) {
            if (height(side, middle) <= margin_m) return false;
            for (const glm::dvec3 corner : piece.polygon.points())
                crosses = crosses || height(side, corner) < -margin_m;
        }
        if (!crosses) return false;
        Polygon rest = piece.polygon;
        for (const Plane& side : sides) {
            const auto [inside, outside] = cut(rest, side);
            if (!outside.points().empty()) offer(outside, at_most);
            rest = inside;
        }
        offer(rest, std::min(at_most, farthest_from(piece.middle_target, rest)));
        return true;
    }

    const Surface& from_;
    const Target& to_;
    double tolerance_m_;
    std::priority_queue<Piece> pieces_;
    double at_least_ = 0.0;
    double settled_ = 0.0;  ///< largest bound of pieces that need no refinement
    std::uint64_t offered_ = 0;
};

}  // namespace

Deviation one_sided_deviation(const Surface& from, const Surface& to, double tolerance_m) {
    const TriangleTarget target{to};
    return Refinement{from, target, tolerance_m}.run();
}

Deviation one_sided_deviation(const Surface& from, std::span<const Bounds> to, double tolerance_m) {
    const BoxTarget target{to};
    return Refinement{from, target, tolerance_m}.run();
}

Deviation deviation(const Surface& a, const Surface& b, double tolerance_m) {
    const Deviation forth = one_sided_deviation(a, b, tolerance_m);
    const Deviation back = one_sided_deviation(b, a, tolerance_m);
    return {std::max(forth.at_least_m, back.at_least_m), std::max(forth.at_most_m, back.at_most_m)};
}

}  // namespace rambla::assets
