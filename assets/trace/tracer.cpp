#include "assets/trace/tracer.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "assets/trace/embree_scene.h"
#include "assets/trace/float_mode.h"
#include "assets/trace/placed_scene.h"

namespace rambla::assets {
namespace {

/// A hit may be so much nearer than Embree has it, times its distance and the numbers that Embree computes
/// with.
constexpr double k_order_share = 0x1p-16;

/// A candidate and where the ray meets it.
struct Found {
    PlaneMeeting meeting;
    std::uint32_t instance = k_none;
    std::uint32_t triangle = k_none;

    [[nodiscard]] bool is_before(const Found& other) const {
        return std::tie(meeting.t, instance, triangle) <
               std::tie(other.meeting.t, other.instance, other.triangle);
    }
};

void judge(const RTCFilterFunctionNArguments* arguments);

/// A query, as it reaches the filter.
struct Query : RTCIntersectContext {
    Query(const PlacedScene& traced, const TraceRay& along, const RaySpread* beside)
        : scene{traced}, ray{along}, spread{beside} {
        reset();
    }
    /// Before each use by Embree.
    void reset() {
        rtcInitIntersectContext(this);
        filter = judge;
    }

    const PlacedScene& scene;
    const TraceRay& ray;
    const RaySpread* spread;
    bool keeps_looking = false;  ///< finds all instead of what Embree has for the first
    Found best{};
};

void judge(const RTCFilterFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    Query& query = *static_cast<Query*>(arguments->context);
    Found found{.meeting = {},
                .instance = RTCHitN_instID(arguments->hit, 1, 0, 0),
                .triangle = RTCHitN_primID(arguments->hit, 1, 0)};
    const std::optional<PlaneMeeting> meeting =
        query.scene.meet(query.ray, query.spread, found.instance, found.triangle);
    if (!meeting || query.keeps_looking) arguments->valid[0] = 0;
    if (!meeting) return;
    found.meeting = *meeting;
    if (query.best.instance == k_none || found.is_before(query.best)) query.best = found;
}

float rounded_up(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) < value
               ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
               : rounded;
}

bool is_finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A ray in Embree's numbers. Counts in metres from a place shortly before the ray's own, so that what lies
/// next to that is found.
class SearchRay {
public:
    SearchRay(const TraceRay& ray, double reach_m) {
        const double length = glm::length(ray.direction);
        const glm::dvec3 direction = ray.direction / length;
        const glm::dvec3 first = ray.origin_m + ray.t_min * ray.direction;
        size_m_ = std::max({std::abs(first.x), std::abs(first.y), std::abs(first.z)}) + reach_m;
        const double early_m = k_near_share * size_m_;
        const glm::dvec3 begin = first - early_m * direction;
        valid_ = length > 0.0 && is_finite(begin) && is_finite(direction) && ray.t_min < ray.t_max;
        embree_ = {.org_x = static_cast<float>(begin.x),
                   .org_y = static_cast<float>(begin.y),
                   .org_z = static_cast<float>(begin.z),
                   .tnear = 0.0f,
                   .dir_x = static_cast<float>(direction.x),
                   .dir_y = static_cast<float>(direction.y),
                   .dir_z = static_cast<float>(direction.z),
                   .time = 0.0f,
                   .tfar = rounded_up((ray.t_max - ray.t_min) * length + 2.0 * early_m),
                   .mask = ~0u,
                   .id = 0,
                   .flags = 0};
    }

    [[nodiscard]] bool valid() const { return valid_; }
    [[nodiscard]] const RTCRay& embree() const { return embree_; }
    /// The same, but only around a distance that Embree has found.
    [[nodiscard]] RTCRay around(float t) const {
        const auto way = rounded_up(k_order_share * (size_m_ + static_cast<double>(t)));
        RTCRay ray = embree_;
        ray.tnear = std::max(t - way, 0.0f);
        ray.tfar = std::min(t + way, embree_.tfar);
        return ray;
    }

private:
    double size_m_ = 0.0;
    bool valid_ = false;
    RTCRay embree_{};
};

}  // namespace

struct Tracer::State {
    explicit State(TraceScene scene) : placed{std::move(scene)}, embree{placed} {}

    PlacedScene placed;
    EmbreeScene embree;
};

Tracer::Tracer(TraceScene scene) {
    // oneTBB gives all later work of a thread the modes of its first: that must not be Embree's, which flush
    // to zero.
    tbb::parallel_for(0, 1, [](int) {});
    const ScopedFloatMode mode;
    state_ = std::make_unique<State>(std::move(scene));
}
Tracer::~Tracer() = default;

std::optional<TraceHit> Tracer::first_hit(const TraceRay& ray, const RaySpread* spread) const {
    const ScopedFloatMode mode;
    const SearchRay search{ray, state_->embree.reach_m()};
    if (!search.valid()) return {};
    Query query{state_->placed, ray, spread};
    RTCRayHit first{.ray = search.embree(), .hit = {}};
    first.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->embree.world(), &query, &first);
    if (query.best.instance == k_none) return {};
    // Embree's order is that of its own rounded distances: look at all that is about as near.
    query.reset();
    query.keeps_looking = true;
    RTCRay again = search.around(first.ray.tfar);
    rtcOccluded1(state_->embree.world(), &query, &again);
    return state_->placed.hit(ray, query.best.instance, query.best.triangle, query.best.meeting);
}

bool Tracer::is_stopped(const TraceRay& ray) const {
    const ScopedFloatMode mode;
    const SearchRay search{ray, state_->embree.reach_m()};
    if (!search.valid()) return false;
    Query query{state_->placed, ray, nullptr};
    RTCRay embree = search.embree();
    rtcOccluded1(state_->embree.world(), &query, &embree);
    return query.best.instance != k_none;
}

const TraceScene& Tracer::scene() const {
    return state_->placed.scene();
}

std::size_t Tracer::memory_bytes() const {
    return state_->embree.memory_bytes();
}

}  // namespace rambla::assets
