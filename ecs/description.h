#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ecs/entity.h"

namespace rambla::ecs {

/// What one element of a field is. The numbers are written into snapshots: never give one another meaning.
/// Enums are integers of their underlying type with names for their values.
enum class FieldKind : std::uint8_t {
    boolean = 1,
    int8 = 2,
    int16 = 3,
    int32 = 4,
    int64 = 5,
    uint8 = 6,
    uint16 = 7,
    uint32 = 8,
    uint64 = 9,
    float32 = 10,
    float64 = 11,
    entity = 12,
    text = 13,
    structure = 14,
};

/// "float32"; "unknown" for a number that is none of the kinds.
[[nodiscard]] std::string_view to_string(FieldKind kind);

/// One value of an enum.
struct EnumValue {
    std::string_view name;   ///< as it is shown and read
    std::int64_t value = 0;  ///< as it is stored
};

/// What is said of a field beside its name. A unit and a range given for a struct or an array hold for every
/// number inside.
struct FieldOptions {
    std::string_view unit{};                                ///< "m", "rad", or empty
    double min = -std::numeric_limits<double>::infinity();  ///< in that unit, itself allowed
    double max = std::numeric_limits<double>::infinity();   ///< in that unit, itself allowed
};

struct StructDescription;

/// A field of a struct at run time. All text has static storage.
struct FieldDescription {
    std::string_view name;
    FieldKind kind = FieldKind::float32;
    std::uint32_t offset = 0;  ///< from the beginning of the struct
    std::uint32_t stride = 0;  ///< bytes of one element
    std::uint32_t count = 1;   ///< elements of a std::array, else 1
    FieldOptions options;
    std::span<const EnumValue> values;             ///< of an enum, else empty
    const StructDescription* structure = nullptr;  ///< of a nested struct, else null
};

/// A component, resource or nested struct at run time: all that snapshots, inspectors and JSON need to read
/// and write its fields without knowing its type.
struct StructDescription {
    std::string_view name;
    std::uint32_t version = 1;  ///< counts up when fields change; see TypeRegistry::migrate
    std::uint32_t size = 0;     ///< bytes in memory; 0 for tags
    bool trivially_copyable = true;
    std::vector<FieldDescription> fields;  ///< in the order of their description

    /// Null if there is no such field.
    [[nodiscard]] const FieldDescription* find(std::string_view field) const;
};

/// A value of a field: bool, every signed or unsigned integer (enums too), float and double, entity, text.
using FieldValue = std::variant<bool, std::int64_t, std::uint64_t, double, Entity, std::string>;

/// Reads one element of a field that is no struct.
/// @param object   the struct that has the field
/// @param element  < field.count
[[nodiscard]] FieldValue get_field(const FieldDescription& field, const void* object,
                                   std::uint32_t element = 0);

/// Writes one element of a field that is no struct. Throws Misuse if the value is of another sort than
/// get_field() returns, lies outside the field's range or type, or is none of an enum's values; the object is
/// then unchanged.
void set_field(const FieldDescription& field, void* object, const FieldValue& value,
               std::uint32_t element = 0);

/// The name of an enum's value; empty if it has none.
[[nodiscard]] std::string_view name_of(const FieldDescription& field, std::int64_t value);

/// The nested struct that is one element of a field of kind structure.
[[nodiscard]] const void* nested(const FieldDescription& field, const void* object,
                                 std::uint32_t element = 0);
/// The same for writing.
[[nodiscard]] void* nested(const FieldDescription& field, void* object, std::uint32_t element = 0);

}  // namespace rambla::ecs
