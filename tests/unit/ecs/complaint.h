#pragma once

#include <exception>
#include <string>

namespace rambla::ecs::test {

/// What run() complains about; empty if it does not.
template <class Run>
std::string complaint(const Run& run) {
    try {
        run();
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

}  // namespace rambla::ecs::test
