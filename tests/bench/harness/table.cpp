#include "bench/harness/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace rambla::bench {
namespace {

const Measurement* find(std::span<const Measurement> measurements, std::string_view operation,
                        std::string_view variant, std::uint64_t size) {
    const auto found = std::ranges::find_if(measurements, [&](const Measurement& measurement) {
        const BenchmarkName& name = measurement.name;
        return name.operation == operation && name.variant == variant && name.size == size;
    });
    return found == measurements.end() ? nullptr : &*found;
}

bool is_bare(const Measurement& measurement) {
    return measurement.name.variant.starts_with("bare");
}

/// "_2threads" of "rambla_2threads".
std::string_view suffix(std::string_view variant) {
    const std::size_t underscore = variant.find('_');
    return underscore == std::string_view::npos ? std::string_view{} : variant.substr(underscore);
}

/// What a measurement of ours is compared with: the bare variant with the same suffix, else the plain one.
const Measurement* bare_of(std::span<const Measurement> measurements, const BenchmarkName& name) {
    const std::string same = "bare" + std::string{suffix(name.variant)};
    const Measurement* found = find(measurements, name.operation, same, name.size);
    return found != nullptr ? found : find(measurements, name.operation, "bare", name.size);
}

std::string unit_of(const Target& target) {
    switch (target.measure) {
        case Measure::ratio:
            return "x";
        case Measure::nanoseconds:
            return "ns";
        case Measure::speed_up:
            return "x faster";
        case Measure::share:
            return "share";
        default:
            return std::string{target.counter};
    }
}

Row row_without_target(std::span<const Measurement> measurements, const Measurement& measured) {
    Row row{.operation = measured.name.operation + std::string{suffix(measured.name.variant)},
            .size = measured.name.size,
            .bare_ns = {},
            .rambla_ns = median(measured.ns_per_item),
            .value = {},
            .unit = "x",
            .rates = {}};
    for (const auto& [name, value] : measured.counters)
        if (name.ends_with("/s")) row.rates.emplace_back(name, value);
    if (const Measurement* bare = bare_of(measurements, measured.name)) {
        row.bare_ns = median(bare->ns_per_item);
        row.value = median_ratio(measured, *bare);
    }
    return row;
}

std::optional<double> value_of(std::span<const Measurement> measurements, const Measurement& measured,
                               const Target& target) {
    const BenchmarkName& name = measured.name;
    const Measurement* baseline = find(measurements, name.operation, target.baseline, name.size);
    switch (target.measure) {
        case Measure::ratio:
            if (baseline == nullptr) return {};
            return median_ratio(measured, *baseline);
        case Measure::speed_up:
        case Measure::share:
            if (baseline == nullptr) return {};
            return median_ratio(*baseline, measured);
        case Measure::nanoseconds:
            return median(measured.ns_per_item);
        default:
            const auto counter = measured.counters.find(std::string{target.counter});
            if (counter == measured.counters.end()) return {};
            return counter->second;
    }
}

Row row_of(std::span<const Measurement> measurements, const Measurement& measured, const Target& target) {
    Row row = row_without_target(measurements, measured);
    row.value = value_of(measurements, measured, target);
    row.unit = unit_of(target);
    row.target = &target;
    row.verdict = row.value ? judge(target, *row.value) : Verdict::not_measured;
    return row;
}

Row row_not_measured(const Target& target) {
    return {.operation = std::string{target.operation} + std::string{suffix(target.subject)},
            .size = target.size,
            .bare_ns = {},
            .rambla_ns = {},
            .value = {},
            .unit = unit_of(target),
            .rates = {},
            .target = &target,
            .verdict = Verdict::not_measured};
}

std::string_view text_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::goal:
            return "goal";
        case Verdict::solid:
            return "solid";
        case Verdict::missed:
            return "MISSED";
        case Verdict::not_measured:
            return "not measured";
        default:
            return "";
    }
}

/// Three figures that count, so that 0.43 ns and 1520 ns both read well.
std::string figure(std::optional<double> value) {
    if (!value) return "-";
    const int decimals = *value >= 100 ? 0 : *value >= 10 ? 1 : 2;
    return fmt::format("{:.{}f}", *value, decimals);
}

std::string limit(const Target* target, double Target::*which) {
    if (target == nullptr) return "";
    return fmt::format("{} {}", wants_at_least(target->measure) ? ">=" : "<=", figure(target->*which));
}

std::string rates_of(const Row& row) {
    std::string text;
    for (const auto& [unit, value] : row.rates)
        text += fmt::format("  {} {}", figure(value), unit);
    return text;
}

}  // namespace

std::vector<Row> make_rows(std::span<const Measurement> measurements, std::span<const Target> targets) {
    std::vector<Row> rows;
    std::vector<bool> judged(measurements.size());
    for (const Target& target : targets) {
        const std::size_t before = rows.size();
        for (std::size_t i = 0; i < measurements.size(); ++i) {
            const BenchmarkName& name = measurements[i].name;
            const bool meant = name.operation == target.operation && name.variant == target.subject &&
                               (target.size == 0 || name.size == target.size);
            if (!meant) continue;
            rows.push_back(row_of(measurements, measurements[i], target));
            judged[i] = true;
        }
        if (rows.size() == before) rows.push_back(row_not_measured(target));
    }
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (!judged[i] && !is_bare(measurements[i]))
            rows.push_back(row_without_target(measurements, measurements[i]));
    }
    return rows;
}

std::string to_text(std::span<const Row> rows, const Machine& machine) {
    std::size_t width = 9;
    for (const Row& row : rows)
        width = std::max(width, row.operation.size());
    std::string text = fmt::format("{}\n\n{:<{}} {:>8} {:>9} {:>9} {:>8} {:<16} {:>8} {:>8}  {}\n",
                                   to_text(machine), "operation", width, "N", "bare ns", "rambla ns", "value",
                                   "unit", "solid", "goal", "verdict");
    for (const Row& row : rows) {
        const std::string size = row.size == 0 ? "any" : std::to_string(row.size);
        text += fmt::format("{:<{}} {:>8} {:>9} {:>9} {:>8} {:<16} {:>8} {:>8}  {}{}\n", row.operation, width,
                            size, figure(row.bare_ns), figure(row.rambla_ns), figure(row.value), row.unit,
                            limit(row.target, &Target::solid), limit(row.target, &Target::goal),
                            text_of(row.verdict), rates_of(row));
    }
    return text;
}

std::string to_json(std::span<const Row> rows, std::span<const Measurement> measurements,
                    const Machine& machine) {
    const auto or_null = [](std::optional<double> value) {
        return value ? nlohmann::json(*value) : nlohmann::json();
    };
    nlohmann::ordered_json json;
    for (const auto& [key, value] : machine)
        json["machine"][key] = value;
    json["rows"] = nlohmann::json::array();
    for (const Row& row : rows) {
        nlohmann::ordered_json line{{"operation", row.operation},      {"size", row.size},
                                    {"bare_ns", or_null(row.bare_ns)}, {"rambla_ns", or_null(row.rambla_ns)},
                                    {"value", or_null(row.value)},     {"unit", row.unit},
                                    {"verdict", text_of(row.verdict)}};
        if (row.target != nullptr) {
            line["solid"] = row.target->solid;
            line["goal"] = row.target->goal;
            line["reason"] = row.target->reason;
        }
        json["rows"].push_back(line);
    }
    json["measurements"] = nlohmann::json::array();
    for (const Measurement& measurement : measurements) {
        json["measurements"].push_back({{"operation", measurement.name.operation},
                                        {"variant", measurement.name.variant},
                                        {"size", measurement.name.size},
                                        {"ns_per_item", measurement.ns_per_item},
                                        {"counters", measurement.counters}});
    }
    return json.dump(2) + "\n";
}

}  // namespace rambla::bench
