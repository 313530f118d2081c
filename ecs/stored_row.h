#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ecs/description.h"
#include "ecs/entity.h"

namespace rambla::ecs {

/// A field as a snapshot knows it. Nested structs are stored flat: "place.local_m.x"; elements of arrays of
/// structs have their index: "legs[1].link".
struct StoredField {
    std::string path;
    FieldKind kind = FieldKind::float32;
    std::uint32_t count = 1;  ///< elements of an array, else 1

    bool operator==(const StoredField&) const = default;
};

/// A type as a snapshot knows it.
struct StoredSchema {
    std::string name;
    std::uint32_t version = 1;
    std::vector<StoredField> fields;

    bool operator==(const StoredSchema&) const = default;
};

/// Bytes that an element of a kind takes in a stream, before the characters for texts.
[[nodiscard]] std::uint32_t stored_bytes(FieldKind kind);

/// The stored value of an integer, enum or bool; 0 for other kinds.
[[nodiscard]] std::int64_t stored_integer(FieldKind kind, const std::byte* bytes);

/// One stored object, for migrations. Asking for a field that is not there, or as another sort of value,
/// throws Misuse.
class StoredRow {
public:
    /// @param row  validated bytes
    StoredRow(const StoredSchema& schema, const std::byte* row) : schema_{&schema}, row_{row} {}

    /// Of the type, when the object was stored.
    [[nodiscard]] std::uint32_t version() const { return schema_->version; }
    /// Whether there is a field with this path: "place.local_m.x".
    [[nodiscard]] bool has(std::string_view path) const;
    /// Any number, enum or bool.
    [[nodiscard]] double number(std::string_view path, std::uint32_t element = 0) const;
    /// Any integer, enum or bool, exactly; above 2⁶³ it wraps around.
    [[nodiscard]] std::int64_t integer(std::string_view path, std::uint32_t element = 0) const;
    /// A handle, as it was in the world that was saved.
    [[nodiscard]] Entity entity(std::string_view path, std::uint32_t element = 0) const;
    /// A text. Valid as long as the stream.
    [[nodiscard]] std::string_view text(std::string_view path, std::uint32_t element = 0) const;

private:
    struct Element {
        FieldKind kind;
        const std::byte* bytes;
    };
    [[nodiscard]] Element find(std::string_view path, std::uint32_t element) const;
    [[noreturn]] void refuse(std::string_view path, std::string_view why) const;

    const StoredSchema* schema_;
    const std::byte* row_;
};

}  // namespace rambla::ecs
