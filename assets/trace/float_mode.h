#pragma once

#include <xmmintrin.h>

namespace rambla::assets {

/// While it lives, this thread rounds to nearest and keeps denormal numbers, whatever the caller has set or
/// Embree would set (it builds with flush-to-zero); then everything is as it was, flags of exceptions
/// included.
class ScopedFloatMode {
public:
    ScopedFloatMode() : saved_{_mm_getcsr()} { _mm_setcsr(k_default); }
    ~ScopedFloatMode() { _mm_setcsr(saved_); }
    ScopedFloatMode(const ScopedFloatMode&) = delete;
    ScopedFloatMode& operator=(const ScopedFloatMode&) = delete;

private:
    static constexpr unsigned k_default = 0x1f80;  // what a process starts with: all exceptions masked

    unsigned saved_;
};

}  // namespace rambla::assets
