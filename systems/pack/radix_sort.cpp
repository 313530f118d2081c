#include "systems/pack/radix_sort.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "assets/assert.h"

namespace rambla::systems {
namespace {

/// Least significant digit first: six digits of 11 bits cover 64, and 2048 counters stay in the first-level
/// cache.
constexpr std::size_t k_digit_bits = 11;
constexpr std::size_t k_buckets = std::size_t{1} << k_digit_bits;
constexpr std::size_t k_digits = 6;

/// Pairs that one job counts and scatters. The split follows from the number of pairs alone; below two blocks
/// the work (about 0.2 ms) is not worth a second thread.
constexpr std::size_t k_block = std::size_t{1} << 15u;

constexpr std::size_t digit_of(std::uint64_t key, std::size_t digit) {
    return (key >> (digit * k_digit_bits)) & (k_buckets - 1);
}

template <class Job>
void for_blocks(std::size_t blocks, const Job& job) {
    if (blocks == 1) return job(std::size_t{0});
    tbb::parallel_for(std::size_t{0}, blocks, job);
}

/// Turns counts per (block, bucket) into the place where each block's first pair of that bucket goes.
void exclusive_sums(std::span<std::uint32_t> counts, std::size_t blocks) {
    std::uint32_t sum = 0;
    for (std::size_t bucket = 0; bucket < k_buckets; ++bucket) {
        for (std::size_t block = 0; block < blocks; ++block) {
            std::uint32_t& count = counts[block * k_buckets + bucket];
            const std::uint32_t place = sum;
            sum += count;
            count = place;
        }
    }
}

}  // namespace

void RadixSort::operator()(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values) {
    RAMBLA_ASSERT(keys.size() == values.size(), "a key belongs to each value");
    const std::size_t size = keys.size();
    if (size < 2) return;

    // A bit that no key sets or that all keys set cannot order anything; a digit of such bits is skipped.
    std::uint64_t any = 0;
    std::uint64_t all = ~std::uint64_t{0};
    for (const std::uint64_t key : keys) {
        any |= key;
        all &= key;
    }
    const std::uint64_t varying = any & ~all;

    const std::size_t blocks = (size + k_block - 1) / k_block;
    keys_.resize(size);
    values_.resize(size);
    counts_.resize(blocks * k_buckets);
    for (std::size_t digit = 0; digit < k_digits; ++digit) {
        if (digit_of(varying, digit) == 0) continue;
        for_blocks(blocks, [&](std::size_t block) {
            const std::span<std::uint32_t> counts{&counts_[block * k_buckets], k_buckets};
            std::fill(counts.begin(), counts.end(), 0u);
            const std::size_t end = std::min(size, (block + 1) * k_block);
            for (std::size_t i = block * k_block; i < end; ++i)
                ++counts[digit_of(keys[i], digit)];
        });
        exclusive_sums(counts_, blocks);
        for_blocks(blocks, [&](std::size_t block) {
            const std::span<std::uint32_t> places{&counts_[block * k_buckets], k_buckets};
            const std::size_t end = std::min(size, (block + 1) * k_block);
            for (std::size_t i = block * k_block; i < end; ++i) {
                const std::uint32_t place = places[digit_of(keys[i], digit)]++;
                keys_[place] = keys[i];
                values_[place] = values[i];
            }
        });
        keys.swap(keys_);
        values.swap(values_);
    }
}

}  // namespace rambla::systems
