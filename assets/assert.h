#pragma once

#include <cstdio>
#include <cstdlib>

namespace rambla {

/// Prints what failed and where, then aborts: for what cannot be, never for input.
[[noreturn]] inline void assertion_failed(const char* condition, const char* file, int line,
                                          const char* reason) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s (%s)\n", file, line, condition, reason);
    std::abort();
}

}  // namespace rambla

/// Checks an invariant in Debug and test builds (RAMBLA_ASSERTS) and states the reason why it must hold.
#if defined(RAMBLA_ASSERTS)
#define RAMBLA_ASSERT(condition, reason) \
    ((condition) ? static_cast<void>(0) : ::rambla::assertion_failed(#condition, __FILE__, __LINE__, reason))
#else
#define RAMBLA_ASSERT(condition, reason) static_cast<void>(sizeof(!(condition)))
#endif
