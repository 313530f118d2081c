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

double median_resident_bytes(std::span<const HeldSample> samples) {
    std::vector<double> bytes;
    for (const HeldSample& sample : samples)
        bytes.push_back(static_cast<double>(sample.resident_bytes));
    return median(bytes);
}

template <class Member>
std::int64_t most(std::span<const HeldSample> samples, Member HeldSample::*member) {
    std::int64_t value = 0;
    for (const HeldSample& sample : samples)
        value = std::max(value, static_cast<std::int64_t>(sample.*member));
    return value;
}

std::string verdict_text(const Steadiness& result, std::uint64_t last_frame) {
    if (!result.known) return fmt::format("memory: too few frames after frame {} to tell\n", k_settled_frame);
    const std::string span = fmt::format("frames {} to {}", k_settled_frame, last_frame);
    if (result.steady) {
        return fmt::format("memory: steady over {} ({:+.1f} MiB resident, {:+} GL objects)\n", span,
                           static_cast<double>(result.resident_growth_bytes) / 1048576.0,
                           result.gl_object_growth);
    }
    return fmt::format(
        "memory: grew over {} by {:+.1f} MiB resident, {:+.1f} MiB on the GPU, {:+} GL objects\n", span,
        static_cast<double>(result.resident_growth_bytes) / 1048576.0,
        static_cast<double>(result.gpu_growth_bytes) / 1048576.0, result.gl_object_growth);
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
    result.resident_growth_bytes = std::llround(median_resident_bytes(late) - median_resident_bytes(early));
    result.gpu_growth_bytes = most(late, &HeldSample::gpu_bytes) - most(early, &HeldSample::gpu_bytes);
    result.gl_object_growth = most(late, &HeldSample::gl_objects) - most(early, &HeldSample::gl_objects);
    result.steady = result.resident_growth_bytes <= k_resident_tolerance_bytes &&
                    result.gpu_growth_bytes <= 0 && result.gl_object_growth <= 0;
    return result;
}

std::string to_text(const std::vector<HeldSample>& samples, std::uint64_t every) {
    std::string text;
    for (const HeldSample& sample : samples) {
        if (sample.frame % every != 0 && &sample != &samples.back()) continue;
        text += fmt::format("frame {:>5}: {:>10} resident, {:>10} on the GPU, {:>5} GL objects\n",
                            sample.frame, bytes_text(static_cast<double>(sample.resident_bytes)),
                            bytes_text(static_cast<double>(sample.gpu_bytes)), sample.gl_objects);
    }
    return text + verdict_text(steadiness(samples), samples.empty() ? 0 : samples.back().frame);
}

}  // namespace rambla::game
