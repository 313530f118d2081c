#include "game/study/metrics/trail.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "assets/process/srgb.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

constexpr std::uint32_t k_covered = 0;
constexpr std::uint32_t k_never_covered = std::numeric_limits<std::uint32_t>::max();

std::uint32_t next_age(std::uint32_t age, bool moving) {
    if (moving) return k_covered;
    return age == k_never_covered ? age : age + 1;
}

/// Mean of the channels, of what a display is sent.
double difference_display(glm::vec3 a, glm::vec3 b) {
    double sum = 0.0;
    for (int channel = 0; channel < 3; ++channel)
        sum += std::abs(static_cast<double>(assets::srgb_from_linear(finite_or_black(a)[channel])) -
                        static_cast<double>(assets::srgb_from_linear(finite_or_black(b)[channel])));
    return sum / 3.0;
}

}  // namespace

TrailMeter::TrailMeter(std::uint32_t longest_frames) : sums_(longest_frames), pixels_(longest_frames) {}

void TrailMeter::add(const Picture& reference, const Picture& plain, const Picture& test,
                     std::span<const std::uint8_t> moving) {
    require_same_size(reference, plain);
    require_same_size(reference, test);
    if (ages_.empty()) ages_.assign(moving.size(), k_never_covered);
    if (moving.size() != reference.texels.size() || ages_.size() != moving.size())
        throw std::invalid_argument(fmt::format("{} pixels that may move do not fit a picture of {}x{}",
                                                moving.size(), reference.width, reference.height));
    for (std::size_t i = 0; i < moving.size(); ++i) {
        ages_[i] = next_age(ages_[i], moving[i] != 0);
        if (ages_[i] == k_covered || ages_[i] > sums_.size()) continue;
        const std::size_t age = ages_[i] - 1;
        sums_[age] += difference_display(test.texels[i], reference.texels[i]) -
                      difference_display(plain.texels[i], reference.texels[i]);
        ++pixels_[age];
    }
}

std::vector<double> TrailMeter::excess_display() const {
    std::vector<double> means(sums_.size());
    for (std::size_t age = 0; age < means.size(); ++age)
        if (pixels_[age] > 0) means[age] = sums_[age] / static_cast<double>(pixels_[age]);
    return means;
}

std::uint32_t trail_frames(std::span<const double> excess_display, double tolerance) {
    std::uint32_t frames = 0;
    for (std::uint32_t age = 0; age < excess_display.size(); ++age)
        if (excess_display[age] > tolerance) frames = age + 1;
    return frames;
}

}  // namespace rambla::game::study
