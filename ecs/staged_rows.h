#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include "ecs/component.h"
#include "ecs/relocate.h"
#include "ecs/type_registry.h"

namespace rambla::ecs::detail {

/// Objects of one component that are ready to become rows.
class StagedRows {
public:
    /// Default values.
    StagedRows(const ComponentType& type, std::uint32_t rows)
        : info_{type.info}, rows_{rows}, bytes_{allocate(std::size_t{rows} * type.info->size)} {
        type.construct(bytes_.get(), rows);
        left_ = rows;
    }
    /// Values that the stream holds as memory would.
    StagedRows(const ComponentInfo& info, std::uint32_t rows, const std::byte* raw)
        : info_{&info}, rows_{rows}, raw_{raw} {}
    StagedRows(StagedRows&& other) noexcept
        : info_{other.info_},
          rows_{other.rows_},
          left_{std::exchange(other.left_, 0)},
          raw_{other.raw_},
          bytes_{std::move(other.bytes_)} {}
    ~StagedRows() {
        if (left_ != 0 && info_->destroy != nullptr) info_->destroy(first_left(), left_);
    }
    StagedRows& operator=(StagedRows&&) = delete;

    [[nodiscard]] const ComponentInfo& info() const { return *info_; }
    /// Not of raw values.
    [[nodiscard]] std::byte* objects() const { return bytes_.get(); }

    /// Makes the objects rows at raw memory. Once.
    void move_to(std::byte* to) noexcept {
        if (raw_ != nullptr) {
            std::memcpy(to, raw_, std::size_t{rows_} * info_->size);
        } else {
            move_next(to, left_);
        }
    }
    /// Makes the next object a row at raw memory; not of raw values.
    void move_one(std::byte* to) noexcept { move_next(to, 1); }

private:
    struct Delete {
        void operator()(std::byte* bytes) const noexcept { ::operator delete(bytes, k_alignment); }
    };
    using Bytes = std::unique_ptr<std::byte, Delete>;
    static constexpr std::align_val_t k_alignment{k_column_alignment};

    static Bytes allocate(std::size_t bytes) {
        return Bytes{static_cast<std::byte*>(::operator new(bytes, k_alignment))};
    }
    [[nodiscard]] std::byte* first_left() const {
        return bytes_.get() + std::size_t{rows_ - left_} * info_->size;
    }
    void move_next(std::byte* to, std::uint32_t rows) noexcept {
        relocate_rows(*info_, to, first_left(), rows);
        left_ -= rows;
    }

    const ComponentInfo* info_;
    std::uint32_t rows_;
    std::uint32_t left_ = 0;  ///< objects not moved yet, the last ones
    const std::byte* raw_ = nullptr;
    Bytes bytes_;
};

}  // namespace rambla::ecs::detail
