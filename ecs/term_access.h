#pragma once

#include <type_traits>

#include "ecs/access_scope.h"
#include "ecs/entity.h"
#include "ecs/filters.h"
#include "ecs/terms.h"

namespace rambla::ecs::detail {

/// What a term makes a query touch: visit(f) calls f(AccessPart). Most filters look at the structure only,
/// which stays as it is while systems run side by side.
template <class T>
struct TermAccess {
    template <class F>
    static void visit([[maybe_unused]] const F& f) {
        using Part = typename Term<T>::Part;
        if constexpr (Term<T>::handed_out && !std::is_same_v<Part, Entity>)
            f(access_part<Part>(AccessKind::component, Term<T>::writes));
    }
};

template <class... Cs>
struct TermAccess<Changed<Cs...>> {
    template <class F>
    static void visit(const F& f) {
        (f(access_part<Cs>(AccessKind::component, false)), ...);
    }
};

template <class C>
struct TermAccess<Enabled<C>> {
    template <class F>
    static void visit(const F& f) {
        f(access_part<EnableState<C>>(AccessKind::component, false));
    }
};

template <class C>
struct TermAccess<Disabled<C>> : TermAccess<Enabled<C>> {};

/// Throws Misuse when this thread's system does not declare what a query with this term touches.
template <class T>
void check_term([[maybe_unused]] const World& world) {
    if constexpr (k_checks_access)
        TermAccess<T>::visit([&](const AccessPart& part) { AccessScope::check(world, part); });
}

}  // namespace rambla::ecs::detail
