#include "assets/generate/city_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "assets/generate/building.h"

namespace rambla::assets::generate {

namespace {

/// Distance of the crossings from a block's middle: the end of its straight sides, where the walkway bends.
float crossing_reach(const StreetPlan& street) {
    return 0.5f * street.block_m - k_chamfer_m + 0.41421356f * street.walkway_m();
}

bool leaves_the_walk(const CityPlan& plan, int street, int row, float side) {
    return street == plan.walked_street() && row == plan.walked_row() && side < 0.0f;
}

/// Lays the network; walkway points are found again by where they lie.
class PavementPlanner {
public:
    explicit PavementPlanner(const CityPlan& plan) : plan_{plan}, half_{plan.street.walkway_half_width_m()} {}

    PavementPlan make() {
        add_blocks();
        add_edges();
        for (const Crossing& crossing : plan_crossings(plan_))
            add_crossing(crossing);
        return std::move(result_);
    }

private:
    std::uint32_t add_point(glm::vec2 at, float height) {
        result_.network.points.emplace_back(at.x, height, at.y);
        return static_cast<std::uint32_t>(result_.network.points.size() - 1);
    }
    std::uint32_t add_link(std::uint32_t from, std::uint32_t to, float half_width) {
        result_.network.links.push_back({from, to, half_width, true});
        return static_cast<std::uint32_t>(result_.network.links.size() - 1);
    }
    /// The walkway point that lies here, as blocks and edges made it.
    std::uint32_t point_near(glm::vec2 at) const {
        std::uint32_t best = 0;
        float nearest = 1e30f;
        const auto cell = cell_of(at);
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = cells_.find({cell.first + dx, cell.second + dz});
                if (found == cells_.end()) continue;
                for (const std::uint32_t index : found->second) {
                    const glm::vec3& p = result_.network.points[index];
                    const glm::vec2 to = glm::vec2{p.x, p.z} - at;
                    if (glm::dot(to, to) < nearest) {
                        nearest = glm::dot(to, to);
                        best = index;
                    }
                }
            }
        }
        return best;
    }
    static std::pair<int, int> cell_of(glm::vec2 at) {
        return {static_cast<int>(std::floor(at.x / 8.0f)), static_cast<int>(std::floor(at.y / 8.0f))};
    }
    std::uint32_t add_walkway_point(glm::vec2 at) {
        const std::uint32_t index = add_point(at, k_kerb_height_m);
        cells_[cell_of(at)].push_back(index);
        return index;
    }

    void add_blocks() {
        const auto outline = block_outline(plan_.street, plan_.street.walkway_m());
        for (int j = 0; j < plan_.blocks_z; ++j) {
            for (int i = 0; i < plan_.blocks_x; ++i) {
                std::array<std::uint32_t, 8> ring{};
                for (std::size_t k = 0; k < 8; ++k)
                    ring[k] = add_walkway_point(plan_.block_centre(i, j) + outline[k]);
                for (std::size_t k = 0; k < 8; ++k) {
                    const std::uint32_t link = add_link(ring[k], ring[(k + 1) % 8], half_);
                    result_.pavement_links.push_back(link);
                    // Sides 0 and 2 are corners 0–1 (+x) and 4–5 (−x).
                    const bool beside =
                        (k == 0 && i + 1 == plan_.walked_street()) || (k == 4 && i == plan_.walked_street());
                    const bool ahead = j == plan_.walked_row() || j + 1 == plan_.walked_row();
                    if (beside && ahead) result_.walked_links.push_back(link);
                }
            }
        }
    }

    void add_edges() {
        const glm::vec2 low = plan_.edge_min() + plan_.street.walkway_m();
        const glm::vec2 high = plan_.edge_max() - plan_.street.walkway_m();
        const float reach = crossing_reach(plan_.street);
        std::vector<glm::vec2> loop;
        const auto side = [&](glm::vec2 from, glm::vec2 to, bool along_x, int blocks) {
            loop.push_back(from);
            std::vector<float> stops;
            for (int i = 0; i < blocks; ++i) {
                const float middle = along_x ? plan_.block_centre(i, 0).x : plan_.block_centre(0, i).y;
                stops.push_back(middle - reach);
                stops.push_back(middle + reach);
            }
            const bool forwards = along_x ? to.x > from.x : to.y > from.y;
            if (!forwards) std::reverse(stops.begin(), stops.end());
            for (const float stop : stops)
                loop.push_back(along_x ? glm::vec2{stop, from.y} : glm::vec2{from.x, stop});
        };
        side({low.x, low.y}, {high.x, low.y}, true, plan_.blocks_x);
        side({high.x, low.y}, {high.x, high.y}, false, plan_.blocks_z);
        side({high.x, high.y}, {low.x, high.y}, true, plan_.blocks_x);
        side({low.x, high.y}, {low.x, low.y}, false, plan_.blocks_z);
        std::vector<std::uint32_t> points;
        for (const glm::vec2 at : loop)
            points.push_back(add_walkway_point(at));
        for (std::size_t k = 0; k < points.size(); ++k)
            result_.pavement_links.push_back(add_link(points[k], points[(k + 1) % points.size()], half_));
    }

    /// From walkway to walkway over the road: down a kerb ramp, across, and up again.
    void add_crossing(const Crossing& crossing) {
        const glm::vec2 across = crossing.street_along_z ? glm::vec2{1.0f, 0.0f} : glm::vec2{0.0f, 1.0f};
        const float kerb = 0.5f * plan_.street.carriageway_m();
        const float walkway = 0.5f * plan_.street.street_width_m - plan_.street.walkway_m();
        constexpr float k_crossing_half_m = 0.4f;
        std::uint32_t before = point_near(crossing.middle - across * walkway);
        const std::uint32_t last = point_near(crossing.middle + across * walkway);
        const std::array<std::pair<float, float>, 4> steps{{{-kerb - 0.05f, k_kerb_height_m},
                                                            {-kerb + 0.30f, 0.0f},
                                                            {kerb - 0.30f, 0.0f},
                                                            {kerb + 0.05f, k_kerb_height_m}}};
        for (const auto& [offset, height] : steps) {
            const std::uint32_t next = add_point(crossing.middle + across * offset, height);
            add_link(before, next, std::min(half_, k_crossing_half_m));
            before = next;
        }
        add_link(before, last, std::min(half_, k_crossing_half_m));
    }

    const CityPlan& plan_;
    float half_;
    PavementPlan result_;
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> cells_;
};

/// Places walkers one after the other, apart from each other and without twins side by side.
class WalkerPlanner {
public:
    WalkerPlanner(const PavementPlan& pavements, const std::vector<std::uint32_t>& people, Draws& draws)
        : pavements_{pavements},
          people_{people},
          draws_{draws},
          tries_(pavements.network.links.size(), 0),
          lanes_(2 * tries_.size()),
          seen_on_(tries_.size() * people.size(), 0),
          seen_(people.size(), 0) {}

    ActorStart next() {
        // A crowd may fill every link: then the last try stands where it is.
        constexpr int k_tries = 24;
        ActorStart start = draw();
        for (int i = 1; i < k_tries && !has_room(start); ++i)
            start = draw();
        if (has_room(start)) lane_of(start).push_back(along_m(start));
        const PathNetwork::Link& link = pavements_.network.links[start.link];
        const WalkerBand band = walker_band(link.half_width_m);
        const float right = draws_.between(band.nearest_m, band.farthest_m);
        start.aside_m = start.backwards ? -right : right;
        start.speed_m_s = draws_.between(1.0f, 1.6f);
        start.prototype = people_[least_seen_on(start.link)];
        return start;
    }

private:
    static constexpr float k_apart_m = 1.2f;  ///< a step and a swinging arm

    ActorStart draw() {
        const bool walked = draws_.chance(0.4f) && !pavements_.walked_links.empty();
        const auto& choices = walked ? pavements_.walked_links : pavements_.pavement_links;
        ActorStart start;
        start.kind = ActorKind::walker;
        start.link = choices[draws_.below(static_cast<std::uint32_t>(choices.size()))];
        // Golden-ratio steps spread those of one link evenly, however many come.
        const float share =
            glm::fract(0.13f + 0.618034f * static_cast<float>(tries_[start.link]++) + 0.04f * draws_.unit());
        // The ends belong to the curves of turns; starts there would be moved onto each other.
        const PathNetwork::Link& link = pavements_.network.links[start.link];
        const float end = glm::min(glm::max(link.half_width_m, k_apart_m) / length_m(start), 0.45f);
        start.along = glm::mix(end, 1.0f - end, share);
        start.backwards = draws_.chance(0.5f);
        return start;
    }
    float length_m(const ActorStart& start) const {
        const PathNetwork::Link& link = pavements_.network.links[start.link];
        return glm::distance(pavements_.network.points[link.from], pavements_.network.points[link.to]);
    }
    float along_m(const ActorStart& start) const { return start.along * length_m(start); }
    std::vector<float>& lane_of(const ActorStart& start) {
        return lanes_[2 * start.link + (start.backwards ? 1 : 0)];
    }
    bool has_room(const ActorStart& start) {
        const auto& lane = lane_of(start);
        const float here = along_m(start);
        return std::none_of(lane.begin(), lane.end(),
                            [&](float other) { return std::abs(other - here) < k_apart_m; });
    }
    /// Who has been on this link least, then anywhere least; men and women take turns.
    std::size_t least_seen_on(std::uint32_t link) {
        std::uint32_t* on_link = &seen_on_[link * people_.size()];
        constexpr std::size_t k_stride = 5;  // shares nothing with twelve; odd: men and women by turns
        const std::size_t first = k_stride * placed_++;
        std::size_t best = first % people_.size();
        for (std::size_t i = 1; i < people_.size(); ++i) {
            const std::size_t other = (first + i) % people_.size();
            if (std::pair{on_link[other], seen_[other]} < std::pair{on_link[best], seen_[best]}) best = other;
        }
        ++on_link[best];
        ++seen_[best];
        return best;
    }

    const PavementPlan& pavements_;
    const std::vector<std::uint32_t>& people_;
    Draws& draws_;
    std::vector<std::uint32_t> tries_;
    std::vector<std::vector<float>> lanes_;  ///< per link and direction: where people start
    std::vector<std::uint32_t> seen_on_;     ///< per link and prototype
    std::vector<std::uint32_t> seen_;        ///< per prototype
    std::size_t placed_ = 0;
};

}  // namespace

PavementPlan plan_pavements(const CityPlan& plan) {
    return PavementPlanner{plan}.make();
}

std::vector<Crossing> plan_crossings(const CityPlan& plan) {
    std::vector<Crossing> crossings;
    const float reach = crossing_reach(plan.street);
    for (int i = 0; i <= plan.blocks_x; ++i)
        for (int j = 0; j < plan.blocks_z; ++j)
            for (const float side : {-1.0f, 1.0f})
                if (!leaves_the_walk(plan, i, j, side))
                    crossings.push_back({{plan.street_x(i), plan.block_centre(0, j).y + side * reach}, true});
    for (int j = 0; j <= plan.blocks_z; ++j)
        for (int i = 0; i < plan.blocks_x; ++i)
            for (const float side : {-1.0f, 1.0f})
                crossings.push_back({{plan.block_centre(i, 0).x + side * reach, plan.street_z(j)}, false});
    return crossings;
}

PathNetwork plan_lanes(const CityPlan& plan) {
    PathNetwork lanes;
    const auto point = [&](int i, int j) {
        return static_cast<std::uint32_t>(j * (plan.blocks_x + 1) + i);
    };
    for (int j = 0; j <= plan.blocks_z; ++j)
        for (int i = 0; i <= plan.blocks_x; ++i)
            lanes.points.emplace_back(plan.street_x(i) + plan.lane_m(), 0.0f,
                                      plan.street_z(j) + plan.lane_m());
    const auto add = [&](std::uint32_t a, std::uint32_t b, bool forwards) {
        lanes.links.push_back({forwards ? a : b, forwards ? b : a, 0.15f, false});
    };
    // Street 0 along z runs towards −z and street 0 along x towards +x: around the edge in one sense.
    for (int i = 0; i <= plan.blocks_x; ++i)
        for (int j = 0; j < plan.blocks_z; ++j)
            add(point(i, j), point(i, j + 1), runs_positive(i, plan.blocks_x, false));
    for (int j = 0; j <= plan.blocks_z; ++j)
        for (int i = 0; i < plan.blocks_x; ++i)
            add(point(i, j), point(i + 1, j), runs_positive(j, plan.blocks_z, true));
    return lanes;
}

std::vector<ActorStart> plan_actors(const CityParameters& parameters, const PavementPlan& pavements,
                                    const PathNetwork& lanes, const std::vector<std::uint32_t>& people,
                                    const std::vector<std::uint32_t>& cars, std::uint64_t seed) {
    std::vector<ActorStart> actors;
    Draws draws{seed};
    WalkerPlanner planner{pavements, people, draws};
    for (int n = 0; n < parameters.walkers; ++n)
        actors.push_back(planner.next());
    std::vector<std::uint32_t> cars_on(lanes.links.size(), 0);
    for (int n = 0; n < parameters.cars; ++n) {
        ActorStart start;
        start.kind = ActorKind::car;
        start.prototype = cars[static_cast<std::size_t>(n) % cars.size()];
        start.link = draws.below(static_cast<std::uint32_t>(lanes.links.size()));
        start.along = glm::fract(0.2f + 0.618034f * static_cast<float>(cars_on[start.link]++));
        start.speed_m_s = draws.between(5.0f, 7.0f);
        actors.push_back(start);
    }
    return actors;
}

}  // namespace rambla::assets::generate
