#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rambla::fuzz {

using Bytes = std::span<const std::byte>;

/// Takes one seed by name.
using SeedTaker = std::function<void(const std::string& name, Bytes bytes)>;

/// A door through which untrusted bytes come in. Whatever the bytes, `run` returns; what breaks a promise of
/// the code behind the door ends the process.
struct Target {
    std::string name;
    void (*run)(Bytes) = nullptr;
    void (*seeds)(const SeedTaker&) = nullptr;  ///< well-formed inputs to start from
};

/// Makes a target known: one in each file of targets/, which bears its name.
struct Registration {
    explicit Registration(Target target);
};

/// In the order of their names.
[[nodiscard]] std::vector<Target> targets();

/// Ends the process: a promise was broken.
[[noreturn]] void broken(std::string_view promise);

}  // namespace rambla::fuzz
