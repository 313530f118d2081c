#pragma once

#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "ecs/entity.h"

namespace rambla::ecs {

/// A caller's mistake: stale handle, component that is not there, structural change while iterating. The
/// world is as it was before the call. Checked in all builds.
class Misuse : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// A stated maximum (WorldOptions) or the system's memory is used up. The world is as it was before the call.
class CapacityExceeded : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a system of a schedule threw, nested (std::rethrow_if_nested) in an error that names the system.
class SystemFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

namespace detail {

/// `operation` is the call as written, without the component: "get"; `component` may be empty.
[[noreturn]] void throw_not_alive(std::string_view operation, std::string_view component, Entity entity);
[[noreturn]] void throw_missing(std::string_view operation, std::string_view component, Entity entity);
[[noreturn]] void throw_no_shared_value(std::string_view component);
[[noreturn]] void throw_no_resource(std::string_view resource);
[[noreturn]] void throw_iterating(std::string_view operation);
/// `thing` is what the system did without declaring it: "reads component Position".
[[noreturn]] void throw_undeclared(std::string_view system, std::string_view thing);
[[noreturn]] void throw_full(std::string_view what, std::uint64_t maximum);
[[noreturn]] void throw_no_memory(std::string_view what, std::uint64_t bytes);

}  // namespace detail
}  // namespace rambla::ecs
