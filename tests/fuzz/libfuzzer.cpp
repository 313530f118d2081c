#include <spdlog/spdlog.h>

#include "fuzz/target.h"

/// What libFuzzer calls; the program holds one target.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    spdlog::set_level(spdlog::level::off);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const rambla::fuzz::Target k_target = rambla::fuzz::targets().at(0);
    k_target.run(std::as_bytes(std::span{data, size}));
    return 0;
}
