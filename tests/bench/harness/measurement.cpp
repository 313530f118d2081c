#include "bench/harness/measurement.h"

#include <algorithm>
#include <charconv>

namespace rambla::bench {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

bool is_variant(std::string_view part) {
    const auto is = [&](std::string_view base) {
        return part == base || (part.starts_with(base) && part[base.size()] == '_');
    };
    return is("bare") || is("rambla");
}

/// "10000", or "N:10000" as Google Benchmark writes named arguments.
std::optional<std::uint64_t> number_in(std::string_view part) {
    constexpr std::string_view k_name_of_size = "N:";
    if (part.starts_with(k_name_of_size)) part.remove_prefix(k_name_of_size.size());
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc{} || end != part.data() + part.size()) return std::nullopt;
    return value;
}

}  // namespace

std::optional<BenchmarkName> parse_name(std::string_view name) {
    const std::vector<std::string_view> parts = split(name, '/');
    const auto variant = std::find_if(parts.begin(), parts.end(), is_variant);
    if (variant == parts.end() || variant == parts.begin()) return std::nullopt;
    BenchmarkName parsed;
    parsed.operation =
        std::string{name.substr(0, static_cast<std::size_t>(variant->data() - name.data()) - 1)};
    parsed.variant = std::string{*variant};
    for (auto part = variant + 1; part != parts.end(); ++part) {
        if (const auto size = number_in(*part)) {
            parsed.size = *size;
            break;
        }
    }
    return parsed;
}

double median(std::span<const double> values) {
    if (values.empty()) return 0.0;
    std::vector<double> sorted{values.begin(), values.end()};
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

double median_ratio(const Measurement& subject, const Measurement& baseline) {
    const std::size_t repetitions = std::min(subject.ns_per_item.size(), baseline.ns_per_item.size());
    std::vector<double> ratios;
    for (std::size_t i = 0; i < repetitions; ++i)
        ratios.push_back(subject.ns_per_item[i] / baseline.ns_per_item[i]);
    return median(ratios);
}

}  // namespace rambla::bench
