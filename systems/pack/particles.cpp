#include "systems/pack/particles.h"

#include <algorithm>
#include <cmath>

#include "systems/simulate/random.h"
#include "systems/simulate/trigonometry.h"

namespace rambla::systems {
namespace {

/// Of numbers that still tell one birth from the next.
constexpr double k_last_time_s = 1e12;
constexpr double k_two_pi = 6.283185307179586;

/// Draws of one birth of one particle.
class Birth {
public:
    Birth(const ParticleSource& source, std::uint32_t number, std::int64_t generation)
        : who_{(std::uint64_t{source.seed} << 32u) | number}, generation_{generation} {}

    float unit() {
        return unit_interval(random_bits(static_cast<std::uint64_t>(generation_), who_, draws_++));
    }
    float balanced() { return 2.0f * unit() - 1.0f; }

private:
    std::uint64_t who_;
    std::int64_t generation_;
    std::uint64_t draws_ = 0;
};

struct Interval {
    float low;
    float high;
};

/// Of v·t + ½·a·t² for t from 0 to `end` and v between `slow` and `fast`. With v the term grows at any t, so
/// that each end has its own parabola.
Interval reach(float slow, float fast, float acceleration, float end) {
    const auto at = [&](float velocity, float t) {
        return (velocity + 0.5f * acceleration * t) * t;
    };
    const auto vertex = [&](float velocity) {
        const float t = -velocity / acceleration;  // without acceleration none, or no number
        return t > 0.0f && t < end ? at(velocity, t) : 0.0f;
    };
    return {std::min({0.0f, at(slow, end), vertex(slow)}), std::max({0.0f, at(fast, end), vertex(fast)})};
}

}  // namespace

Particle particle_at(const ParticleSource& source, std::uint32_t number, double time_s) {
    std::int64_t generation = 0;
    float share = 0.0f;  // of its life
    const bool lives = source.lifetime_s >= k_shortest_life_s;
    if (lives) {
        // Births are evenly spread, but not so evenly that one could count them.
        const float jitter = Birth{source, number, -1}.unit();
        const double offset = (static_cast<double>(number) + static_cast<double>(jitter)) / source.count;
        const double time = std::clamp(time_s, -k_last_time_s, k_last_time_s);
        const double turn = time / static_cast<double>(source.lifetime_s) + offset;
        generation = static_cast<std::int64_t>(std::floor(turn));
        share = std::min(static_cast<float>(turn - std::floor(turn)), 1.0f);
    }
    Birth birth{source, number, generation};
    const double angle = k_two_pi * static_cast<double>(birth.unit());
    const float from_middle_m = source.spread_m * std::sqrt(birth.unit());
    const glm::vec3 start{from_middle_m * static_cast<float>(cosine(angle)), 0.0f,
                          from_middle_m * static_cast<float>(sine(angle))};
    const glm::vec3 differs{birth.balanced(), birth.balanced(), birth.balanced()};
    const glm::vec3 velocity = source.velocity_m_s + source.velocity_spread_m_s * differs;
    const float age_s = lives ? share * source.lifetime_s : 0.0f;
    const float left = 1.0f - share;
    return {.centre_m = start + (velocity + 0.5f * source.acceleration_m_s2 * age_s) * age_s,
            .radius_m = std::lerp(source.start_radius_m, source.end_radius_m, share),
            .opacity = lives ? 6.75f * share * left * left : 1.0f};
}

LocalBounds particle_bounds(const ParticleSource& source) {
    const float radius = std::max(source.start_radius_m, source.end_radius_m);
    glm::vec3 low{-source.spread_m, 0.0f, -source.spread_m};
    glm::vec3 high{source.spread_m, 0.0f, source.spread_m};
    for (int axis = 0; axis < 3; ++axis) {
        const float velocity = source.velocity_m_s[axis];
        const Interval moved =
            reach(velocity - source.velocity_spread_m_s, velocity + source.velocity_spread_m_s,
                  source.acceleration_m_s2[axis], std::max(source.lifetime_s, 0.0f));
        low[axis] += moved.low - radius;
        high[axis] += moved.high + radius;
    }
    return {0.5f * (low + high), 0.5f * (high - low)};
}

}  // namespace rambla::systems
