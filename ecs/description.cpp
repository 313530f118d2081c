#include "ecs/description.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

/// Calls f with a value of the C++ type that a kind of number stands for.
template <class F>
auto with_number_type(FieldKind kind, F&& f) {
    switch (kind) {
        case FieldKind::int8:
            return f(std::int8_t{});
        case FieldKind::int16:
            return f(std::int16_t{});
        case FieldKind::int32:
            return f(std::int32_t{});
        case FieldKind::int64:
            return f(std::int64_t{});
        case FieldKind::uint8:
            return f(std::uint8_t{});
        case FieldKind::uint16:
            return f(std::uint16_t{});
        case FieldKind::uint32:
            return f(std::uint32_t{});
        case FieldKind::uint64:
            return f(std::uint64_t{});
        case FieldKind::float32:
            return f(float{});
        default:
            return f(double{});
    }
}

/// What FieldValue holds for a C++ number.
template <class T>
using Held = std::conditional_t<std::is_floating_point_v<T>, double,
                                std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>;

[[noreturn]] void refuse(const FieldDescription& field, std::string_view why) {
    throw Misuse{"ecs: set_field " + std::string{field.name} + ": " + std::string{why}};
}

template <class T>
const T& held(const FieldDescription& field, const FieldValue& value) {
    if (const T* found = std::get_if<T>(&value)) return *found;
    refuse(field, "the value is no " + std::string{to_string(field.kind)});
}

const std::byte* at(const FieldDescription& field, const void* object, std::uint32_t element) {
    if (element >= field.count) refuse(field, "element out of range");
    return static_cast<const std::byte*>(object) + field.offset + std::size_t{element} * field.stride;
}

std::byte* at(const FieldDescription& field, void* object, std::uint32_t element) {
    return const_cast<std::byte*>(at(field, static_cast<const void*>(object), element));
}

template <class T>
T checked_number(const FieldDescription& field, const FieldValue& value) {
    const Held<T> number = held<Held<T>>(field, value);
    const T narrow = static_cast<T>(number);
    if constexpr (std::is_integral_v<T>) {
        if (static_cast<Held<T>>(narrow) != number) refuse(field, "the number does not fit its type");
        if (!field.values.empty() && name_of(field, static_cast<std::int64_t>(number)).empty())
            refuse(field, "none of the enum's values");
    }
    const double real = static_cast<double>(number);
    if (!(real >= field.options.min && real <= field.options.max)) refuse(field, "out of its range");
    return narrow;
}

}  // namespace

std::string_view to_string(FieldKind kind) {
    switch (kind) {
        case FieldKind::boolean:
            return "boolean";
        case FieldKind::int8:
            return "int8";
        case FieldKind::int16:
            return "int16";
        case FieldKind::int32:
            return "int32";
        case FieldKind::int64:
            return "int64";
        case FieldKind::uint8:
            return "uint8";
        case FieldKind::uint16:
            return "uint16";
        case FieldKind::uint32:
            return "uint32";
        case FieldKind::uint64:
            return "uint64";
        case FieldKind::float32:
            return "float32";
        case FieldKind::float64:
            return "float64";
        case FieldKind::entity:
            return "entity";
        case FieldKind::text:
            return "text";
        case FieldKind::structure:
            return "structure";
    }
    return "unknown";
}

const FieldDescription* StructDescription::find(std::string_view field) const {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const FieldDescription& known) { return known.name == field; });
    return found == fields.end() ? nullptr : &*found;
}

FieldValue get_field(const FieldDescription& field, const void* object, std::uint32_t element) {
    const std::byte* from = at(field, object, element);
    switch (field.kind) {
        case FieldKind::structure:
            refuse(field, "a struct has no value of its own");
        case FieldKind::boolean:
            return *reinterpret_cast<const bool*>(from);
        case FieldKind::entity:
            return *reinterpret_cast<const Entity*>(from);
        case FieldKind::text:
            return *reinterpret_cast<const std::string*>(from);
        default:
            return with_number_type(field.kind, [&](auto number) -> FieldValue {
                std::memcpy(&number, from, sizeof(number));
                return static_cast<Held<decltype(number)>>(number);
            });
    }
}

void set_field(const FieldDescription& field, void* object, const FieldValue& value, std::uint32_t element) {
    std::byte* to = at(field, object, element);
    switch (field.kind) {
        case FieldKind::structure:
            refuse(field, "a struct has no value of its own");
        case FieldKind::boolean:
            *reinterpret_cast<bool*>(to) = held<bool>(field, value);
            break;
        case FieldKind::entity:
            *reinterpret_cast<Entity*>(to) = held<Entity>(field, value);
            break;
        case FieldKind::text:
            *reinterpret_cast<std::string*>(to) = held<std::string>(field, value);
            break;
        default:
            with_number_type(field.kind, [&](auto type) {
                const auto number = checked_number<decltype(type)>(field, value);
                std::memcpy(to, &number, sizeof(number));
            });
    }
}

std::string_view name_of(const FieldDescription& field, std::int64_t value) {
    for (const EnumValue& known : field.values) {
        if (known.value == value) return known.name;
    }
    return {};
}

const void* nested(const FieldDescription& field, const void* object, std::uint32_t element) {
    return at(field, object, element);
}

void* nested(const FieldDescription& field, void* object, std::uint32_t element) {
    return at(field, object, element);
}

}  // namespace rambla::ecs
