#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

#include "game/study/study.h"

namespace rambla::game::study {
namespace {

constexpr std::array k_studies{&k_gbuffer_study,      &k_lighting_study, &k_detail_study,
                               &k_luminance_study,    &k_tonemap_study,  &k_bloom_study,
                               &k_antialiasing_study, &k_passes_study,   &k_compression_study};

std::string known_names() {
    std::string names = "all";
    for (const Study* study : k_studies)
        names += fmt::format(", {}", study->name);
    return names;
}

}  // namespace

std::span<const Study* const> all_studies() {
    return k_studies;
}

std::vector<const Study*> find_studies(std::span<const std::string> names) {
    for (const std::string& name : names) {
        const bool known = std::any_of(k_studies.begin(), k_studies.end(),
                                       [&](const Study* study) { return study->name == name; });
        if (!known && name != "all")
            throw std::invalid_argument{
                fmt::format("there is no study '{}', expected of: {}", name, known_names())};
    }
    const auto is_named = [&](std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<const Study*> found;
    std::copy_if(k_studies.begin(), k_studies.end(), std::back_inserter(found),
                 [&](const Study* study) { return is_named("all") || is_named(study->name); });
    return found;
}

StudyResult run_study(const Study& study, StudyContext& context, const std::string& command) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    StudyResult result;
    result.name = study.name;
    result.title = study.name;
    result.command = command;
    try {
        study.run(context, result);
        if (context.stopped()) result.incomplete = "It was interrupted: what follows is what it had by then.";
    } catch (const std::exception& error) {
        result.incomplete = fmt::format("It failed: {}", error.what());
    }
    result.duration_s = std::chrono::duration<double>(Clock::now() - start).count();
    return result;
}

}  // namespace rambla::game::study
