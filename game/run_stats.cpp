#include "game/run_stats.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "game/pass_table.h"
#include "game/statistics.h"

namespace rambla::game {
namespace {

constexpr std::size_t k_fewest_samples = 8;  // quarters of two at least

double median_of(std::span<const HeldSample> samples, std::uint64_t HeldSample::*member) {
    std::vector<double> values;
    for (const HeldSample& sample : samples)
        values.push_back(static_cast<double>(sample.*member));
    return median(values);
}

template <class Member>
std::int64_t most(std::span<const HeldSample> samples, Member HeldSample::*member) {
    std::int64_t value = 0;
    for (const HeldSample& sample : samples)
        value = std::max(value, static_cast<std::int64_t>(sample.*member));
    return value;
}

double mebibytes(std::int64_t bytes) {
    return static_cast<double>(bytes) / 1048576.0;
}

std::string verdict_text(const Steadiness& result, std::uint64_t last_frame) {
    if (!result.known) return fmt::format("memory: too few frames after frame {} to tell\n", k_settled_frame);
    const std::string span = fmt::format("frames {} to {}", k_settled_frame, last_frame);
    return fmt::format(
        "memory: {} over {} ({:+.1f} MiB heap, {:+.1f} MiB resident with the driver's bins, {:+.1f} MiB on "
        "the "
        "GPU beside textures, {:+} GL objects)\n",
        result.steady ? "steady" : "grew", span, mebibytes(result.heap_growth_bytes),
        mebibytes(result.resident_growth_bytes), mebibytes(result.gpu_growth_bytes), result.gl_object_growth);
}

}  // namespace

Steadiness steadiness(const std::vector<HeldSample>& samples) {
    const auto first = std::find_if(samples.begin(), samples.end(),
                                    [](const HeldSample& sample) { return sample.frame >= k_settled_frame; });
    const std::span<const HeldSample> settled{first, samples.end()};
    if (settled.size() < k_fewest_samples) return {};
    const std::size_t quarter = settled.size() / 4;
    const std::span<const HeldSample> early = settled.first(quarter);
    const std::span<const HeldSample> late = settled.last(quarter);
    Steadiness result{.known = true};
    const auto growth = [&](std::uint64_t HeldSample::*member) {
        return std::llround(median_of(late, member) - median_of(early, member));
    };
    result.heap_growth_bytes = growth(&HeldSample::heap_bytes);
    result.resident_growth_bytes = growth(&HeldSample::resident_bytes);
    result.gpu_growth_bytes = most(late, &HeldSample::gpu_bytes) - most(early, &HeldSample::gpu_bytes);
    result.gl_object_growth = most(late, &HeldSample::gl_objects) - most(early, &HeldSample::gl_objects);
    result.steady = result.heap_growth_bytes <= k_heap_tolerance_bytes &&
                    result.resident_growth_bytes <= k_resident_tolerance_bytes &&
                    result.gpu_growth_bytes <= 0 && result.gl_object_growth <= 0;
    return result;
}

std::string to_text(const std::vector<HeldSample>& samples, std::uint64_t every) {
    std::string text;
    for (const HeldSample& sample : samples) {
        if (sample.frame % every != 0 && &sample != &samples.back()) continue;
        text += fmt::format(
            "frame {:>5}: {:>10} heap, {:>10} resident, {:>10} on the GPU beside textures, {:>5} GL "
            "objects\n",
            sample.frame, bytes_text(static_cast<double>(sample.heap_bytes)),
            bytes_text(static_cast<double>(sample.resident_bytes)),
            bytes_text(static_cast<double>(sample.gpu_bytes)), sample.gl_objects);
    }
    return text + verdict_text(steadiness(samples), samples.empty() ? 0 : samples.back().frame);
}

}  // namespace rambla::game
