#include "systems/simulate/paths.h"

#include <algorithm>
#include <cmath>

#include "assets/assert.h"
#include "systems/position.h"

namespace rambla::systems {

std::uint32_t PathGraph::add(const assets::PathNetwork& network, const WorldPosition& origin) {
    const auto first_point = static_cast<std::uint32_t>(points_.size());
    const auto first_link = static_cast<std::uint32_t>(links_.size());
    for (const glm::vec3& point : network.points)
        points_.push_back(moved(origin, glm::dvec3{point}));
    for (const assets::PathNetwork::Link& link : network.links) {
        RAMBLA_ASSERT(link.from < network.points.size() && link.to < network.points.size(),
                      "links join points of their own network");
        const glm::vec3 span = network.points[link.to] - network.points[link.from];
        const float length = std::sqrt(glm::dot(span, span));
        const float ground = std::sqrt(span.x * span.x + span.z * span.z);
        Link made{
            first_point + link.from, first_point + link.to, std::max(link.half_width_m, 0.0f), 0.0f, {}, {}};
        if (ground > 1.0e-3f) {
            made.length_m = length;
            made.direction = span / length;
            made.right = glm::vec3{-span.z, 0.0f, span.x} / ground;
        }
        links_.push_back(made);
        both_ways_.push_back(link.both_ways);
    }

    // Exits sorted by point, then by link: counting sort over all links.
    first_exit_.assign(points_.size() + 1, 0);
    const auto for_exits = [&](auto&& visit) {
        for (std::uint32_t i = 0; i < links_.size(); ++i) {
            if (!usable(i)) continue;
            visit(links_[i].from, Exit{i, false});
            if (both_ways_[i]) visit(links_[i].to, Exit{i, true});
        }
    };
    for_exits([&](std::uint32_t point, Exit) { ++first_exit_[point + 1]; });
    for (std::size_t i = 1; i < first_exit_.size(); ++i)
        first_exit_[i] += first_exit_[i - 1];
    exits_.resize(first_exit_.back());
    std::vector<std::uint32_t> place{first_exit_.begin(), first_exit_.end() - 1};
    for_exits([&](std::uint32_t point, Exit exit) { exits_[place[point]++] = exit; });
    return first_link;
}

std::uint32_t PathGraph::start_of(const PathLeg& leg) const {
    return leg.backwards ? links_[leg.link].to : links_[leg.link].from;
}

std::uint32_t PathGraph::end_of(const PathLeg& leg) const {
    return leg.backwards ? links_[leg.link].from : links_[leg.link].to;
}

glm::vec3 PathGraph::direction_of(const PathLeg& leg) const {
    return leg.backwards ? -links_[leg.link].direction : links_[leg.link].direction;
}

glm::vec3 PathGraph::point_on(const PathLeg& leg, float along_m) const {
    const glm::vec3 right = leg.backwards ? -links_[leg.link].right : links_[leg.link].right;
    return direction_of(leg) * along_m + right * leg.aside_m;
}

glm::vec3 TurnCurve::at(float u) const {
    const float v = 1.0f - u;
    return p0 * (v * v * v) + p1 * (3.0f * v * v * u) + p2 * (3.0f * v * u * u) + p3 * (u * u * u);
}

glm::vec3 TurnCurve::derivative(float u) const {
    const float v = 1.0f - u;
    return (p1 - p0) * (3.0f * v * v) + (p2 - p1) * (6.0f * v * u) + (p3 - p2) * (3.0f * u * u);
}

float trim_m(const PathGraph::Link& link, float minimum_m) {
    return std::min(std::max(link.half_width_m, minimum_m), 0.45f * link.length_m);
}

TurnCurve turn_curve(const PathGraph& graph, const PathLeg& from, const PathLeg& to, float minimum_m) {
    // Handles of 0.39 times the chord make the quarter of a circle out of a right angle (0.5523 / √2), and
    // nearly even speed along a straight line.
    constexpr float k_handle = 0.39f;
    const PathGraph::Link& last = graph.links()[from.link];
    const PathGraph::Link& first = graph.links()[to.link];
    const glm::vec3 p0 = graph.point_on(from, last.length_m - trim_m(last, minimum_m)) -
                         graph.direction_of(from) * last.length_m;
    const glm::vec3 p3 = graph.point_on(to, trim_m(first, minimum_m));
    const glm::vec3 chord = p3 - p0;
    const float handle = k_handle * std::sqrt(glm::dot(chord, chord));
    return {p0, p0 + graph.direction_of(from) * handle, p3 - graph.direction_of(to) * handle, p3};
}

}  // namespace rambla::systems
