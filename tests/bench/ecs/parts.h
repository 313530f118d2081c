#pragma once

#include <benchmark/benchmark.h>

namespace rambla::ecs::bench {

/// 24 bytes of payload in two components.
struct Place {
    float x = 1.0f, y = 2.0f, z = 3.0f;
};
struct Speed {
    float x = 4.0f, y = 5.0f, z = 6.0f;
};

/// The numbers of entities that every operation is measured with.
inline void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond);
}

}  // namespace rambla::ecs::bench
