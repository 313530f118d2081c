#pragma once

#include <string_view>
#include <utility>

#include "ecs/access.h"

/// Debug and test builds check that systems touch only what they declare; others do not look.
#if defined(RAMBLA_ASSERTS)
#define RAMBLA_ECS_CHECKS_ACCESS 1
#else
#define RAMBLA_ECS_CHECKS_ACCESS 0
#endif

namespace rambla::ecs {

class World;

/// Whether this build checks.
inline constexpr bool k_checks_access = RAMBLA_ECS_CHECKS_ACCESS != 0;

namespace detail {

/// While it lives, this thread works for a system of a schedule and may touch in `world` only what the system
/// declares. Scopes nest: a thread that waits for one system's jobs may help another.
class AccessScope {
public:
    AccessScope(const World& world, std::string_view system, const AccessSet& access) noexcept
        : world_{&world}, system_{system}, access_{&access}, outer_{std::exchange(innermost_, this)} {}
    ~AccessScope() { innermost_ = outer_; }
    AccessScope(const AccessScope&) = delete;
    AccessScope& operator=(const AccessScope&) = delete;

    /// Throws Misuse, naming the system and the thing, when this thread's system may not touch it.
    static void check(const World& world, const AccessPart& part) {
        if (innermost_ != nullptr && innermost_->world_ == &world) innermost_->require(part);
    }
    /// The same for T; nothing in builds that do not check.
    template <class T>
    static void check([[maybe_unused]] const World& world, [[maybe_unused]] AccessKind kind,
                      [[maybe_unused]] bool writing) {
        if constexpr (k_checks_access) check(world, access_part<T>(kind, writing));
    }
    /// Throws Misuse, in all builds, when this thread's system shares the world with others.
    static void require_alone(const World& world, std::string_view operation) {
        if (innermost_ == nullptr || innermost_->world_ != &world) return;
        innermost_->require_everything(operation);
    }

    /// Whether this thread works for a system that shares the world with others.
    [[nodiscard]] static bool shares(const World& world) {
        return innermost_ != nullptr && innermost_->world_ == &world && !innermost_->access_->everything();
    }

private:
    void require(const AccessPart& part) const;
    void require_everything(std::string_view operation) const;

    inline static constinit thread_local const AccessScope* innermost_ = nullptr;

    const World* world_;
    std::string_view system_;
    const AccessSet* access_;
    const AccessScope* outer_;
};

}  // namespace detail
}  // namespace rambla::ecs
