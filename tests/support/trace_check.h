#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rambla::tests {

/// A complete event of a trace, read back.
struct ReadSpan {
    std::string name;
    std::string category;
    std::int64_t begin_ns = 0;
    std::int64_t end_ns = 0;
    int track = 0;
    nlohmann::json args;
};

/// A trace, read back.
struct ReadTrace {
    std::vector<ReadSpan> spans;             ///< in the order of the file
    std::map<int, std::string> track_names;  ///< by track

    [[nodiscard]] std::vector<ReadSpan> of(const std::string& category) const {
        std::vector<ReadSpan> chosen;
        std::copy_if(spans.begin(), spans.end(), std::back_inserter(chosen),
                     [&](const ReadSpan& span) { return span.category == category; });
        return chosen;
    }
    /// How often each name comes.
    [[nodiscard]] static std::map<std::string, std::size_t> counts(const std::vector<ReadSpan>& of) {
        std::map<std::string, std::size_t> counts;
        for (const ReadSpan& span : of)
            ++counts[span.name];
        return counts;
    }
};

/// Throws nlohmann's errors where the text is no JSON or a key is missing.
[[nodiscard]] inline ReadTrace read_trace(const std::string& text) {
    // To whole nanoseconds: the file has three places after the point of a microsecond.
    const auto nanoseconds = [](const nlohmann::json& us) {
        return std::llround(us.get<double>() * 1000.0);
    };
    ReadTrace trace;
    for (const nlohmann::json& event : nlohmann::json::parse(text)) {
        const int track = event.at("tid");
        if (event.at("ph") == "M") {
            trace.track_names[track] = event.at("args").at("name");
            continue;
        }
        const std::int64_t begin_ns = nanoseconds(event.at("ts"));
        trace.spans.push_back({.name = event.at("name"),
                               .category = event.at("cat"),
                               .begin_ns = begin_ns,
                               .end_ns = begin_ns + nanoseconds(event.at("dur")),
                               .track = track,
                               .args = event.at("args")});
    }
    return trace;
}

/// What is wrong with the times, or nothing: a time or duration below 0, a track without a name, spans of one
/// track that are not in the order of their begins, or that overlap without one lying in the other.
[[nodiscard]] inline std::string fault_of(const ReadTrace& trace) {
    std::map<int, std::vector<ReadSpan>> open;
    for (const ReadSpan& span : trace.spans) {
        const std::string named = span.name + " at " + std::to_string(span.begin_ns) + " ns";
        if (span.begin_ns < 0 || span.end_ns < span.begin_ns) return named + ": time below 0";
        if (trace.track_names.count(span.track) == 0) return named + ": its track has no name";
        std::vector<ReadSpan>& around = open[span.track];
        if (!around.empty() && span.begin_ns < around.back().begin_ns)
            return named + " stands behind " + around.back().name + ", which begins later";
        while (!around.empty() && around.back().end_ns <= span.begin_ns)
            around.pop_back();
        if (!around.empty() && span.end_ns > around.back().end_ns)
            return named + " ends after " + around.back().name + ", in which it begins";
        around.push_back(span);
    }
    return {};
}

}  // namespace rambla::tests
