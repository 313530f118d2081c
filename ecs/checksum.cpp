#include "ecs/checksum.h"

#include <array>
#include <bit>
#include <cstring>

namespace rambla::ecs {
namespace {

constexpr std::size_t k_lanes = 4;
constexpr std::size_t k_word = sizeof(std::uint64_t);
constexpr std::size_t k_block = k_lanes * k_word;

// Odd, with about as many ones as zeros: the golden ratio, and one step of splitmix64.
constexpr std::uint64_t k_spread = 0x9e3779b97f4a7c15u;
constexpr std::uint64_t k_fold = 0xbf58476d1ce4e5b9u;

std::uint64_t word_at(const std::byte* bytes) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, k_word);
    if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
    return word;
}

/// The product carries bits upwards, the shift carries the upper half downwards: without it a change of the
/// highest bits would still be few bits when the next word comes, and that word could undo it.
std::uint64_t stirred(std::uint64_t lane, std::uint64_t word) {
    lane = (lane ^ word) * k_spread;
    return lane ^ (lane >> 32u);
}

std::uint64_t folded(std::uint64_t hash, std::uint64_t lane) {
    hash = (hash ^ lane) * k_fold;
    return hash ^ (hash >> 31u);
}

}  // namespace

std::uint64_t checksum(std::span<const std::byte> bytes) {
    std::array<std::uint64_t, k_lanes> lanes{k_spread, 2 * k_spread, 3 * k_spread, 4 * k_spread};
    const std::byte* at = bytes.data();
    const std::byte* const end = at + bytes.size();
    for (; static_cast<std::size_t>(end - at) >= k_block; at += k_block) {
        for (std::size_t lane = 0; lane < k_lanes; ++lane)
            lanes[lane] = stirred(lanes[lane], word_at(at + lane * k_word));
    }
    std::array<std::byte, k_block> rest{};  // zeros behind the end: the length tells them from data
    if (at != end) std::memcpy(rest.data(), at, static_cast<std::size_t>(end - at));
    std::uint64_t hash = bytes.size();
    for (std::size_t lane = 0; lane < k_lanes; ++lane)
        hash = folded(hash, stirred(lanes[lane], word_at(rest.data() + lane * k_word)));
    return folded(hash, k_spread);
}

}  // namespace rambla::ecs
