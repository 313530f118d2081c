#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/description.h"
#include "ecs/entity.h"

namespace rambla::ecs {

/// Specialise it to describe a type's fields, for snapshots, inspectors and JSON:
///
///     template <> struct reflection<Position> {
///         static constexpr auto value = describe<Position>("position")
///                                           .field("x_m", &Position::x, {.unit = "m"})
///                                           .field("y_m", &Position::y, {.unit = "m"});
///     };
///     template <> struct reflection<Gear> {
///         static constexpr auto value = enumeration<Gear>({{"park", Gear::park}, {"drive", Gear::drive}});
///     };
///
/// Fields are bool, integers, float, double, described enums, Entity, std::string, described structs, and
/// std::array of these. Structs of a library that knows nothing of us are described in the same way by
/// whoever uses them; StructReflection::elements() serves those whose members cannot be named. What is not
/// described is neither saved nor shown.
template <class T>
struct reflection {};

/// What is described: has a specialisation of reflection.
template <class T>
concept Reflected = requires {
    reflection<T>::value;
};

/// A field as the specialisation declares it.
template <class Struct, class Member>
struct MemberField {
    std::string_view name;
    Member Struct::*member;
    FieldOptions options;
};

/// The whole struct is elements of one type, one after the other.
template <class Element>
struct ElementsField {
    std::string_view name;
    FieldOptions options;
};

/// Description of a struct as the specialisation builds it, field by field.
template <class Struct, class... Fields>
struct StructReflection {
    std::string_view name;         ///< in snapshots
    std::uint32_t version;         ///< see TypeRegistry::migrate
    std::tuple<Fields...> fields;  ///< in the order of their description

    /// @param field_name  unique in the struct; what snapshots match fields by
    template <class Member>
    [[nodiscard]] constexpr auto field(std::string_view field_name, Member Struct::*member,
                                       const FieldOptions& options = {}) const {
        return with(MemberField<Struct, Member>{field_name, member, options});
    }

    /// For structs whose members cannot be named, such as a matrix of a library: nothing but elements of one
    /// type, without gaps.
    template <class Element>
    [[nodiscard]] constexpr auto elements(std::string_view field_name,
                                          const FieldOptions& options = {}) const {
        static_assert(std::is_trivially_copyable_v<Struct> && sizeof(Struct) % sizeof(Element) == 0);
        return with(ElementsField<Element>{field_name, options});
    }

private:
    template <class Field>
    constexpr auto with(const Field& field) const {
        return StructReflection<Struct, Fields..., Field>{name, version,
                                                          std::tuple_cat(fields, std::tuple<Field>{field})};
    }
};

/// Begins the description of a struct.
/// @param name     unique among the types of a TypeRegistry; what snapshots know it by
/// @param version  count up when fields change; see TypeRegistry::migrate
template <class Struct>
[[nodiscard]] constexpr StructReflection<Struct> describe(std::string_view name, std::uint32_t version = 1) {
    return {name, version, {}};
}

/// A value of an enum with its name.
template <class Enum>
struct NamedValue {
    std::string_view name;
    Enum value;
};

/// Description of an enum. A value without a name is refused wherever it comes from outside.
template <class Enum, std::size_t N>
[[nodiscard]] constexpr std::array<EnumValue, N> enumeration(const NamedValue<Enum> (&values)[N]) {
    std::array<EnumValue, N> named{};
    for (std::size_t i = 0; i < N; ++i)
        named[i] = {values[i].name, static_cast<std::int64_t>(values[i].value)};
    return named;
}

/// The run-time view of a described struct; lives as long as the program.
template <Reflected T>
const StructDescription& description_of();

// ----------------------------------------------------------------------------------------------------

namespace detail {

template <class T>
struct ArrayOf {
    using Element = T;
    static constexpr std::uint32_t count = 1;
};
template <class T, std::size_t N>
struct ArrayOf<std::array<T, N>> {
    static_assert(N > 0);
    using Element = T;
    static constexpr std::uint32_t count = static_cast<std::uint32_t>(N);
};

template <class T>
constexpr FieldKind kind_of() {
    if constexpr (std::is_same_v<T, bool>) {
        return FieldKind::boolean;
    } else if constexpr (std::is_same_v<T, Entity>) {
        return FieldKind::entity;
    } else if constexpr (std::is_same_v<T, std::string>) {
        return FieldKind::text;
    } else if constexpr (std::is_enum_v<T>) {
        return kind_of<std::underlying_type_t<T>>();
    } else if constexpr (std::is_integral_v<T>) {
        constexpr bool is_signed = std::is_signed_v<T>;
        if constexpr (sizeof(T) == 1) return is_signed ? FieldKind::int8 : FieldKind::uint8;
        if constexpr (sizeof(T) == 2) return is_signed ? FieldKind::int16 : FieldKind::uint16;
        if constexpr (sizeof(T) == 4) return is_signed ? FieldKind::int32 : FieldKind::uint32;
        if constexpr (sizeof(T) == 8) return is_signed ? FieldKind::int64 : FieldKind::uint64;
    } else if constexpr (std::is_same_v<T, float>) {
        return FieldKind::float32;
    } else if constexpr (std::is_same_v<T, double>) {
        return FieldKind::float64;
    } else {
        static_assert(Reflected<T>, "a field's type needs a reflection<> of its own");
        return FieldKind::structure;
    }
}

template <class Element>
FieldDescription described_field(std::string_view name, std::uint32_t offset, std::uint32_t count,
                                 const FieldOptions& options) {
    FieldDescription field{.name = name,
                           .kind = kind_of<Element>(),
                           .offset = offset,
                           .stride = static_cast<std::uint32_t>(sizeof(Element)),
                           .count = count,
                           .options = options,
                           .values = {},
                           .structure = nullptr};
    if constexpr (std::is_enum_v<Element>) {
        static_assert(Reflected<Element>, "an enum needs a reflection<> that names its values");
        field.values = reflection<Element>::value;
    } else if constexpr (kind_of<Element>() == FieldKind::structure) {
        field.structure = &description_of<Element>();
    }
    return field;
}

template <class Struct, class Member>
FieldDescription described(const Struct& prototype, const MemberField<Struct, Member>& field) {
    const auto* member = reinterpret_cast<const std::byte*>(&(prototype.*field.member));
    const auto offset = member - reinterpret_cast<const std::byte*>(&prototype);
    return described_field<typename ArrayOf<Member>::Element>(field.name, static_cast<std::uint32_t>(offset),
                                                              ArrayOf<Member>::count, field.options);
}

template <class Struct, class Element>
FieldDescription described(const Struct&, const ElementsField<Element>& field) {
    return described_field<Element>(field.name, 0, sizeof(Struct) / sizeof(Element), field.options);
}

template <class Struct, class... Fields>
StructDescription described(const StructReflection<Struct, Fields...>& reflected) {
    static_assert(std::is_default_constructible_v<Struct>,
                  "fields that a snapshot lacks take their values from a default-constructed object");
    StructDescription description{
        .name = reflected.name,
        .version = reflected.version,
        .size = std::is_empty_v<Struct> ? 0u : static_cast<std::uint32_t>(sizeof(Struct)),
        .trivially_copyable = std::is_trivially_copyable_v<Struct>,
        .fields = {}};
    const Struct prototype{};
    std::apply(
        [&](const auto&... fields) { (description.fields.push_back(described(prototype, fields)), ...); },
        reflected.fields);
    return description;
}

}  // namespace detail

template <Reflected T>
const StructDescription& description_of() {
    static const StructDescription description = detail::described(reflection<T>::value);
    return description;
}

}  // namespace rambla::ecs
