#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ecs/component.h"

namespace rambla::ecs {

/// What a system may touch.
enum class AccessKind : std::uint8_t { component, resource };

/// "component" or "resource".
[[nodiscard]] std::string_view to_string(AccessKind kind);

/// One thing that a system reads, or reads and writes.
struct AccessPart {
    AccessKind kind = AccessKind::component;
    std::uint32_t type_index = 0;
    std::string_view name;  ///< of the type
    bool writes = false;    ///< else it only reads

    /// Whether both are about one thing, however they touch it.
    [[nodiscard]] bool same_thing(const AccessPart& other) const {
        return kind == other.kind && type_index == other.type_index;
    }
};

/// Reading T, or reading and writing it.
template <class T>
[[nodiscard]] AccessPart access_part(AccessKind kind, bool writes) {
    return {kind, type_index<T>(), type_name<T>(), writes};
}

/// All that a system declares to touch, each thing once, in the order of declaration.
class AccessSet {
public:
    /// What is read and written counts as written.
    void add(const AccessPart& part);
    /// The whole world, its structure included.
    void add_everything() { everything_ = true; }
    /// Structural changes, recorded now and made at the end of the stage: they conflict with nothing.
    void add_commands() { commands_ = true; }

    /// In the order of declaration.
    [[nodiscard]] std::span<const AccessPart> parts() const { return parts_; }
    /// Whether add_everything() was called.
    [[nodiscard]] bool everything() const { return everything_; }
    /// Whether add_commands() was called.
    [[nodiscard]] bool commands() const { return commands_; }
    /// Whether something may be read, or written.
    [[nodiscard]] bool covers(AccessKind kind, std::uint32_t type_index, bool writing) const;

private:
    std::vector<AccessPart> parts_;
    bool everything_ = false;
    bool commands_ = false;
};

/// What keeps two systems from running at the same time: things that one writes and the other touches, in the
/// first one's order of declaration.
struct Conflict {
    bool exclusive = false;         ///< one of them has the world for itself
    std::vector<AccessPart> parts;  ///< `writes`: whether the first writes it

    /// Whether there is a conflict.
    [[nodiscard]] bool any() const { return exclusive || !parts.empty(); }
};

/// What keeps `first` and `second` apart; nothing if they may run at the same time.
[[nodiscard]] Conflict conflict_between(const AccessSet& first, const AccessSet& second);

}  // namespace rambla::ecs
