#include "game/parameters.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace rambla::game {
namespace {

std::optional<double> parse_number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<double> parse_boolean(std::string_view text) {
    if (text == "on" || text == "true" || text == "1") return 1.0;
    if (text == "off" || text == "false" || text == "0") return 0.0;
    return std::nullopt;
}

std::optional<double> parse_value(const BoundParameter& parameter, std::string_view text) {
    switch (parameter.kind) {
        case ParameterKind::boolean:
            return parse_boolean(text);
        case ParameterKind::choice: {
            const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
            if (found == parameter.choices.end()) return std::nullopt;
            return static_cast<double>(found - parameter.choices.begin());
        }
        case ParameterKind::integer:
        case ParameterKind::real:
            break;
    }
    const std::optional<double> value = parse_number(text);
    if (!value || *value < parameter.minimum || *value > parameter.maximum) return std::nullopt;
    if (parameter.kind == ParameterKind::integer && *value != std::floor(*value)) return std::nullopt;
    return value;
}

double checked_value(const BoundParameter& parameter, std::string_view text) {
    if (const std::optional<double> value = parse_value(parameter, text)) return *value;
    throw std::invalid_argument{
        fmt::format("{} is '{}', expected {}", parameter.name, text, expected_text(parameter))};
}

std::string names(std::span<const BoundParameter> parameters) {
    std::string text;
    for (const BoundParameter& p : parameters) {
        if (!text.empty()) text += ", ";
        text += p.name;
    }
    return text;
}

const BoundParameter& parameter_named(std::span<const BoundParameter> parameters, std::string_view name) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const BoundParameter& p) { return p.name == name; });
    if (found != parameters.end()) return *found;
    throw std::invalid_argument{
        fmt::format("there is no parameter '{}', expected one of: {}", name, names(parameters))};
}

/// Cuts the text before the first `separator` off `rest`, which keeps what follows it.
std::string_view take_until(std::string_view& rest, char separator) {
    const std::size_t at = rest.find(separator);
    const std::string_view head = rest.substr(0, at);
    rest = at == std::string_view::npos ? std::string_view{} : rest.substr(at + 1);
    return head;
}

}  // namespace

void set_from_text(const BoundParameter& parameter, std::string_view text) {
    parameter.set(checked_value(parameter, text));
}

void set_from_method_text(std::span<const BoundParameter> parameters, std::string_view text) {
    struct Assignment {
        const BoundParameter* parameter;
        double value;
    };
    std::vector<Assignment> assignments;
    std::string_view fields = text;
    const bool has_choice = text.substr(0, text.find(':')).find('=') == std::string_view::npos;
    if (has_choice) {
        const std::string_view choice = take_until(fields, ':');
        assignments.push_back({&parameters.front(), checked_value(parameters.front(), choice)});
    }
    while (!fields.empty()) {
        std::string_view value = take_until(fields, ',');
        const std::string_view name = take_until(value, '=');
        const BoundParameter& parameter = parameter_named(parameters, name);
        assignments.push_back({&parameter, checked_value(parameter, value)});
    }
    for (const Assignment& assignment : assignments)
        assignment.parameter->set(assignment.value);
}

std::string expected_text(const BoundParameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::boolean:
            return "on or off";
        case ParameterKind::choice:
            return fmt::format("one of: {}", fmt::join(parameter.choices, ", "));
        case ParameterKind::integer:
        case ParameterKind::real:
            break;
    }
    return fmt::format(
        "{}{} to {}{}{}", parameter.kind == ParameterKind::integer ? "a whole number from " : "",
        parameter.minimum, parameter.maximum, parameter.unit.empty() ? "" : " ", parameter.unit);
}

std::string value_text(const BoundParameter& parameter) {
    const double value = parameter.get();
    switch (parameter.kind) {
        case ParameterKind::boolean:
            return value != 0.0 ? "on" : "off";
        case ParameterKind::choice:
            return std::string{parameter.choices[static_cast<std::size_t>(value)]};
        case ParameterKind::integer:
            return fmt::format("{:.0f}", value);
        case ParameterKind::real:
            break;
    }
    return fmt::format("{:.6g}", value);
}

std::string help_text(std::span<const BoundParameter> parameters) {
    std::string text;
    for (const BoundParameter& p : parameters) {
        text +=
            fmt::format("    {:<12} {} ({}; default {})\n", p.name, p.help, expected_text(p), value_text(p));
    }
    return text;
}

}  // namespace rambla::game
