#include "game/study/metrics/temporal.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "game/statistics.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

constexpr double k_short_time_s = 0.1;
constexpr double k_shortest_frame_s = 1e-6;  // 100 000 pictures kept; far below any frame

void require_same_sizes(FramePair reference, FramePair test) {
    require_same_size(reference.before, reference.after);
    require_same_size(reference.before, test.before);
    require_same_size(test.before, test.after);
}

void require_mask(const Picture& picture, std::size_t count) {
    if (count == picture.texels.size()) return;
    throw std::invalid_argument(fmt::format("an object's mask of {} pixels does not fit a picture of {}x{}",
                                            count, picture.width, picture.height));
}

/// Over the object's pixels and three channels.
double mean_change(FramePair frames, std::span<const std::uint8_t> object) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < object.size(); ++i) {
        if (object[i] == 0) continue;
        const glm::dvec3 before{finite_or_black(frames.before.texels[i])};
        const glm::dvec3 after{finite_or_black(frames.after.texels[i])};
        const glm::dvec3 change = glm::abs(after - before);
        sum += change.x + change.y + change.z;
        count += 3;
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace

double flicker_pct(FramePair reference, FramePair test, double tolerance) {
    require_same_sizes(reference, test);
    const auto changes = [&](FramePair frames, std::size_t i) {
        return largest_channel_difference(frames.before.texels[i], frames.after.texels[i]) > tolerance;
    };
    std::size_t flickering = 0;
    for (std::size_t i = 0; i < test.before.texels.size(); ++i)
        if (changes(test, i) && !changes(reference, i)) ++flickering;
    return percent(flickering, test.before.texels.size());
}

double pop_linear(FramePair reference, FramePair test, std::span<const std::uint8_t> object) {
    require_same_sizes(reference, test);
    require_mask(test.before, object.size());
    return std::max(mean_change(test, object) - mean_change(reference, object), 0.0);
}

PopMeter::PopMeter(double frame_s) {
    if (!(frame_s >= k_shortest_frame_s))
        throw std::invalid_argument(fmt::format("frames cannot be {} s apart", frame_s));
    frames_in_100ms_ = static_cast<std::size_t>(std::max(std::round(k_short_time_s / frame_s), 1.0));
}

void PopMeter::add(Picture reference, Picture test, std::vector<std::uint8_t> object) {
    require_same_size(reference, test);
    require_mask(test, object.size());
    if (!last_.empty()) require_same_size(last_.back().test, test);
    Frame frame{.reference = std::move(reference), .test = std::move(test), .object = std::move(object)};
    if (!last_.empty()) successive_.push_back(pop_between(last_.back(), frame));
    if (last_.size() == frames_in_100ms_) {
        in_100ms_.push_back(pop_between(last_.front(), frame));
        last_.pop_front();
    }
    last_.push_back(std::move(frame));
}

Pops PopMeter::result() const {
    return {.max_linear = percentile(successive_, 1.0),
            .p99_linear = percentile(successive_, 0.99),
            .in_100ms_linear = percentile(in_100ms_, 1.0)};
}

double PopMeter::pop_between(const Frame& before, const Frame& after) {
    std::vector<std::uint8_t> in_either = before.object;
    for (std::size_t i = 0; i < in_either.size(); ++i)
        in_either[i] |= after.object[i];
    return pop_linear({before.reference, after.reference}, {before.test, after.test}, in_either);
}

}  // namespace rambla::game::study
