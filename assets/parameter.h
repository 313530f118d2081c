#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace rambla {

enum class ParameterKind : std::uint8_t { boolean, integer, real, choice };

/// One field of a parameter struct, described once for the command line, the overlay and the studies.
/// The default is the field's value in a default-constructed Struct.
template <class Struct>
struct Parameter {
    std::string_view name;  ///< as on the command line, for example "size"
    std::string_view unit;  ///< "texels", "m", "deg", or empty
    std::string_view help;  ///< one sentence
    ParameterKind kind = ParameterKind::real;
    double minimum = 0.0;
    double maximum = 1.0;
    std::span<const std::string_view> choices;  ///< names of an enum's values, in order; only for choice
    double (*get)(const Struct&) = nullptr;
    void (*set)(Struct&, double) = nullptr;  ///< the value must lie in [minimum, maximum]
};

namespace detail {
template <class>
struct member_of;
template <class Struct, class Field>
struct member_of<Field Struct::*> {
    using struct_type = Struct;
    using field_type = Field;
};
}  // namespace detail

/// Describes a bool, integer or real field: `parameter<&ShadowParameters::size>("size", "texels", 256, 8192,
/// "…")`.
template <auto Member>
[[nodiscard]] constexpr auto parameter(std::string_view name, std::string_view unit, double minimum,
                                       double maximum, std::string_view help) {
    using Struct = typename detail::member_of<decltype(Member)>::struct_type;
    using Field = typename detail::member_of<decltype(Member)>::field_type;
    constexpr ParameterKind kind = std::is_same_v<Field, bool> ? ParameterKind::boolean
                                   : std::is_integral_v<Field> ? ParameterKind::integer
                                                               : ParameterKind::real;
    return Parameter<Struct>{.name = name,
                             .unit = unit,
                             .help = help,
                             .kind = kind,
                             .minimum = minimum,
                             .maximum = maximum,
                             .choices = {},
                             .get = [](const Struct& s) { return static_cast<double>(s.*Member); },
                             .set =
                                 [](Struct& s, double value) {
                                     s.*Member = static_cast<Field>(value);
                                 }};
}

/// Describes an enum field whose values count up from 0; `choices` names them and must have static storage.
template <auto Member>
[[nodiscard]] constexpr auto parameter(std::string_view name, std::span<const std::string_view> choices,
                                       std::string_view help) {
    using Struct = typename detail::member_of<decltype(Member)>::struct_type;
    using Field = typename detail::member_of<decltype(Member)>::field_type;
    static_assert(std::is_enum_v<Field>);
    return Parameter<Struct>{.name = name,
                             .unit = {},
                             .help = help,
                             .kind = ParameterKind::choice,
                             .minimum = 0.0,
                             .maximum = static_cast<double>(choices.size()) - 1.0,
                             .choices = choices,
                             .get = [](const Struct& s) { return static_cast<double>(s.*Member); },
                             .set =
                                 [](Struct& s, double value) {
                                     s.*Member = static_cast<Field>(static_cast<int>(value));
                                 }};
}

}  // namespace rambla
