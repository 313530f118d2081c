#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "ecs/snapshot_error.h"

namespace rambla::ecs::detail {

/// Copies numbers of `scalar` bytes each between memory and a stream, which is little-endian.
inline void copy_little_endian(std::byte* to, const std::byte* from, std::size_t bytes,
                               [[maybe_unused]] std::size_t scalar) {
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(to, from, bytes);
    } else {
        for (std::size_t first = 0; first < bytes; first += scalar) {
            for (std::size_t i = 0; i < scalar; ++i)
                to[first + i] = from[first + scalar - 1 - i];
        }
    }
}

/// Bytes that grow at their end, without being cleared first; keeps its memory when it begins anew.
class ByteWriter {
public:
    void clear() { size_ = 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<const std::byte> bytes() const { return {data_.get(), size_}; }

    /// Makes room; the reference to it holds until the next call.
    std::byte* extend(std::size_t bytes) {
        if (bytes > capacity_ - size_) grow(bytes);
        size_ += bytes;
        return data_.get() + size_ - bytes;
    }
    template <class T>
    void number(T value) {
        static_assert(std::is_integral_v<T>);
        copy_little_endian(extend(sizeof(T)), reinterpret_cast<const std::byte*>(&value), sizeof(T),
                           sizeof(T));
    }
    /// Overwrites a number written before.
    template <class T>
    void patch(std::size_t offset, T value) {
        copy_little_endian(data_.get() + offset, reinterpret_cast<const std::byte*>(&value), sizeof(T),
                           sizeof(T));
    }
    void text(std::string_view text) {
        number(static_cast<std::uint32_t>(text.size()));
        if (!text.empty()) std::memcpy(extend(text.size()), text.data(), text.size());
    }

private:
    void grow(std::size_t bytes) {
        const std::size_t wanted = std::max(size_ + bytes, capacity_ + capacity_ / 2);
        auto fresh = std::make_unique_for_overwrite<std::byte[]>(wanted);
        if (size_ != 0) std::memcpy(fresh.get(), data_.get(), size_);
        data_ = std::move(fresh);
        capacity_ = wanted;
    }

    std::unique_ptr<std::byte[]> data_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

/// Reads a stream from front to back and never beyond its end. Throws SnapshotError.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes, std::size_t offset = 0)
        : bytes_{bytes}, offset_{offset} {}

    [[nodiscard]] std::size_t offset() const { return offset_; }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - offset_; }

    std::span<const std::byte> take(std::uint64_t bytes) {
        if (bytes > left()) {
            throw SnapshotError{offset_, std::to_string(left()) + " bytes to the end",
                                "at least " + std::to_string(bytes)};
        }
        offset_ += bytes;
        return bytes_.subspan(offset_ - bytes, bytes);
    }
    template <class T>
    T number() {
        static_assert(std::is_integral_v<T>);
        T value{};
        copy_little_endian(reinterpret_cast<std::byte*>(&value), take(sizeof(T)).data(), sizeof(T),
                           sizeof(T));
        return value;
    }
    std::string_view text() {
        const std::span<const std::byte> characters = take(number<std::uint32_t>());
        return {reinterpret_cast<const char*>(characters.data()), characters.size()};
    }
    /// A count of things that take at least `least_bytes` each, so that a wrong one cannot ask for more
    /// memory than the stream justifies.
    std::uint32_t count(std::size_t least_bytes) {
        const std::size_t at = offset_;
        const auto count = number<std::uint32_t>();
        if (count > left() / least_bytes) {
            throw SnapshotError{at, "a count of " + std::to_string(count),
                                "at most " + std::to_string(left() / least_bytes)};
        }
        return count;
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t offset_;
};

}  // namespace rambla::ecs::detail
