#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>

#include "ecs/component.h"

namespace rambla::ecs {

/// Query term: the component's column where there is one, an empty span (each(): a null pointer) where not.
/// Optional<const C> only reads.
template <class C>
struct Optional {};

/// Query filter: only entities that have C; hands nothing out. Works for tags.
template <class C>
struct With {};

/// Query filter: only entities that lack C; hands nothing out.
template <class C>
struct Without {};

namespace detail {

enum class Need { always, required, optional, excluded };

/// A required component, const C or C.
template <class T>
struct Term {
    static_assert(Component<std::remove_const_t<T>>,
                  "a term is Entity, a component, Optional, With or Without");
    static_assert(!is_tag<std::remove_const_t<T>>, "a tag has no column: use With or Without");
    using Part = std::remove_const_t<T>;
    using Element = T;
    using Argument = T&;
    static constexpr Need need = Need::required;
    static constexpr bool handed_out = true;
    static constexpr bool writes = !std::is_const_v<T>;
    static Argument argument(T* column, std::size_t row) { return column[row]; }
};

template <>
struct Term<Entity> {
    using Part = Entity;
    using Element = const Entity;
    using Argument = Entity;
    static constexpr Need need = Need::always;
    static constexpr bool handed_out = true;
    static constexpr bool writes = false;
    static Argument argument(const Entity* column, std::size_t row) { return column[row]; }
};

template <>
struct Term<const Entity> : Term<Entity> {};

template <class T>
struct Term<Optional<T>> {
    static_assert(Component<std::remove_const_t<T>> && !is_tag<std::remove_const_t<T>>,
                  "Optional takes a component with a value");
    using Part = std::remove_const_t<T>;
    using Element = T;
    using Argument = T*;
    static constexpr Need need = Need::optional;
    static constexpr bool handed_out = true;
    static constexpr bool writes = !std::is_const_v<T>;
    static Argument argument(T* column, std::size_t row) {
        return column == nullptr ? nullptr : column + row;
    }
};

template <class C>
struct Term<With<C>> {
    using Part = std::remove_const_t<C>;
    static constexpr Need need = Need::required;
    static constexpr bool handed_out = false;
    static constexpr bool writes = false;
};

template <class C>
struct Term<Without<C>> {
    using Part = std::remove_const_t<C>;
    static constexpr Need need = Need::excluded;
    static constexpr bool handed_out = false;
    static constexpr bool writes = false;
};

/// The terms that hand something out, in their order, as the parameters of `Target`.
template <template <class...> class Target, class Done, class... Rest>
struct HandedOut;
template <template <class...> class Target, class... Done>
struct HandedOut<Target, std::tuple<Done...>> {
    using Type = Target<Done...>;
};
template <template <class...> class Target, class... Done, class First, class... Rest>
struct HandedOut<Target, std::tuple<Done...>, First, Rest...> {
    using Longer =
        std::conditional_t<Term<First>::handed_out, std::tuple<Done..., First>, std::tuple<Done...>>;
    using Type = typename HandedOut<Target, Longer, Rest...>::Type;
};

}  // namespace detail
}  // namespace rambla::ecs
