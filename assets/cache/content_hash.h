#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace rambla::assets {

/// 128 bits that stand for a content: equal for equal content on every machine, different for different
/// content but by chance (2⁻¹²⁸ for each pair) or on purpose, as the hash is no cryptographic one (XXH3,
/// Collet 2019). So what is found under it must not be trusted more than a file.
struct ContentHash {
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    bool operator==(const ContentHash&) const = default;
};

/// 32 hexadecimal digits.
[[nodiscard]] std::string to_string(const ContentHash& hash);

/// Hashes a sequence of values. Each counts with its length, so that ("ab", "c") is not ("a", "bc").
class ContentHasher {
public:
    ContentHasher();
    ~ContentHasher();
    ContentHasher(const ContentHasher&) = delete;
    ContentHasher& operator=(const ContentHasher&) = delete;

    void add(std::span<const std::byte> bytes);
    void add(std::string_view text) { add(std::as_bytes(std::span{text})); }
    void add(const ContentHash& hash);
    /// Numbers and enums. Not floats by value: 0 and −0, and NaNs, count as the bits that they are.
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) {
        add(std::as_bytes(std::span{&value, 1}));
    }
    /// Plain values without padding, as one sequence.
    template <class T>
    requires(std::is_trivially_copyable_v<T>) void add(std::span<const T> values) {
        add(std::as_bytes(values));
    }

    [[nodiscard]] ContentHash hash() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

[[nodiscard]] ContentHash content_hash(std::span<const std::byte> bytes);

}  // namespace rambla::assets
