#pragma once

#include <cstddef>

#include "assets/clip.h"

namespace rambla::assets::gltf {

/// How many keys of a channel were not as they should be.
struct KeyFindings {
    std::size_t unusable = 0;  ///< times before 0 or not finite, values not finite, rotations without length
    std::size_t unsorted = 0;  ///< earlier than the key before them
    std::size_t repeated = 0;  ///< at the time of the key before them
    std::size_t not_unit = 0;  ///< rotations of another length than 1, beyond what storage rounds

    KeyFindings& operator+=(const KeyFindings& other);
    [[nodiscard]] bool any() const { return unusable + unsorted + repeated + not_unit > 0; }
};

/// Makes the times of a channel strictly increasing, its numbers finite and its rotations unit length:
/// - unusable keys are left out,
/// - keys are sorted by time; those of one time stay in the order of the file,
/// - of keys at one time the first and the last stay, the last one a microsecond later, so that a jump stays
///   a jump; only the last one where the next key follows at once, only one where both are equal.
/// A channel may have no keys afterwards.
KeyFindings mend_keys(Channel& channel);

}  // namespace rambla::assets::gltf
