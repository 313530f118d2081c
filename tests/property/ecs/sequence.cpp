#include "property/ecs/sequence.h"

#include <algorithm>
#include <numeric>

namespace rambla::ecs::property {
namespace {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers from every standard library.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_{seed} {}
    std::uint32_t operator()() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
        return static_cast<std::uint32_t>((z ^ (z >> 31u)) >> 32u);
    }

private:
    std::uint64_t state_;
};

Sequence without(const Sequence& sequence, std::size_t first, std::size_t count) {
    Sequence shorter{sequence.begin(), sequence.begin() + static_cast<std::ptrdiff_t>(first)};
    const std::size_t rest = std::min(sequence.size(), first + count);
    shorter.insert(shorter.end(), sequence.begin() + static_cast<std::ptrdiff_t>(rest), sequence.end());
    return shorter;
}

}  // namespace

Sequence random_sequence(std::uint64_t seed, std::size_t length, std::span<const std::uint32_t> weights) {
    Random random{seed};
    const std::uint32_t total = std::accumulate(weights.begin(), weights.end(), 0u);
    Sequence sequence(length);
    for (Operation& operation : sequence) {
        std::uint32_t point = random() % total;
        while (point >= weights[operation.kind])
            point -= weights[operation.kind++];
        operation.a = random();
        operation.b = random();
        operation.c = random();
    }
    return sequence;
}

Sequence shrink(Sequence failing, const std::function<bool(const Sequence&)>& fails, std::size_t tries) {
    for (std::size_t part = std::max<std::size_t>(failing.size() / 2, 1);;
         part = std::max<std::size_t>(part / 2, 1)) {
        bool shorter = false;
        // From the end: later steps need earlier ones, seldom the other way round.
        for (std::size_t end = failing.size(); end > 0; end -= std::min(end, part)) {
            if (tries-- == 0) return failing;
            const std::size_t first = end - std::min(end, part);
            Sequence candidate = without(failing, first, end - first);
            if (!fails(candidate)) continue;
            failing = std::move(candidate);
            shorter = true;
        }
        if (part == 1 && !shorter) return failing;
    }
}

}  // namespace rambla::ecs::property
