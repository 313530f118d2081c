#pragma once

#include <cstdint>

namespace rambla::ecs {

/// Where the values of a component live.
enum class Storage : std::uint8_t {
    column,  ///< one column per archetype: fastest to walk over; adding or removing moves the row
    sparse,  ///< one sparse set per world: adding or removing moves nothing; walked over row by row
    shared,  ///< once per distinct value: entities with equal values share an archetype
};

/// What a component type asks of its storage. Specialise it and name only what differs from the default:
///     template <>
///     struct component_options<Selected> {
///         static constexpr Storage storage = Storage::sparse;  // default: column
///         static constexpr bool enable_bit = true;             // columns only: World::set_enabled
///         static constexpr bool row_mask = true;               // columns only: Chunk::changed_rows
///         static std::uint64_t hash(const Selected&);          // shared only: finds a value among many;
///     };                                                       // equal values have equal hashes
/// Without a hash the bytes are hashed of types whose every bit is value (no floats, no padding), whose
/// operator== must not ignore any; other types' values are compared one by one.
template <class C>
struct component_options {};

namespace detail {

template <class C>
consteval Storage asked_storage() {
    if constexpr (requires { component_options<C>::storage; }) return component_options<C>::storage;
    return Storage::column;
}

template <class C>
consteval bool asked_enable_bit() {
    if constexpr (requires { component_options<C>::enable_bit; }) return component_options<C>::enable_bit;
    return false;
}

template <class C>
consteval bool asked_row_mask() {
    if constexpr (requires { component_options<C>::row_mask; }) return component_options<C>::row_mask;
    return false;
}

}  // namespace detail

/// Where the values of C live.
template <class C>
inline constexpr Storage storage_of = detail::asked_storage<C>();
/// Whether single rows can be switched off and on without moving.
template <class C>
inline constexpr bool has_enable_bit = detail::asked_enable_bit<C>();
/// Whether chunks remember which of their rows were written.
template <class C>
inline constexpr bool has_row_mask = detail::asked_row_mask<C>();

}  // namespace rambla::ecs
