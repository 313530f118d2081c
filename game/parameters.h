#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assets/parameter.h"

namespace rambla::game {

/// One field of one living struct, as its parameter table describes it: what command line and overlay work
/// on.
struct BoundParameter {
    std::string_view name, unit, help;
    ParameterKind kind = ParameterKind::real;
    double minimum = 0.0;
    double maximum = 1.0;
    std::span<const std::string_view> choices;
    std::function<double()> get;
    std::function<void(double)> set;  ///< the value must lie in [minimum, maximum]
};

/// The struct must outlive what is returned, and stay where it is.
template <class Struct, std::size_t Count>
[[nodiscard]] std::vector<BoundParameter> bind(const std::array<Parameter<Struct>, Count>& table,
                                               Struct& object) {
    std::vector<BoundParameter> bound;
    bound.reserve(Count);
    for (const Parameter<Struct>& p : table) {
        bound.push_back({.name = p.name,
                         .unit = p.unit,
                         .help = p.help,
                         .kind = p.kind,
                         .minimum = p.minimum,
                         .maximum = p.maximum,
                         .choices = p.choices,
                         .get = [&object, get = p.get] { return get(object); },
                         .set =
                             [&object, set = p.set](double value) {
                                 set(object, value);
                             }});
    }
    return bound;
}

/// Sets one parameter from text. @throws std::invalid_argument  naming the parameter, what was found and what
/// is expected
void set_from_text(const BoundParameter& parameter, std::string_view text);

/// Sets parameters from `CHOICE:name=value,name=value`. CHOICE sets the first parameter and may be left out
/// where fields follow (`name=value,…`). Nothing is set unless all of the text is right.
/// @throws std::invalid_argument  as set_from_text, and for unknown names, listing the known ones
void set_from_method_text(std::span<const BoundParameter> parameters, std::string_view text);

/// "256 to 8192 texels", or the choices with commas: what set_from_text takes.
[[nodiscard]] std::string expected_text(const BoundParameter& parameter);

/// The present value as set_from_text reads it.
[[nodiscard]] std::string value_text(const BoundParameter& parameter);

/// One line per parameter for --help: name, range, present value as the default, and what it is for.
[[nodiscard]] std::string help_text(std::span<const BoundParameter> parameters);

}  // namespace rambla::game
