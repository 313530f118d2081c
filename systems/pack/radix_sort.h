#pragma once

#include <cstdint>
#include <vector>

namespace rambla::systems {

/// Sorts (64-bit key, 32-bit value) pairs by key: stable, and the same result for any number of threads. Owns
/// the second buffer and the histograms, so that sorting again needs no memory unless there are more pairs
/// than before.
class RadixSort {
public:
    /// @param keys, values  of equal length, < 2³²; both are permuted alike
    void operator()(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values);

private:
    std::vector<std::uint64_t> keys_;
    std::vector<std::uint32_t> values_;
    std::vector<std::uint32_t> counts_;
};

}  // namespace rambla::systems
