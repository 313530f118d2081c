#include "assets/import/png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "assets/error.h"

namespace rambla::assets {

namespace {

constexpr std::size_t k_signature_bytes = 8;
constexpr std::size_t k_chunk_overhead = 12;  ///< length, type, sum

constexpr std::array<std::string_view, 5> k_essential{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};

std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word = word << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return word;
}

/// Table of ISO 3309's check sum, as in the PNG specification, annex D.
constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int bit = 0; bit < 8; ++bit)
            c = (c >> 1) ^ ((c & 1) != 0 ? 0xedb88320u : 0u);
        table[n] = c;
    }
    return table;
}

std::uint32_t crc(std::span<const std::byte> bytes) {
    static constexpr std::array<std::uint32_t, 256> k_table = crc_table();
    std::uint32_t c = 0xffffffffu;
    for (const std::byte byte : bytes)
        c = k_table[(c ^ std::to_integer<std::uint32_t>(byte)) & 0xff] ^ (c >> 8);
    return ~c;
}

}  // namespace

std::vector<std::byte> essential_png(std::span<const std::byte> bytes, const std::string& name) {
    std::vector<std::byte> out(bytes.size());
    std::size_t kept = 0;
    const auto keep = [&](std::span<const std::byte> part) {
        std::copy(part.begin(), part.end(), out.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += part.size();
    };
    keep(bytes.first(k_signature_bytes));
    for (std::size_t at = k_signature_bytes; at < bytes.size();) {
        const std::size_t rest = bytes.size() - at;
        const std::uint64_t length = rest >= k_chunk_overhead ? big_endian(bytes, at) : 0;
        if (rest < k_chunk_overhead || length > rest - k_chunk_overhead)
            throw Error{name, "", "a PNG that ends inside a chunk", "a whole file"};
        const auto chunk = bytes.subspan(at, static_cast<std::size_t>(length) + k_chunk_overhead);
        const std::string_view type{reinterpret_cast<const char*>(chunk.data()) + 4, 4};
        if (std::find(k_essential.begin(), k_essential.end(), type) != k_essential.end()) {
            if (crc(chunk.subspan(4, chunk.size() - 8)) != big_endian(chunk, chunk.size() - 4))
                throw Error{name, "", "a PNG chunk with a wrong check sum", "an undamaged file"};
            keep(chunk);
        }
        if (type == "IEND") {
            out.resize(kept);
            return out;
        }
        at += chunk.size();
    }
    throw Error{name, "", "a PNG without an end", "a whole file"};
}

}  // namespace rambla::assets
