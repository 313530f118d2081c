#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

#include "ecs/archetype_graph.h"
#include "ecs/command.h"
#include "ecs/filters.h"
#include "ecs/terms.h"

namespace rambla::ecs::detail {

/// Whether all rows of the archetype fit one term of a query.
template <class T>
bool fits_whole(const ArchetypeGraph& graph, const Archetype& archetype) {
    using Fitted = Term<T>;
    static_assert(!Fitted::filters_rows && !Fitted::filters_chunks,
                  "a command for a whole query takes terms that whole archetypes fit or do not fit");
    if constexpr (requires { Fitted::fits(graph, archetype); }) {
        return Fitted::fits(graph, archetype);
    } else if constexpr (Fitted::need == Need::required) {
        return archetype.has(graph.find_component(ecs::type_index<typename Fitted::Part>()));
    } else if constexpr (Fitted::need == Need::excluded) {
        return !archetype.has(graph.find_component(ecs::type_index<typename Fitted::Part>()));
    } else {
        return true;
    }
}

template <class... Terms>
bool all_fit_whole([[maybe_unused]] const ArchetypeGraph& graph,
                   [[maybe_unused]] const Archetype& archetype) {
    return (fits_whole<Terms>(graph, archetype) && ...);
}

template <class C>
void fill_rows(void* first, std::size_t count, const void* value) noexcept {
    std::uninitialized_fill_n(static_cast<C*>(first), count, *static_cast<const C*>(value));
}

/// A command for all entities that fit `Terms`.
template <CommandKind Kind, class C, class... Terms>
const CommandType& whole_command_type() {
    static_assert(storage_of<C> == Storage::column, "only columns come and go with whole archetypes");
    static_assert(Kind == CommandKind::remove || is_tag<C> || std::is_nothrow_copy_constructible_v<C>,
                  "a value for many entities is copied, and copying it cannot fail (noexcept)");
    static const CommandType type = [] {
        CommandType result = command_type<Kind, C>();
        result.fits = &all_fit_whole<Terms...>;
        if constexpr (Kind == CommandKind::add && !is_tag<C>) result.fill = &fill_rows<C>;
        return result;
    }();
    return type;
}

template <class... Terms>
const CommandType& whole_destroy_type() {
    static const CommandType type = [] {
        CommandType result = command_type<CommandKind::destroy>();
        result.fits = &all_fit_whole<Terms...>;
        return result;
    }();
    return type;
}

}  // namespace rambla::ecs::detail
