#include "ecs/row_codec.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "ecs/misuse.h"

namespace rambla::ecs::detail {
namespace {

using Action = RowStep::Action;

/// Far above any sane component, far below what could overflow a product with a number of rows.
constexpr std::uint64_t k_max_row_bytes = 1u << 24u;

/// A field that holds no others, with its place in memory.
struct Leaf {
    StoredField stored;
    std::uint32_t offset;
    std::span<const EnumValue> values;
};

void add_leaves(const StructDescription& description, const std::string& prefix, std::uint32_t offset,
                std::vector<Leaf>& leaves) {
    for (const FieldDescription& field : description.fields) {
        const std::string path = prefix + std::string{field.name};
        if (field.kind != FieldKind::structure) {
            leaves.push_back({{path, field.kind, field.count}, offset + field.offset, field.values});
            continue;
        }
        for (std::uint32_t i = 0; i < field.count; ++i) {
            const std::string element = field.count == 1 ? path : path + '[' + std::to_string(i) + ']';
            add_leaves(*field.structure, element + '.', offset + field.offset + i * field.stride, leaves);
        }
    }
}

std::vector<Leaf> leaves_of(const StructDescription& description) {
    std::vector<Leaf> leaves;
    add_leaves(description, {}, 0, leaves);
    return leaves;
}

std::uint64_t row_bytes_of(const StoredSchema& schema) {
    std::uint64_t bytes = 0;
    for (const StoredField& field : schema.fields)
        bytes += std::uint64_t{field.count} * stored_bytes(field.kind);
    return bytes;
}

/// Appends a piece, or lengthens the last one if the new one follows it on both sides.
void append(std::vector<RowStep>& steps, RowStep step) {
    if (!steps.empty()) {
        RowStep& last = steps.back();
        const bool follows = step.action == last.action &&
                             (step.action == Action::skip ||
                              (step.action == Action::copy && step.offset == last.offset + last.bytes &&
                               (std::endian::native == std::endian::little || step.scalar == last.scalar)));
        if (follows) {
            for (RowStep::Check& check : step.checks) {
                check.offset += last.bytes;
                last.checks.push_back(check);
            }
            last.bytes += step.bytes;
            return;
        }
    }
    steps.push_back(std::move(step));
}

/// @param leaf  null: the field goes nowhere
void append_field(std::vector<RowStep>& steps, const StoredField& field, const Leaf* leaf) {
    const std::uint32_t offset = leaf == nullptr ? 0 : leaf->offset;
    if (field.kind == FieldKind::text) {
        for (std::uint32_t i = 0; i < field.count; ++i) {
            append(steps, {.action = leaf == nullptr ? Action::skip_text : Action::text,
                           .offset = offset + i * static_cast<std::uint32_t>(sizeof(std::string))});
        }
        return;
    }
    RowStep step{.action = leaf == nullptr ? Action::skip : Action::copy,
                 .bytes = field.count * stored_bytes(field.kind),
                 .offset = offset,
                 .scalar = field.kind == FieldKind::entity ? 4 : stored_bytes(field.kind)};
    if (field.kind == FieldKind::boolean) {
        step.checks.push_back({0, field.count, field.kind, {}});
    } else if (leaf != nullptr && !leaf->values.empty()) {
        step.checks.push_back({0, field.count, field.kind, leaf->values});
    }
    append(steps, std::move(step));
}

bool is_fixed(const std::vector<RowStep>& steps) {
    return std::all_of(steps.begin(), steps.end(), [](const RowStep& step) {
        return step.action == Action::copy || step.action == Action::skip;
    });
}

/// Whether a row in the stream is the object's bytes.
bool is_raw(const std::vector<RowStep>& steps, const StructDescription& description) {
    return std::endian::native == std::endian::little && description.trivially_copyable &&
           steps.size() == 1 && steps[0].action == Action::copy && steps[0].offset == 0 &&
           steps[0].bytes == description.size;
}

void check(const RowStep::Check& rule, const std::byte* bytes, std::size_t offset) {
    const std::size_t element_bytes = stored_bytes(rule.kind);
    for (std::size_t i = 0; i < rule.count; ++i) {
        const std::size_t at = rule.offset + i * element_bytes;
        const std::int64_t value = stored_integer(rule.kind, bytes + at);
        if (rule.kind == FieldKind::boolean && value != 0 && value != 1) {
            throw SnapshotError{offset + at, std::to_string(value), "0 or 1 in a bool"};
        }
        if (rule.values.empty()) continue;
        const bool named = std::any_of(rule.values.begin(), rule.values.end(),
                                       [&](const EnumValue& known) { return known.value == value; });
        if (!named) throw SnapshotError{offset + at, std::to_string(value), "a value that the enum has"};
    }
}

/// "health version 1 (points int32)", for messages.
std::string to_text(const StoredSchema& schema) {
    std::string text = schema.name + " version " + std::to_string(schema.version) + " (";
    for (const StoredField& field : schema.fields) {
        if (text.back() != '(') text += ", ";
        text += field.path + ' ' + std::string{to_string(field.kind)};
        if (field.count != 1) text += '[' + std::to_string(field.count) + ']';
    }
    return text + ')';
}

}  // namespace

StoredSchema schema_of(const StructDescription& description) {
    StoredSchema schema{std::string{description.name}, description.version, {}};
    for (Leaf& leaf : leaves_of(description))
        schema.fields.push_back(std::move(leaf.stored));
    return schema;
}

void write_schema(const StoredSchema& schema, ByteWriter& out) {
    out.number(schema.version);
    out.number(static_cast<std::uint32_t>(schema.fields.size()));
    for (const StoredField& field : schema.fields) {
        out.text(field.path);
        out.number(static_cast<std::uint8_t>(field.kind));
        out.number(field.count);
    }
}

StoredSchema read_schema(std::string_view name, ByteReader& in) {
    StoredSchema schema{std::string{name}, in.number<std::uint32_t>(), {}};
    constexpr std::size_t k_least_field_bytes = 9;
    schema.fields.resize(in.count(k_least_field_bytes));
    std::uint64_t bytes = 0;
    for (StoredField& field : schema.fields) {
        field.path = in.text();
        const std::size_t at = in.offset();
        field.kind = static_cast<FieldKind>(in.number<std::uint8_t>());
        if (stored_bytes(field.kind) == 0) {
            throw SnapshotError{at, "field kind " + std::to_string(static_cast<int>(field.kind)),
                                "one of 1 to 13"};
        }
        field.count = in.number<std::uint32_t>();
        bytes += std::uint64_t{field.count} * stored_bytes(field.kind);
        if (bytes > k_max_row_bytes) {
            throw SnapshotError{at, std::to_string(bytes) + " bytes per row of " + schema.name,
                                "at most " + std::to_string(k_max_row_bytes)};
        }
    }
    return schema;
}

RowEncoder::RowEncoder(const StructDescription& description)
    : size_{description.size}, row_bytes_{static_cast<std::uint32_t>(row_bytes_of(schema_of(description)))} {
    if (row_bytes_of(schema_of(description)) > k_max_row_bytes) {
        throw Misuse{"ecs: " + std::string{description.name} + " is too large for a snapshot"};
    }
    for (const Leaf& leaf : leaves_of(description))
        append_field(steps_, leaf.stored, &leaf);
    fixed_ = is_fixed(steps_);
    raw_ = is_raw(steps_, description);
}

void RowEncoder::encode(const std::byte* first, std::size_t rows, ByteWriter& out) const {
    if (raw_) {
        if (rows != 0) std::memcpy(out.extend(rows * size_), first, rows * size_);
        return;
    }
    if (fixed_) {
        std::byte* to = out.extend(rows * row_bytes_);
        for (std::size_t row = 0; row < rows; ++row, first += size_) {
            for (const RowStep& step : steps_) {
                copy_little_endian(to, first + step.offset, step.bytes, step.scalar);
                to += step.bytes;
            }
        }
        return;
    }
    for (std::size_t row = 0; row < rows; ++row, first += size_) {
        for (const RowStep& step : steps_) {
            if (step.action == Action::text) {
                out.text(*reinterpret_cast<const std::string*>(first + step.offset));
            } else {
                copy_little_endian(out.extend(step.bytes), first + step.offset, step.bytes, step.scalar);
            }
        }
    }
}

RowDecoder::RowDecoder(StoredSchema schema, const StructDescription* target,
                       const TypeRegistry::Migration* migration, std::size_t offset)
    : schema_{std::move(schema)}, migration_{migration} {
    std::vector<Leaf> leaves;
    if (target != nullptr) {
        leaves = leaves_of(*target);
        size_ = target->size;
        const StoredSchema current = schema_of(*target);
        if (schema_.version > current.version) {
            throw SnapshotError{offset, to_text(schema_),
                                "version " + std::to_string(current.version) + " or older"};
        }
        if (schema_.version == current.version) {
            migration_ = nullptr;
            if (schema_ != current) throw SnapshotError{offset, to_text(schema_), to_text(current)};
        }
    }
    for (const StoredField& field : schema_.fields) {
        auto leaf = std::find_if(leaves.begin(), leaves.end(),
                                 [&](const Leaf& known) { return known.stored.path == field.path; });
        if (leaf != leaves.end() && leaf->stored != field) {
            if (migration_ == nullptr) {
                throw SnapshotError{offset, to_text(schema_),
                                    to_text(schema_of(*target)) + ", or a migration from version " +
                                        std::to_string(schema_.version)};
            }
            leaf = leaves.end();
        }
        append_field(steps_, field, leaf == leaves.end() ? nullptr : &*leaf);
    }
    row_bytes_ = static_cast<std::uint32_t>(row_bytes_of(schema_));
    fixed_ = is_fixed(steps_);
    checked_ =
        std::any_of(steps_.begin(), steps_.end(), [](const RowStep& step) { return !step.checks.empty(); });
    raw_ = target != nullptr && migration_ == nullptr && is_raw(steps_, *target);
}

std::span<const std::byte> RowDecoder::take_valid(ByteReader& in, std::uint32_t rows) const {
    ByteReader checked = in;
    std::uint64_t bytes = std::uint64_t{rows} * row_bytes_;
    if (!fixed_ || checked_) {
        if (fixed_) (void)ByteReader{in}.take(bytes);  // the size first: it may be all that is wrong
        for (std::uint32_t row = 0; row < rows; ++row)
            validate_row(checked);
        bytes = checked.offset() - in.offset();
    }
    return in.take(bytes);
}

void RowDecoder::validate_row(ByteReader& in) const {
    for (const RowStep& step : steps_) {
        if (step.action == Action::text || step.action == Action::skip_text) {
            (void)in.text();
            continue;
        }
        const std::size_t at = in.offset();
        const std::byte* bytes = in.take(step.bytes).data();
        for (const RowStep::Check& rule : step.checks)
            check(rule, bytes, at);
    }
}

void RowDecoder::decode(std::span<const std::byte> bytes, std::uint32_t rows, std::byte* objects) const {
    const std::byte* from = bytes.data();
    for (std::uint32_t row = 0; row < rows; ++row, objects += size_) {
        const std::byte* next = decode_row(from, objects);
        if (migration_ != nullptr) (*migration_)(StoredRow{schema_, from}, objects);
        from = next;
    }
}

const std::byte* RowDecoder::decode_row(const std::byte* from, std::byte* object) const {
    for (const RowStep& step : steps_) {
        if (step.action == Action::copy || step.action == Action::skip) {
            if (step.action == Action::copy)
                copy_little_endian(object + step.offset, from, step.bytes, step.scalar);
            from += step.bytes;
            continue;
        }
        std::uint32_t length = 0;
        copy_little_endian(reinterpret_cast<std::byte*>(&length), from, sizeof(length), sizeof(length));
        from += sizeof(length);
        if (step.action == Action::text) {
            reinterpret_cast<std::string*>(object + step.offset)
                ->assign(reinterpret_cast<const char*>(from), length);
        }
        from += length;
    }
    return from;
}

}  // namespace rambla::ecs::detail
