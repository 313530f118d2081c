#include "systems/simulate/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "systems/simulate/transform.h"

namespace rambla::systems {
namespace {

using assets::Channel;
using assets::Interpolation;

/// Whether `time_s` lies between key `left` and the next.
bool lies_after(std::span<const float> times_s, std::size_t left, double time_s) {
    return left + 1 < times_s.size() && static_cast<double>(times_s[left]) <= time_s &&
           time_s < static_cast<double>(times_s[left + 1]);
}

/// sin(share · θ) / sin θ as a series in cos θ − 1, for cos θ ≥ √½.
double sine_ratio(double share, double cosine_minus_one) {
    constexpr int k_terms = 9;
    double term = share;
    double sum = share;
    for (int i = 1; i <= k_terms; ++i) {
        const double n = i;
        term *= (share * share - n * n) / (n * (2.0 * n + 1.0)) * cosine_minus_one;
        sum += term;
    }
    return sum;
}

glm::dquat unit(const glm::dquat& q) {
    return q * (1.0 / std::sqrt(glm::dot(q, q)));
}

/// Offset of a key's value in Channel::values.
std::size_t value_offset(const Channel& channel, std::uint32_t key) {
    const std::size_t width = channel.width;
    return channel.interpolation == Interpolation::cubic_spline ? (std::size_t{3} * key + 1) * width
                                                                : key * width;
}

/// Factors of the left value, its out-tangent, the right value and its in-tangent: glTF 2.0, appendix C.
std::array<double, 4> hermite(const KeySpan& span) {
    const double t = span.share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return {2.0 * t3 - 3.0 * t2 + 1.0, span.length_s * (t3 - 2.0 * t2 + t), 3.0 * t2 - 2.0 * t3,
            span.length_s * (t3 - t2)};
}

float component_at(const Channel& channel, const KeySpan& span, std::uint32_t component) {
    const std::size_t left = value_offset(channel, span.left) + component;
    const std::size_t right = value_offset(channel, span.right) + component;
    const float held = channel.values[left];
    if (span.left == span.right || channel.interpolation == Interpolation::step) return held;
    const auto value = [&](std::size_t i) {
        return static_cast<double>(channel.values[i]);
    };
    double result = 0.0;
    if (channel.interpolation == Interpolation::linear) {
        result = value(left) * (1.0 - span.share) + value(right) * span.share;
    } else {
        const std::array<double, 4> h = hermite(span);
        const std::size_t width = channel.width;
        result = h[0] * value(left) + h[1] * value(left + width) + h[2] * value(right) +
                 h[3] * value(right - width);
    }
    const auto rounded = static_cast<float>(result);
    return std::isfinite(rounded) ? rounded : held;
}

glm::quat key_rotation(const Channel& channel, std::uint32_t key) {
    const std::size_t at = value_offset(channel, key);
    return renormalised(
        {channel.values[at + 3], channel.values[at], channel.values[at + 1], channel.values[at + 2]});
}

}  // namespace

KeySpan find_keys(std::span<const float> times_s, double time_s, std::uint32_t& hint) {
    const std::size_t last = times_s.size() - 1;
    std::size_t left = 0;
    if (lies_after(times_s, hint, time_s)) {
        left = hint;
    } else if (lies_after(times_s, std::size_t{hint} + 1, time_s)) {
        left = std::size_t{hint} + 1;
    } else {
        const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s,
                                            [](double t, float key) { return t < static_cast<double>(key); });
        left = after == times_s.begin() || std::isnan(time_s)
                   ? 0
                   : static_cast<std::size_t>(after - times_s.begin()) - 1;
    }
    hint = static_cast<std::uint32_t>(left);
    const double begin_s = times_s[left];
    if (left == last || !(time_s > begin_s)) return {hint, hint, 0.0, 0.0};
    const double length_s = static_cast<double>(times_s[left + 1]) - begin_s;
    return {hint, hint + 1, (time_s - begin_s) / length_s, length_s};
}

glm::quat mixed_rotation(const glm::quat& a, const glm::quat& b, double share) {
    const glm::dquat from{a};
    const glm::dquat to = glm::dot(from, glm::dquat{b}) < 0.0 ? -glm::dquat{b} : glm::dquat{b};
    // Halves of the arc, at most 45° each in four dimensions, where the series converges quickly.
    const glm::dquat middle = unit(from + to);
    const bool first_half = share < 0.5;
    const glm::dquat& begin = first_half ? from : middle;
    const glm::dquat& end = first_half ? middle : to;
    const double t = first_half ? 2.0 * share : 2.0 * share - 1.0;
    const double cosine_minus_one = std::min(glm::dot(begin, end), 1.0) - 1.0;
    const glm::dquat turned =
        begin * sine_ratio(1.0 - t, cosine_minus_one) + end * sine_ratio(t, cosine_minus_one);
    return glm::quat{unit(turned)};
}

float sample_component(const Channel& channel, std::uint32_t component, double time_s, std::uint32_t& hint) {
    return component_at(channel, find_keys(channel.times_s, time_s, hint), component);
}

glm::vec3 sample_vector(const Channel& channel, double time_s, std::uint32_t& hint) {
    const KeySpan span = find_keys(channel.times_s, time_s, hint);
    return {component_at(channel, span, 0), component_at(channel, span, 1), component_at(channel, span, 2)};
}

glm::quat sample_rotation(const Channel& channel, double time_s, std::uint32_t& hint) {
    const KeySpan span = find_keys(channel.times_s, time_s, hint);
    const glm::quat left = key_rotation(channel, span.left);
    if (span.left == span.right || channel.interpolation == Interpolation::step) return left;
    if (channel.interpolation == Interpolation::linear)
        return mixed_rotation(left, key_rotation(channel, span.right), span.share);
    const glm::quat curve{component_at(channel, span, 3), component_at(channel, span, 0),
                          component_at(channel, span, 1), component_at(channel, span, 2)};
    const glm::dquat exact{curve};
    const double norm = glm::dot(exact, exact);
    return norm > 0.0 ? glm::quat{exact * (1.0 / std::sqrt(norm))} : left;
}

double time_in_clip(double time_s, double duration_s, bool looping) {
    if (std::isnan(time_s) || !(duration_s > 0.0)) return 0.0;
    if (!looping) return std::clamp(time_s, 0.0, duration_s);
    if (time_s >= 0.0 && time_s <= duration_s) return time_s;
    if (std::isinf(time_s)) return 0.0;
    const double rest = std::fmod(time_s, duration_s);  // exact in IEEE 754, hence the same everywhere
    return rest < 0.0 ? duration_s + rest : rest;
}

}  // namespace rambla::systems
