#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rambla::assets {

/// Puts values behind each other as they lie in memory; Cache keeps machines of another byte order apart.
class PayloadWriter {
public:
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { append(&value, sizeof value); }
    void add(bool value) { add(static_cast<std::uint8_t>(value ? 1 : 0)); }
    /// How many there are, then all of them. Without padding, so that equal content is equal bytes.
    template <class T>
    requires(std::is_trivially_copyable_v<T>) void add(const std::vector<T>& column) {
        add_count(column.size());
        append(column.data(), column.size() * sizeof(T));
    }
    void add(const std::string& text) {
        add_count(text.size());
        append(text.data(), text.size());
    }
    void add_count(std::size_t count) { add(std::uint64_t{count}); }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void append(const void* values, std::size_t size) {
        const auto* const first = static_cast<const std::byte*>(values);
        bytes_.insert(bytes_.end(), first, first + size);
    }

    std::vector<std::byte> bytes_;
};

/// Reads what a PayloadWriter wrote out of bytes that may be anything. Once something is wrong everything
/// reads as zero or empty, so that one question at the end suffices: good(). Nothing is allocated for a count
/// that the bytes left cannot bear out.
class PayloadReader {
public:
    explicit PayloadReader(std::span<const std::byte> bytes) : left_{bytes} {}

    template <class T>
    requires(std::is_arithmetic_v<T>) [[nodiscard]] T value() {
        T value{};
        if (!expect(left_.size() >= sizeof value)) return T{};
        std::memcpy(&value, left_.data(), sizeof value);
        left_ = left_.subspan(sizeof value);
        return value;
    }
    [[nodiscard]] bool flag() {
        const auto value = this->value<std::uint8_t>();
        expect(value <= 1);
        return value == 1;
    }
    /// @param last  the greatest value of an enum that counts up from 0
    template <class Enum>
    [[nodiscard]] Enum one_of(Enum last) {
        using Number = std::underlying_type_t<Enum>;
        const auto number = value<Number>();
        return expect(number <= static_cast<Number>(last)) ? static_cast<Enum>(number) : Enum{};
    }
    /// A number of things that each take at least so many bytes.
    [[nodiscard]] std::size_t count(std::size_t least_bytes_each) {
        const auto count = value<std::uint64_t>();
        return expect(count <= left_.size() / least_bytes_each) ? static_cast<std::size_t>(count) : 0;
    }
    template <class T>
    requires(std::is_trivially_copyable_v<T>) [[nodiscard]] std::vector<T> column() {
        std::vector<T> values(count(sizeof(T)));
        if (values.empty()) return values;
        std::memcpy(static_cast<void*>(values.data()), left_.data(), values.size() * sizeof(T));
        left_ = left_.subspan(values.size() * sizeof(T));
        return values;
    }
    [[nodiscard]] std::string text() {
        const std::size_t size = count(1);
        std::string text(reinterpret_cast<const char*>(left_.data()), size);
        left_ = left_.subspan(size);
        return text;
    }

    /// Notes whether what was read makes sense; returns whether everything has so far.
    bool expect(bool condition) {
        if (!condition) {
            good_ = false;
            left_ = {};
        }
        return good_;
    }
    /// Everything was as it must be, and nothing is left.
    [[nodiscard]] bool good() const { return good_ && left_.empty(); }

private:
    std::span<const std::byte> left_;
    bool good_ = true;
};

}  // namespace rambla::assets
