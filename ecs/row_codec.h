#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/byte_stream.h"
#include "ecs/description.h"
#include "ecs/stored_row.h"
#include "ecs/type_registry.h"

namespace rambla::ecs::detail {

/// The schema that objects of a described type are stored under: nested structs flat, in declaration order.
[[nodiscard]] StoredSchema schema_of(const StructDescription& description);

/// Everything but the name.
void write_schema(const StoredSchema& schema, ByteWriter& out);
/// What write_schema() wrote. Throws SnapshotError.
[[nodiscard]] StoredSchema read_schema(std::string_view name, ByteReader& in);

/// A piece of a row: bytes that lie next to each other in the stream, and in memory too if they go there.
struct RowStep {
    enum class Action : std::uint8_t { copy, skip, text, skip_text };

    /// What must hold for stored bytes before they may become C++ objects.
    struct Check {
        std::uint32_t offset;  ///< from the piece's beginning
        std::uint32_t count;
        FieldKind kind;
        std::span<const EnumValue> values;
    };

    Action action = Action::copy;
    std::uint32_t bytes = 0;   ///< copy and skip
    std::uint32_t offset = 0;  ///< in memory; copy and text
    std::uint32_t scalar = 1;  ///< bytes of the numbers inside
    std::vector<Check> checks{};
};

/// Writes objects of one type: their fields one after the other, little-endian, without gaps. Where memory
/// looks the same, whole columns are copied at once.
class RowEncoder {
public:
    explicit RowEncoder(const StructDescription& description);

    void encode(const std::byte* first, std::size_t rows, ByteWriter& out) const;

private:
    std::vector<RowStep> steps_;
    std::uint32_t size_;       ///< in memory
    std::uint32_t row_bytes_;  ///< in the stream, without texts
    bool fixed_;               ///< no texts
    bool raw_;                 ///< memory looks like the stream
};

/// Reads what RowEncoder wrote, perhaps of an older version of the type, perhaps of a type not known here.
class RowDecoder {
public:
    /// @param target     null: rows are only skipped
    /// @param migration  for the stored version; may be null
    /// Throws SnapshotError, which names `offset`, when the stored fields cannot become the target's.
    RowDecoder(StoredSchema schema, const StructDescription* target, const TypeRegistry::Migration* migration,
               std::size_t offset);

    /// Checks `rows` rows and returns their bytes; throws SnapshotError.
    [[nodiscard]] std::span<const std::byte> take_valid(ByteReader& in, std::uint32_t rows) const;
    /// Whether the bytes may be copied to raw memory as they are.
    [[nodiscard]] bool raw() const { return raw_; }
    /// Fills objects that hold their default values.
    /// @param bytes  what take_valid() returned
    void decode(std::span<const std::byte> bytes, std::uint32_t rows, std::byte* objects) const;

private:
    void validate_row(ByteReader& in) const;
    const std::byte* decode_row(const std::byte* from, std::byte* object) const;

    StoredSchema schema_;
    const TypeRegistry::Migration* migration_;
    std::vector<RowStep> steps_;
    std::uint32_t size_ = 0;
    std::uint32_t row_bytes_ = 0;
    bool fixed_ = true;
    bool checked_ = false;  ///< some bytes have rules
    bool raw_ = false;
};

}  // namespace rambla::ecs::detail
