#include "systems/simulate/actors.h"

#include <algorithm>
#include <cmath>

#include "systems/pipeline.h"
#include "systems/position.h"
#include "systems/simulate/gait.h"
#include "systems/simulate/random.h"
#include "systems/simulate/trigonometry.h"

namespace rambla::systems {
namespace {

/// Straights and curves that one step may touch; more than one only where links are shorter than a step.
constexpr int k_pieces_per_step = 8;

/// How fast an actor may turn on the spot, where its path has a corner that no curve can round.
double turn_rate_rad_s(assets::ActorKind kind) {
    return kind == assets::ActorKind::car ? 2.5 : 6.0;
}

float length(glm::vec3 v) {
    return std::sqrt(glm::dot(v, v));
}

/// A place in the band on the right; shares differ, so that fast people pass slow ones beside them.
float aside_on(const PathGraph::Link& link, float share) {
    const assets::WalkerBand band = assets::walker_band(link.half_width_m);
    return band.nearest_m + (band.farthest_m - band.nearest_m) * share;
}

/// The leg to turn into at the end of `leg`: any way out but the one it came by, unless there is no other.
PathLeg next_leg(const PathGraph& graph, const PathFollower& follower, std::uint64_t seed,
                 std::uint64_t who) {
    const PathLeg& leg = follower.leg;
    const auto exits = graph.exits(graph.end_of(leg));
    std::uint32_t others = 0;
    for (const PathGraph::Exit& exit : exits)
        others += exit.link != leg.link ? 1 : 0;
    const std::uint64_t bits = random_bits(seed, who, follower.turns);
    PathLeg next{leg.link, !leg.backwards, leg.aside_m};
    std::uint32_t wanted = others > 0 ? below(bits, others) : 0;
    for (const PathGraph::Exit& exit : exits) {
        if (others > 0 && exit.link == leg.link) continue;
        if (wanted-- == 0) {
            next.link = exit.link;
            next.backwards = exit.backwards;
            break;
        }
    }
    if (follower.kind == assets::ActorKind::walker) {
        next.aside_m = aside_on(graph.links()[next.link], unit_interval(bits));
    }
    return next;
}

struct CurveStep {
    float u = 0.0f;
    float rest_m = 0.0f;  ///< what is left to walk at the curve's end
};

/// Walks on a curve: the midpoint rule for du = ds / |B'(u)|, shortened until the step is not longer than it
/// should be, because next to a cusp the derivative says little about what follows.
CurveStep along_curve(const TurnCurve& curve, float u, float distance_m) {
    constexpr float k_slowest_m = 0.02f;  // at a cusp, |B'| would make the step infinite
    constexpr float k_tolerance = 1.01f;
    constexpr int k_halvings = 24;
    const float half = 0.5f * distance_m / std::max(length(curve.derivative(u)), k_slowest_m);
    const float speed_m = std::max(length(curve.derivative(std::min(u + half, 1.0f))), k_slowest_m);
    const glm::vec3 here = curve.at(u);
    float next = std::min(u + distance_m / speed_m, 1.0f);
    float walked_m = length(curve.at(next) - here);
    for (int i = 0; i < k_halvings && walked_m > k_tolerance * distance_m; ++i) {
        next = u + 0.5f * (next - u);
        walked_m = length(curve.at(next) - here);
    }
    return {next, std::max(distance_m - walked_m, 0.0f)};
}

glm::vec2 direction_of_travel(const PathGraph& graph, const PathFollower& follower) {
    glm::vec3 direction = graph.direction_of(follower.leg);
    if (follower.turning) {
        const TurnCurve curve = turn_curve(graph, follower.leg, follower.next, least_turn_m(follower.kind));
        direction = curve.derivative(follower.progress);
    }
    const glm::vec2 ground{direction.x, direction.z};
    const float size = std::sqrt(glm::dot(ground, ground));
    return size > 1.0e-4f ? ground / size : follower.heading;
}

/// `heading` turned towards `wanted` by at most the angle whose sine and cosine are given.
glm::vec2 turned(glm::vec2 heading, glm::vec2 wanted, float most_sine, float most_cosine) {
    if (glm::dot(heading, wanted) >= most_cosine) return wanted;
    const float side = heading.x * wanted.y - heading.y * wanted.x;
    const float s = side < 0.0f ? -most_sine : most_sine;
    const glm::vec2 turned_by{heading.x * most_cosine - heading.y * s,
                              heading.x * s + heading.y * most_cosine};
    return turned_by / std::sqrt(glm::dot(turned_by, turned_by));
}

}  // namespace

float least_turn_m(assets::ActorKind kind) {
    return kind == assets::ActorKind::car ? 4.0f : 0.3f;
}

PathFollower starting(const PathGraph& graph, std::uint32_t first_link, const assets::ActorStart& start) {
    PathFollower follower;
    follower.kind = start.kind;
    follower.speed_m_s = std::max(start.speed_m_s, 0.0f);
    follower.leg.link = first_link + start.link;
    follower.leg.backwards = start.backwards;
    const PathGraph::Link& link = graph.links()[follower.leg.link];
    const float aside = start.backwards ? -start.aside_m : start.aside_m;
    follower.leg.aside_m = std::clamp(aside, -link.half_width_m, link.half_width_m);
    const float along = (start.backwards ? 1.0f - start.along : start.along) * link.length_m;
    const float trim = trim_m(link, least_turn_m(start.kind));
    follower.progress = std::clamp(along, trim, link.length_m - trim);
    follower.next = follower.leg;
    follower.heading = direction_of_travel(graph, follower);
    return follower;
}

WorldPosition place_of(const PathGraph& graph, const PathFollower& follower) {
    if (!follower.turning) {
        const glm::vec3 offset = graph.point_on(follower.leg, follower.progress);
        return moved(graph.point(graph.start_of(follower.leg)), glm::dvec3{offset});
    }
    const TurnCurve curve = turn_curve(graph, follower.leg, follower.next, least_turn_m(follower.kind));
    return moved(graph.point(graph.end_of(follower.leg)), glm::dvec3{curve.at(follower.progress)});
}

PathFollower advanced(const PathGraph& graph, const PathFollower& follower, std::uint64_t seed,
                      std::uint64_t who, float step_s) {
    if (!graph.usable(follower.leg.link)) return follower;
    PathFollower moved_on = follower;
    const float least_turn = least_turn_m(follower.kind);
    float rest_m = follower.speed_m_s * step_s;
    moved_on.travelled_m += static_cast<double>(rest_m);
    for (int piece = 0; piece < k_pieces_per_step && rest_m > 0.0f; ++piece) {
        const PathGraph::Link& link = graph.links()[moved_on.leg.link];
        if (!moved_on.turning) {
            const float room_m = link.length_m - trim_m(link, least_turn) - moved_on.progress;
            if (rest_m < room_m) {
                moved_on.progress += rest_m;
                break;
            }
            rest_m -= std::max(room_m, 0.0f);
            moved_on.next = next_leg(graph, moved_on, seed, who);
            moved_on.turning = true;
            moved_on.progress = 0.0f;
            continue;
        }
        const TurnCurve curve = turn_curve(graph, moved_on.leg, moved_on.next, least_turn);
        const CurveStep stride = along_curve(curve, moved_on.progress, rest_m);
        moved_on.progress = stride.u;
        rest_m = stride.rest_m;
        if (stride.u < 1.0f) break;
        moved_on.leg = moved_on.next;
        moved_on.turning = false;
        moved_on.progress = trim_m(graph.links()[moved_on.leg.link], least_turn);
        ++moved_on.turns;
    }
    const double most_rad = turn_rate_rad_s(follower.kind) * static_cast<double>(step_s);
    moved_on.heading = turned(follower.heading, direction_of_travel(graph, moved_on),
                              static_cast<float>(sine(most_rad)), static_cast<float>(cosine(most_rad)));
    return moved_on;
}

void follow_paths(ecs::View<ecs::Entity, PathFollower, LocalTransform, Cell, ecs::Optional<Gait>> followers,
                  ecs::Res<Paths> paths) {
    followers.for_each_chunk([&](const auto& chunk) {
        constexpr auto k_step = static_cast<float>(k_step_s);
        auto [entities, follower_column, local_column, cells, gaits] = chunk;
        for (std::size_t i = 0; i < entities.size(); ++i) {
            PathFollower& follower = follower_column[i];
            LocalTransform& local = local_column[i];
            const PathGraph& graph =
                follower.kind == assets::ActorKind::car ? paths->lanes : paths->pavements;
            follower = advanced(graph, follower, paths->seed, entities[i].index, k_step);
            const WorldPosition place = place_of(graph, follower);
            cells[i].value = place.cell;
            local.translation_m = place.local_m;
            local.rotation = facing(follower.heading);
            if (gaits.empty()) continue;  // wheels, not legs
            Gait& gait = gaits[i];
            gait = advanced(gait, follower.speed_m_s, follower.speed_m_s * k_step, local.scale.y);
            local.translation_m.y -= pelvis_drop_m(gait) * local.scale.y;
        }
    });
}

void swing_limbs(ecs::View<const GaitLimb, LocalTransform> limbs, ecs::Lookup<const Gait> gaits) {
    limbs.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](const GaitLimb& limb, LocalTransform& local) {
            if (!gaits.alive(limb.actor)) return;
            const Gait* gait = gaits.try_get<Gait>(limb.actor);
            if (gait != nullptr) local.rotation = limb_rotation(limb, *gait);
        });
    });
}

void roll_wheels(ecs::View<const WheelSpin, LocalTransform> wheels, ecs::Lookup<const PathFollower> cars) {
    wheels.for_each_chunk([&](const auto& chunk) {
        chunk.each([&](const WheelSpin& wheel, LocalTransform& local) {
            if (!cars.alive(wheel.actor)) return;
            const PathFollower* car = cars.try_get<PathFollower>(wheel.actor);
            if (car != nullptr) local.rotation = wheel_rotation(wheel, car->travelled_m);
        });
    });
}

}  // namespace rambla::systems
