#include "assets/generate/places.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include "assets/generate/agents.h"
#include "assets/generate/blocks.h"
#include "assets/generate/city.h"

namespace rambla::assets {

namespace {

/// A scene of which there is only one.
struct FixedScene {
    std::string_view name;
    Place (*generate)();
};
constexpr std::array<FixedScene, 2> k_fixed_scenes{
    {{"blocks", generate_blocks}, {"agents", generate_agents}}};

std::string fixed_names() {
    std::string names;
    for (const FixedScene& scene : k_fixed_scenes)
        names += ", " + std::string{scene.name};
    return names;
}

[[noreturn]] void refuse(std::string_view spec, std::string_view part, const std::string& expected) {
    throw std::invalid_argument("scene \"" + std::string{spec} + "\": \"" + std::string{part} +
                                "\": " + expected);
}

std::string number_text(double value) {
    std::string text = std::to_string(value);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string parameter_names() {
    std::string names = "blocks";
    for (const Parameter<CityParameters>& parameter : k_city_parameters)
        names += ", " + std::string{parameter.name};
    return names;
}

void assign(CityParameters& city, std::string_view spec, std::string_view part, std::string_view name,
            std::string_view text) {
    for (const Parameter<CityParameters>& parameter : k_city_parameters) {
        if (parameter.name != name) continue;
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = parameter.kind != ParameterKind::integer || value == std::floor(value);
        const bool read = error == std::errc{} && end == text.data() + text.size();
        if (!read || !(value >= parameter.minimum && value <= parameter.maximum) || !whole)
            refuse(spec, part,
                   "expected a " + std::string{parameter.kind == ParameterKind::integer ? "whole " : ""} +
                       "number from " + number_text(parameter.minimum) + " to " +
                       number_text(parameter.maximum));
        parameter.set(city, value);
        return;
    }
    refuse(spec, part, "unknown parameter; known: " + parameter_names());
}

CityParameters parse_city(std::string_view spec, std::string_view list) {
    CityParameters city;
    while (!list.empty()) {
        const std::string_view part = list.substr(0, list.find(','));
        list.remove_prefix(std::min(list.size(), part.size() + 1));
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos)
            refuse(spec, part, "expected name=value; names: " + parameter_names());
        const std::string_view name = part.substr(0, equals);
        const std::string_view value = part.substr(equals + 1);
        if (name == "blocks") {
            const std::size_t times = value.find('x');
            if (times == std::string_view::npos)
                refuse(spec, part, "expected two counts of blocks, such as blocks=4x2");
            assign(city, spec, part, "blocks-x", value.substr(0, times));
            assign(city, spec, part, "blocks-z", value.substr(times + 1));
        } else {
            assign(city, spec, part, name, value);
        }
    }
    return city;
}

}  // namespace

Place generate_place(std::string_view spec, std::uint64_t seed, TimeOfDay time) {
    const std::string_view name = spec.substr(0, spec.find(':'));
    const auto fixed = std::find_if(k_fixed_scenes.begin(), k_fixed_scenes.end(),
                                    [&](const FixedScene& scene) { return scene.name == name; });
    if (fixed == k_fixed_scenes.end() && name != "city" && name != "street")
        refuse(spec, name, "unknown scene; known: city, street" + fixed_names());
    const bool parameters = name.size() < spec.size();
    if (fixed != k_fixed_scenes.end()) {
        if (parameters) refuse(spec, spec.substr(name.size()), "this scene has no parameters");
        if (time != TimeOfDay{}) refuse(spec, to_text(time), "the light of this scene has no time of day");
        return fixed->generate();
    }
    if (parameters && name.size() + 1 == spec.size())
        refuse(spec, spec, "expected parameters after the colon");
    return generate_city(parse_city(spec, parameters ? spec.substr(name.size() + 1) : std::string_view{}),
                         seed, time);
}

}  // namespace rambla::assets
