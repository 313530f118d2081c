#include "ecs/archetype.h"

#include <algorithm>
#include <utility>

#include "ecs/misuse.h"
#include "ecs/relocate.h"

namespace rambla::ecs {

using detail::destroy_rows;
using detail::relocate_rows;

namespace {

/// Columns that begin at the same place of their pages would fight for the same sets of a cache and make
/// loads wait for unrelated stores that agree in the lower 12 bits: each begins this much later than the one
/// before.
constexpr std::size_t k_stagger_bytes = 320;
constexpr std::size_t k_staggered_columns = 12;
static_assert(k_stagger_bytes % k_column_alignment == 0 && k_stagger_bytes * k_staggered_columns < 4096);

/// Reservations are as wide as the most rows of an archetype, so they would begin at nearly the same place of
/// their tables of pages, and the translations of all columns' addresses would compete for the same sets of
/// the caches that keep those: docs/benchmarks.md says what that costs. Each begins this many pages behind
/// the place of the one before, so that they are spread over all of a table.
constexpr std::size_t k_stagger_pages = 37;

constexpr std::size_t round_up(std::size_t value, std::size_t multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

constexpr std::size_t stagger(std::size_t column) {
    return column % k_staggered_columns * k_stagger_bytes;
}

}  // namespace

Archetype::Archetype(ArchetypeStorage& storage, std::uint32_t index, std::vector<ComponentId> signature,
                     std::span<const ComponentInfo* const> infos, std::vector<const SharedValue*> shared)
    : storage_{storage},
      index_{index},
      signature_{std::move(signature)},
      shared_{std::move(shared)},
      rows_version_{storage.oldest_version} {
    if (signature_.empty()) return;
    column_of_.assign(signature_.back() + std::size_t{1}, k_no_column);
    for (std::size_t i = 0; i < signature_.size(); ++i) {
        const bool tag = infos[i]->size == 0 || infos[i]->storage == Storage::shared;
        column_of_[signature_[i]] = tag ? k_tag_column : static_cast<ColumnIndex>(columns_.size());
        if (tag) continue;
        columns_.push_back({nullptr, infos[i], infos[i]->size, signature_[i], infos[i]->relocate == nullptr});
        if (infos[i]->row_mask && row_changes_.size() < k_no_row_changes) {
            columns_.back().row_changes = static_cast<std::uint8_t>(row_changes_.size());
            row_changes_.emplace_back();
        }
        ends_quietly_ = ends_quietly_ && infos[i]->destroy == nullptr;
        is_plain_ = is_plain_ && ends_quietly_ && columns_.back().moves_by_bytes &&
                    infos[i]->size <= detail::k_few_bytes;
        has_companions_ = has_companions_ || infos[i]->is_companion;
    }
    columns_.shrink_to_fit();
    version_stride_ = static_cast<std::uint32_t>(columns_.size()) + 1;
    latest_.assign(columns_.size(), storage.oldest_version);
}

Archetype::~Archetype() {
    for (const Column& column : columns_) {
        if (rows_ != 0) destroy_rows(*column.info, column.base, rows_);
    }
    release_block();
}

void Archetype::clear_companions(std::uint32_t row) noexcept {
    for (const Column& column : columns_) {
        if (column.info->is_companion) *column.at(row) = std::byte{0};
    }
}

void Archetype::end_row(std::uint32_t row) noexcept {
    for (const Column& column : columns_)
        destroy_rows(*column.info, column.at(row), 1);
}

std::uint32_t Archetype::move_to(Archetype& to, std::uint32_t row, std::uint32_t version) noexcept {
    const std::uint32_t target_row = to.push(entities_[row], version);
    auto target = to.columns_.begin();
    for (const Column& source : columns_) {
        while (target != to.columns_.end() && target->component < source.component)
            ++target;
        if (target != to.columns_.end() && target->component == source.component) {
            source.relocate_row(target->at(target_row), row);
        } else {
            destroy_rows(*source.info, source.at(row), 1);
        }
    }
    return target_row;
}

void Archetype::age_versions(std::uint32_t oldest) noexcept {
    for (std::uint32_t& version : versions_)
        version = later(version, oldest);
    for (std::uint32_t& version : latest_)
        version = later(version, oldest);
    rows_version_ = later(rows_version_, oldest);
    for (RowChanges& changes : row_changes_) {
        for (ChunkChanges& chunk : changes)
            chunk.age(oldest);
    }
}

std::size_t Archetype::memory_bytes() const {
    std::size_t bytes =
        sizeof(Archetype) + columns_.capacity() * sizeof(Column) +
        column_of_.capacity() * sizeof(ColumnIndex) + signature_.capacity() * sizeof(ComponentId) +
        shared_.capacity() * sizeof(const SharedValue*) + reserved_.capacity() * sizeof(ReservedMemory) +
        (versions_.capacity() + latest_.capacity()) * sizeof(std::uint32_t);
    for (const ReservedMemory& memory : reserved_)
        bytes += memory.committed_bytes();
    for (const RowChanges& changes : row_changes_)
        bytes += sizeof(RowChanges) + changes.capacity() * sizeof(ChunkChanges);
    return bytes;
}

std::size_t Archetype::row_memory_bytes() const {
    if (block_ != nullptr) return block_bytes(capacity_);
    std::size_t bytes = 0;
    for (const ReservedMemory& memory : reserved_)
        bytes += memory.committed_bytes();
    return bytes;
}

std::uint64_t Archetype::changed_rows(ColumnIndex column, std::uint32_t chunk, std::uint32_t since) const {
    const std::uint8_t place = columns_[column].row_changes;
    const bool rows_changed = is_after(versions_[chunk * version_stride()], since);
    if (rows_changed || place == k_no_row_changes)
        return is_after(version(column, chunk), since) ? ChunkChanges::k_all : 0;
    return row_changes_[place][chunk].after(since);
}

void Archetype::compact() {
    const auto fitting = static_cast<std::uint32_t>(round_up(rows_, k_row_padding));
    if (rows_ == 0) {
        release_block();
        std::vector<ReservedMemory>{}.swap(reserved_);
        entities_ = nullptr;
        for (Column& column : columns_)
            column.base = nullptr;
    } else if (!reserved_.empty() && fitting > k_pooled_rows) {
        for (std::size_t i = 0; i < reserved_.size(); ++i)
            reserved_[i].decommit(begin_in_reserved(i) + std::size_t{fitting} * row_bytes(i));
    } else if (!reserved_.empty() || fitting < capacity_) {
        grow_block(fitting);
        std::vector<ReservedMemory>{}.swap(reserved_);
    }
    capacity_ = fitting;
    shrink_versions();
}

void Archetype::shrink_versions() {
    const std::size_t chunks = (std::size_t{capacity_} + k_chunk_rows - 1) / k_chunk_rows;
    versions_.resize(chunks * version_stride());
    versions_.shrink_to_fit();
    for (RowChanges& changes : row_changes_) {
        changes.resize(chunks, ChunkChanges{storage_.oldest_version});
        changes.shrink_to_fit();
    }
}

void Archetype::grow() {
    grow_to(std::uint64_t{rows_} + 1);
}

void Archetype::grow_to(std::uint64_t rows) {
    if (rows > storage_.max_rows) detail::throw_full("rows in one archetype", storage_.max_rows);
    const std::uint64_t doubled = std::max(capacity_ * std::uint64_t{2}, std::uint64_t{k_row_padding});
    if (std::max(rows, doubled) <= k_pooled_rows || !storage_.reserves) {
        const std::uint64_t wanted = std::max<std::uint64_t>(round_up(rows, k_row_padding), doubled);
        grow_block(static_cast<std::uint32_t>(std::min<std::uint64_t>(wanted, storage_.max_rows)));
    } else {  // by 1/32: growth in place is cheap, and the unused part stays small
        const std::uint64_t step = std::uint64_t{capacity_} + capacity_ / 32 + 1;
        const std::uint64_t wanted = round_up(std::max(rows, step), k_chunk_rows);
        grow_reserved(static_cast<std::uint32_t>(std::min<std::uint64_t>(wanted, storage_.max_rows)));
    }
}

void Archetype::grow_block(std::uint32_t capacity) {
    reserve_versions(capacity);
    std::byte* block = storage_.pool.take(block_bytes(capacity));
    std::byte* next = block;
    move_columns([&](std::size_t row_bytes) {
        return std::exchange(next, next + round_up(capacity * row_bytes, k_column_alignment));
    });
    release_block();
    block_ = block;
    capacity_ = capacity;
}

void Archetype::grow_reserved(std::uint32_t capacity) {
    reserve_versions(capacity);
    if (!reserved_.empty()) {
        commit(capacity);
        capacity_ = capacity;
        return;
    }
    std::vector<ReservedMemory> fresh;
    fresh.reserve(columns_.size() + 1);
    for (std::size_t i = 0; i <= columns_.size(); ++i) {
        const std::size_t reservation = index_ * (columns_.size() + 1) + i;
        fresh.emplace_back(stagger(i) + std::size_t{storage_.max_rows} * row_bytes(i),
                           reservation * k_stagger_pages % ReservedMemory::k_pages_per_table);
    }
    for (std::size_t i = 0; i < fresh.size(); ++i)
        fresh[i].commit(stagger(i) + std::size_t{capacity} * row_bytes(i));
    std::size_t next = 0;
    move_columns([&](std::size_t) {
        std::byte* base = fresh[next].data() + stagger(next);
        ++next;
        return base;
    });
    release_block();
    reserved_ = std::move(fresh);
    capacity_ = capacity;
}

void Archetype::commit(std::uint32_t capacity) {
    for (std::size_t i = 0; i < reserved_.size(); ++i)
        reserved_[i].commit(begin_in_reserved(i) + std::size_t{capacity} * row_bytes(i));
}

std::size_t Archetype::begin_in_reserved(std::size_t column) const {
    const std::byte* begin =
        column == 0 ? reinterpret_cast<const std::byte*>(entities_) : columns_[column - 1].base;
    return static_cast<std::size_t>(begin - reserved_[column].data());
}

void Archetype::release_block() noexcept {
    if (block_ != nullptr) storage_.pool.give_back(std::exchange(block_, nullptr), block_bytes(capacity_));
}

void Archetype::reserve_versions(std::uint32_t capacity) {
    const std::size_t chunks = (std::size_t{capacity} + k_chunk_rows - 1) / k_chunk_rows;
    if (versions_.size() < chunks * version_stride())
        versions_.resize(chunks * version_stride(), storage_.oldest_version);
    for (RowChanges& changes : row_changes_) {
        if (changes.size() < chunks) changes.resize(chunks, ChunkChanges{storage_.oldest_version});
    }
}

template <class NextBase>
void Archetype::move_columns(NextBase next_base) noexcept {
    Entity* entities = reinterpret_cast<Entity*>(next_base(sizeof(Entity)));
    std::copy_n(entities_, rows_, entities);
    entities_ = entities;
    for (Column& column : columns_) {
        std::byte* base = next_base(column.info->size);
        if (rows_ != 0) relocate_rows(*column.info, base, column.base, rows_);
        column.base = base;
    }
}

std::size_t Archetype::row_bytes(std::size_t column) const {
    return column == 0 ? sizeof(Entity) : columns_[column - 1].info->size;
}

std::size_t Archetype::block_bytes(std::uint32_t capacity) const {
    std::size_t bytes = 0;
    for (std::size_t i = 0; i <= columns_.size(); ++i)
        bytes += round_up(capacity * row_bytes(i), k_column_alignment);
    return bytes;
}

}  // namespace rambla::ecs
