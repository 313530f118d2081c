#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecs/block_pool.h"
#include "ecs/component.h"
#include "ecs/memory.h"
#include "ecs/relocate.h"
#include "ecs/row_changes.h"
#include "ecs/shared_values.h"
#include "ecs/version.h"

namespace rambla::ecs {

namespace detail {
struct WorldAccess;
}

/// Rows of a logical chunk: the unit of iteration, of change versions and of jobs.
inline constexpr std::uint32_t k_chunk_rows = 1024;
/// Capacities are multiples of this, so that SIMD may read whole vectors at a column's end.
inline constexpr std::uint32_t k_row_padding = 16;
/// Up to here an archetype's columns share one block of the pool; above, each has an address range of its
/// own.
inline constexpr std::uint32_t k_pooled_rows = 256;

using ColumnIndex = std::uint16_t;
inline constexpr ColumnIndex k_no_column = 0xffff;  ///< the archetype lacks the component
/// It has it, but tags and shared values take no column.
inline constexpr ColumnIndex k_tag_column = 0xfffe;

namespace detail {
struct BulkRows;
}

/// What all archetypes of a world share.
struct ArchetypeStorage {
    explicit ArchetypeStorage(std::pmr::memory_resource* memory) : pool{memory} {}

    BlockPool pool;
    std::uint32_t max_rows = 0;
    /// No version is older; what was never written has it. Keeps distances below 2³¹.
    std::uint32_t oldest_version = 0;
    bool reserves = true;  ///< grow in place above k_pooled_rows; else in blocks, whose rows then move
};

/// Whether observers have to be told of an archetype's entities. They look when they are first asked.
struct Watched {
    bool known = false;
    bool begin = true;  ///< of those that begin here; until known, perhaps
    bool end = true;    ///< of those that end here
};

/// All entities with the same set of components and the same shared values: one column per component, one row
/// per entity, without gaps.
///
///     row        0        1        2      …  1023 │ 1024 …        a chunk is 1024 rows of all columns
///     Entity   [e][e][e][e][e][e][e][e][e] …      │ [e] …
///     Position [x y z][x y z][x y z][x y z] …     │ [x y z] …     columns begin at cache lines
///
/// Above k_pooled_rows growth never moves a row. Operations that may fail come first and change nothing when
/// they do; what follows cannot fail.
class Archetype {
public:
    static constexpr std::uint8_t k_no_row_changes = 0xff;

    struct Column {
        std::byte* base = nullptr;
        const ComponentInfo* info = nullptr;
        std::uint32_t size = 0;  ///< info->size, here because every move of a row needs it
        ComponentId component = k_no_component;
        bool moves_by_bytes = true;
        std::uint8_t row_changes = k_no_row_changes;  ///< place among the archetype's RowChanges

        [[nodiscard]] std::byte* at(std::uint32_t row) const {
            return base + static_cast<std::size_t>(row) * size;
        }
        /// Moves one row to raw memory and leaves raw memory behind.
        void relocate_row(std::byte* to, std::uint32_t row) const noexcept {
            if (moves_by_bytes) {
                detail::copy_row(to, at(row), size);
            } else {
                info->relocate(to, at(row), 1);
            }
        }
        /// Moves a value into a row that is raw memory.
        void take_row(std::uint32_t row, std::byte* value) const noexcept {
            if (moves_by_bytes) {
                detail::copy_row(at(row), value, size);
            } else {
                info->relocate(at(row), value, 1);
            }
        }
    };

    /// @param signature   component numbers, ascending, without doubles
    /// @param infos       what they are, in the same order
    /// @param shared      values of those that are shared, in the same order
    Archetype(ArchetypeStorage& storage, std::uint32_t index, std::vector<ComponentId> signature,
              std::span<const ComponentInfo* const> infos, std::vector<const SharedValue*> shared);
    ~Archetype();
    Archetype(const Archetype&) = delete;
    Archetype& operator=(const Archetype&) = delete;

    [[nodiscard]] std::uint32_t index() const { return index_; }
    [[nodiscard]] const Watched& watched() const { return watched_; }
    void set_watched(const Watched& watched) { watched_ = watched; }
    [[nodiscard]] std::uint32_t rows() const { return rows_; }
    [[nodiscard]] std::uint32_t capacity() const { return capacity_; }
    [[nodiscard]] std::span<const ComponentId> signature() const { return signature_; }
    [[nodiscard]] std::span<const Column> columns() const { return columns_; }
    [[nodiscard]] const Entity* entities() const { return entities_; }
    /// Values of the shared components, by ascending component numbers.
    [[nodiscard]] std::span<const SharedValue* const> shared() const { return shared_; }
    /// Null if the archetype lacks the shared component.
    [[nodiscard]] const SharedValue* shared(ComponentId component) const {
        for (const SharedValue* value : shared_) {
            if (value->component == component) return value;
        }
        return nullptr;
    }

    [[nodiscard]] ColumnIndex column_of(ComponentId component) const {
        return component < column_of_.size() ? column_of_[component] : k_no_column;
    }
    [[nodiscard]] bool has(ComponentId component) const { return column_of(component) != k_no_column; }

    /// Makes sure that push() has a row. Throws CapacityExceeded.
    void reserve_one() {
        if (rows_ == capacity_) grow();
    }
    /// Makes sure that there is room for `rows` rows in all. Throws CapacityExceeded.
    void reserve(std::uint64_t rows) {
        if (rows > capacity_) grow_to(rows);
    }
    /// Appends a row whose components are raw memory that the caller fills at once (but EnableStates, which
    /// are zero); reserve_one() came before.
    std::uint32_t push(Entity entity, std::uint32_t version) noexcept {
        const std::uint32_t row = rows_++;
        entities_[row] = entity;
        stamp_rows(row, version);
        if (has_companions_) clear_companions(row);
        return row;
    }
    /// Ends a row's components and closes the gap. Returns the entity that took over the row, null if it was
    /// last.
    Entity erase(std::uint32_t row, std::uint32_t version) noexcept {
        if (!ends_quietly_) end_row(row);
        return close_gap(row, version);
    }
    /// Moves a row's components to `to`, whose reserve_one() came before: shared ones are relocated, those
    /// that `to` lacks end, those that only `to` has stay raw. The caller then closes the gap.
    std::uint32_t move_to(Archetype& to, std::uint32_t row, std::uint32_t version) noexcept;
    /// Fills the gap that move_to() left. Returns the entity that took over the row, null if it was last.
    Entity close_gap(std::uint32_t row, std::uint32_t version) noexcept {
        return close_gap(row, version, [](const Column& column, std::uint32_t to, std::uint32_t from) {
            column.relocate_row(column.at(to), from);
        });
    }
    /// Whether erase_plain() will do: rows end quietly and are few bytes to move.
    [[nodiscard]] bool is_plain() const { return is_plain_; }
    /// The same as erase() without a call of anything but `place(moved, row)` for the entity that takes the
    /// row, before its values move: nothing but the row is then left to be remembered.
    template <class Place>
    void erase_plain(std::uint32_t row, std::uint32_t version, Place place) noexcept {
        const std::uint32_t last = --rows_;
        stamp_rows(last, version);
        if (row == last) return;
        stamp_rows(row, version);
        const Entity moved = entities_[row] = entities_[last];
        place(moved, row);
        // Who destroys many takes rows off the end backwards, which processors do not fetch ahead as well as
        // forwards.
        fetch_before(entities_ + last);
        for (const Column& column : columns_) {
            const std::byte* from = column.at(last);
            fetch_before(from);
            detail::copy_few(column.at(row), from, column.size);
        }
    }

    /// Version at which a chunk's column was last written, rows coming and going included.
    [[nodiscard]] std::uint32_t version(ColumnIndex column, std::uint32_t chunk) const {
        const std::uint32_t* versions = versions_.data() + chunk * version_stride();
        return later(versions[0], versions[1u + column]);
    }
    /// The latest of these over all chunks.
    [[nodiscard]] std::uint32_t version(ColumnIndex column) const {
        return later(rows_version_, latest_[column]);
    }
    /// Version at which rows of a chunk last came or went.
    [[nodiscard]] std::uint32_t rows_version(std::uint32_t chunk) const {
        return versions_[chunk * version_stride()];
    }
    /// The latest of these over all chunks.
    [[nodiscard]] std::uint32_t rows_version() const { return rows_version_; }
    /// Marks all rows of a chunk's column as written. Several threads may stamp different chunks of one
    /// column with the same version.
    void stamp(ColumnIndex column, std::uint32_t chunk, std::uint32_t version) noexcept {
        stamp_version(column, chunk, version);
        if (!row_changes_.empty()) mark_rows(column, chunk, ChunkChanges::k_all, version);
    }
    /// Marks one row of a column as written.
    void stamp_row(ColumnIndex column, std::uint32_t row, std::uint32_t version) noexcept {
        stamp_version(column, row / k_chunk_rows, version);
        if (row_changes_.empty()) return;
        const std::uint32_t bit = row % k_chunk_rows / ChunkChanges::k_rows_per_bit;
        mark_rows(column, row / k_chunk_rows, std::uint64_t{1} << bit, version);
    }
    /// The rows of a chunk that may have been written after `since`, as ChunkChanges tells them; all where
    /// rows came or went, or where the component has no row mask.
    [[nodiscard]] std::uint64_t changed_rows(ColumnIndex column, std::uint32_t chunk,
                                             std::uint32_t since) const;
    /// Raises all versions older than `oldest` to it.
    void age_versions(std::uint32_t oldest) noexcept;

    /// Gives back memory that holds no row; moves rows to a block of the pool if they fit into one.
    void compact();
    /// Columns, in an own address range or a block of the pool.
    [[nodiscard]] std::size_t row_memory_bytes() const;
    [[nodiscard]] bool has_reservation() const { return !reserved_.empty(); }
    /// Memory of its own: committed columns and tables; blocks of the pool are counted by the pool.
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    friend struct detail::WorldAccess;
    friend struct detail::BulkRows;

    void grow();
    void grow_to(std::uint64_t rows);
    void grow_block(std::uint32_t capacity);
    void grow_reserved(std::uint32_t capacity);
    void commit(std::uint32_t capacity);
    /// Where the entities (0) or a column (from 1) begin in the reservation that they have: columns that
    /// changed hands keep theirs.
    [[nodiscard]] std::size_t begin_in_reserved(std::size_t column) const;
    void release_block() noexcept;
    void end_row(std::uint32_t row) noexcept;
    void reserve_versions(std::uint32_t capacity);
    /// Relocates all rows to where next_base(bytes per row) says, for the entities first, then for each
    /// column.
    template <class NextBase>
    void move_columns(NextBase next_base) noexcept;
    /// Of the entities (0) or a column (from 1).
    [[nodiscard]] std::size_t row_bytes(std::size_t column) const;
    [[nodiscard]] std::size_t block_bytes(std::uint32_t capacity) const;
    [[nodiscard]] std::size_t version_stride() const { return version_stride_; }
    /// Fetches what a walk backwards over a column will need; where nothing is there, nothing happens.
    static void fetch_before(const void* at) noexcept {
        constexpr std::uintptr_t k_bytes_ahead = 512;
        __builtin_prefetch(
            reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(at) - k_bytes_ahead));
    }
    /// Closes a gap; `move(column, to, from)` moves a row within a column.
    template <class Move>
    Entity close_gap(std::uint32_t row, std::uint32_t version, Move move) noexcept {
        const std::uint32_t last = --rows_;
        stamp_rows(last, version);
        if (row == last) return {};
        stamp_rows(row, version);
        const Entity moved = entities_[row] = entities_[last];
        for (const Column& column : columns_)
            move(column, row, last);
        return moved;
    }
    /// Marks the row's chunk as one whose rows came or went.
    void stamp_rows(std::uint32_t row, std::uint32_t version) noexcept {
        std::uint32_t& of_chunk = versions_[row / k_chunk_rows * version_stride()];
        // Writing only what is new: what bounds many entities coming and going is the number of stores.
        if (of_chunk == version) return;
        of_chunk = version;
        rows_version_ = version;
    }
    void stamp_version(ColumnIndex column, std::uint32_t chunk, std::uint32_t version) noexcept {
        versions_[chunk * version_stride() + 1u + column] = version;
        std::atomic_ref<std::uint32_t> latest{latest_[column]};
        // Writing only what is new keeps the line shared among the threads of one system.
        if (latest.load(std::memory_order_relaxed) != version)
            latest.store(version, std::memory_order_relaxed);
    }
    void mark_rows(ColumnIndex column, std::uint32_t chunk, std::uint64_t bits,
                   std::uint32_t version) noexcept {
        const std::uint8_t place = columns_[column].row_changes;
        if (place != k_no_row_changes) row_changes_[place][chunk].mark(bits, version);
    }
    void shrink_versions();
    /// EnableStates are zero in a new row.
    void clear_companions(std::uint32_t row) noexcept;

    ArchetypeStorage& storage_;
    std::uint32_t index_;
    std::uint32_t rows_ = 0;
    std::uint32_t capacity_ = 0;
    Entity* entities_ = nullptr;
    std::vector<Column> columns_;
    std::vector<ColumnIndex> column_of_;  ///< by component number
    std::vector<ComponentId> signature_;
    std::vector<const SharedValue*> shared_;
    std::uint32_t version_stride_ = 1;  ///< columns and one
    std::uint32_t rows_version_;        ///< latest of rows coming and going
    bool ends_quietly_ = true;          ///< no component has a destructor to call
    bool is_plain_ = true;              ///< that, and all columns move by few bytes
    bool has_companions_ = false;       ///< some column holds EnableStates
    Watched watched_;
    std::byte* block_ = nullptr;            ///< all columns, while they share a block
    std::vector<ReservedMemory> reserved_;  ///< entities, then the columns, once each has its own
    std::vector<std::uint32_t> versions_;   ///< per chunk: rows coming and going, then one per column
    std::vector<RowChanges> row_changes_;   ///< of the columns that keep them
    std::vector<std::uint32_t> latest_;     ///< per column, of versions_ over all chunks
};

}  // namespace rambla::ecs
