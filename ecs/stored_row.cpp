#include "ecs/stored_row.h"

#include "ecs/byte_stream.h"
#include "ecs/misuse.h"

namespace rambla::ecs {
namespace {

template <class T>
T read(const std::byte* bytes) {
    T value{};
    detail::copy_little_endian(reinterpret_cast<std::byte*>(&value), bytes, sizeof(T), sizeof(T));
    return value;
}

std::size_t element_bytes(FieldKind kind, const std::byte* bytes) {
    return stored_bytes(kind) + (kind == FieldKind::text ? read<std::uint32_t>(bytes) : 0u);
}

}  // namespace

std::uint32_t stored_bytes(FieldKind kind) {
    switch (kind) {
        case FieldKind::boolean:
        case FieldKind::int8:
        case FieldKind::uint8:
            return 1;
        case FieldKind::int16:
        case FieldKind::uint16:
            return 2;
        case FieldKind::int32:
        case FieldKind::uint32:
        case FieldKind::float32:
        case FieldKind::text:  // its length
            return 4;
        case FieldKind::int64:
        case FieldKind::uint64:
        case FieldKind::float64:
        case FieldKind::entity:
            return 8;
        case FieldKind::structure:
            break;
    }
    return 0;
}

std::int64_t stored_integer(FieldKind kind, const std::byte* bytes) {
    switch (kind) {
        case FieldKind::int8:
            return read<std::int8_t>(bytes);
        case FieldKind::boolean:
        case FieldKind::uint8:
            return read<std::uint8_t>(bytes);
        case FieldKind::int16:
            return read<std::int16_t>(bytes);
        case FieldKind::uint16:
            return read<std::uint16_t>(bytes);
        case FieldKind::int32:
            return read<std::int32_t>(bytes);
        case FieldKind::uint32:
            return read<std::uint32_t>(bytes);
        case FieldKind::int64:
        case FieldKind::uint64:
            return read<std::int64_t>(bytes);
        default:
            return 0;
    }
}

bool StoredRow::has(std::string_view path) const {
    for (const StoredField& field : schema_->fields) {
        if (field.path == path) return true;
    }
    return false;
}

double StoredRow::number(std::string_view path, std::uint32_t element) const {
    const Element found = find(path, element);
    if (found.kind == FieldKind::float32) return static_cast<double>(read<float>(found.bytes));
    if (found.kind == FieldKind::float64) return read<double>(found.bytes);
    if (found.kind == FieldKind::uint64) return static_cast<double>(read<std::uint64_t>(found.bytes));
    return static_cast<double>(integer(path, element));
}

std::int64_t StoredRow::integer(std::string_view path, std::uint32_t element) const {
    const auto [kind, bytes] = find(path, element);
    const bool other = kind == FieldKind::float32 || kind == FieldKind::float64 ||
                       kind == FieldKind::entity || kind == FieldKind::text;
    if (other) refuse(path, "is no integer");
    return stored_integer(kind, bytes);
}

Entity StoredRow::entity(std::string_view path, std::uint32_t element) const {
    const auto [kind, bytes] = find(path, element);
    if (kind != FieldKind::entity) refuse(path, "is no entity");
    return {read<std::uint32_t>(bytes), read<std::uint32_t>(bytes + 4)};
}

std::string_view StoredRow::text(std::string_view path, std::uint32_t element) const {
    const auto [kind, bytes] = find(path, element);
    if (kind != FieldKind::text) refuse(path, "is no text");
    return {reinterpret_cast<const char*>(bytes) + 4, read<std::uint32_t>(bytes)};
}

StoredRow::Element StoredRow::find(std::string_view path, std::uint32_t element) const {
    const std::byte* at = row_;
    for (const StoredField& field : schema_->fields) {
        const bool wanted = field.path == path;
        if (wanted && element >= field.count) refuse(path, "has fewer elements");
        for (std::uint32_t i = 0; i < field.count; ++i) {
            if (wanted && i == element) return {field.kind, at};
            at += element_bytes(field.kind, at);
        }
    }
    refuse(path, "is not there");
}

void StoredRow::refuse(std::string_view path, std::string_view why) const {
    throw Misuse{"ecs: migration of " + schema_->name + " version " + std::to_string(schema_->version) +
                 ": field " + std::string{path} + " " + std::string{why}};
}

}  // namespace rambla::ecs
