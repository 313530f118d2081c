#include "ecs/misuse.h"

#include <string>

namespace rambla::ecs {
namespace {

std::string call(std::string_view operation, std::string_view component) {
    std::string text{"ecs: "};
    text.append(operation);
    if (!component.empty()) text.append("<").append(component).append(">");
    return text;
}

}  // namespace

namespace detail {

void throw_not_alive(std::string_view operation, std::string_view component, Entity entity) {
    throw Misuse{call(operation, component) + ": entity " + to_string(entity) + " is not alive"};
}

void throw_missing(std::string_view operation, std::string_view component, Entity entity) {
    throw Misuse{call(operation, component) + ": entity " + to_string(entity) + " has no such component"};
}

void throw_no_shared_value(std::string_view component) {
    throw Misuse{call("archetype", component) + ": a shared component needs a value"};
}

void throw_no_resource(std::string_view resource) {
    throw Misuse{call("resource", resource) + ": never set in this world"};
}

void throw_iterating(std::string_view operation) {
    throw Misuse{call(operation, {}) +
                 ": while this thread walks over chunks, observes a change, or works for a system that "
                 "shares the world; structural changes belong into Commands"};
}

void throw_undeclared(std::string_view system, std::string_view thing) {
    throw Misuse{"ecs: system \"" + std::string{system} + "\" " + std::string{thing} +
                 ", which it does not declare"};
}

void throw_full(std::string_view what, std::uint64_t maximum) {
    throw CapacityExceeded{"ecs: more than " + std::to_string(maximum) + " " + std::string{what}};
}

void throw_no_memory(std::string_view what, std::uint64_t bytes) {
    throw CapacityExceeded{"ecs: the system refuses " + std::to_string(bytes) + " bytes of " +
                           std::string{what}};
}

}  // namespace detail
}  // namespace rambla::ecs
