#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

#include "ecs/component_options.h"
#include "ecs/entity.h"

namespace rambla::ecs {

/// Columns begin at multiples of this many bytes, and so does every chunk of them.
inline constexpr std::size_t k_column_alignment = 64;

/// Whether a row may be moved by copying its bytes and forgetting the source. Specialise it to true for types
/// that own memory but nowhere hold their own address (std::unique_ptr, most of std::vector); others are
/// moved by their move constructor and destructor.
template <class C>
struct is_relocatable : std::bool_constant<std::is_trivially_copyable_v<C>> {};

/// Lists the members of a component that hold entities, so that Commands can put real entities where
/// placeholders were recorded:
///     template <> struct entity_members<Parent> { static constexpr std::tuple value{&Parent::entity}; };
template <class C>
struct entity_members {};

/// What may be a component: any object type whose move cannot fail, so that no operation stops half-way
/// through a row.
template <class C>
concept Component = std::is_object_v<C> && !std::is_array_v<C> && std::same_as<C, std::remove_cv_t<C>> &&
                    !std::same_as<C, Entity> && std::is_nothrow_move_constructible_v<C> &&
                    std::is_nothrow_destructible_v<C> && alignof(C) <= k_column_alignment &&
                    (!std::is_empty_v<C> || std::is_trivially_destructible_v<C>);

namespace detail {

/// Says why a type is no component, where the concept would only say that it is none.
template <class C>
constexpr void explain_component() {
    static_assert(std::is_object_v<C> && !std::is_array_v<C> && std::same_as<C, std::remove_cv_t<C>>,
                  "a component is an object type, neither an array nor const nor volatile");
    static_assert(!std::same_as<C, Entity>, "a component wraps an Entity and gives it a meaning");
    static_assert(std::is_nothrow_move_constructible_v<C> && std::is_nothrow_destructible_v<C>,
                  "moving and ending a component cannot fail (noexcept), so that nothing stops half-way "
                  "through a row");
    static_assert(alignof(C) <= k_column_alignment, "a component is aligned to at most 64 bytes");
    static_assert(!std::is_empty_v<C> || std::is_trivially_destructible_v<C>,
                  "a component without data (a tag) ends without doing anything");
}

}  // namespace detail

/// Empty components are tags: they tell archetypes apart, but have no column, so nothing can be read from
/// them.
template <class C>
inline constexpr bool is_tag = std::is_empty_v<C>;

/// Whether rows of a component with an enable bit are switched off: one byte per row, in a column beside the
/// component's own, so that it moves as any other column does. Follows the component into every archetype.
template <class C>
struct EnableState {
    std::uint8_t disabled = 0;  ///< 0 or 1
};

/// Number of a component inside one world, in the order in which the world met them.
using ComponentId = std::uint16_t;
/// No component of the world.
inline constexpr ComponentId k_no_component = 0xffff;

namespace detail {

template <class T>
constexpr const char* signature_naming() {
    return __PRETTY_FUNCTION__;
}

std::uint32_t next_type_index();

template <class T, class... Ts>
inline constexpr std::size_t k_times_in = (std::size_t{0} + ... + (std::is_same_v<T, Ts> ? 1u : 0u));

template <class... Ts>
inline constexpr bool k_all_differ = ((k_times_in<Ts, Ts...> == 1) && ...);

}  // namespace detail

/// Name of a type as the compiler writes it, for messages.
template <class T>
constexpr std::string_view type_name() {
    const std::string_view signature = detail::signature_naming<T>();
    const std::size_t begin = signature.find("T = ") + 4;
    return signature.substr(begin, signature.size() - 1 - begin);
}

/// A small number per type for the running program. Depends on the order of first use: a key for tables,
/// never to be stored or compared between runs.
template <class T>
std::uint32_t type_index() {
    static const std::uint32_t index = detail::next_type_index();
    return index;
}

/// What storage must know of a component type.
struct ComponentInfo {
    std::string_view name;         ///< see type_name()
    std::uint32_t type_index = 0;  ///< see type_index()
    std::uint32_t size = 0;        ///< bytes per row; 0 for tags
    std::uint32_t alignment = 1;
    /// Moves `count` objects to raw memory that does not overlap and ends the sources; null: copy the bytes.
    void (*relocate)(void* to, void* from, std::size_t count) noexcept = nullptr;
    void (*destroy)(void* first, std::size_t count) noexcept = nullptr;  ///< null: nothing to do
    Storage storage = Storage::column;
    bool row_mask = false;
    /// Its EnableState, which is in an archetype exactly if the component is; null without an enable bit.
    const ComponentInfo* companion = nullptr;
    bool is_companion = false;  ///< an EnableState: new rows begin as zero, not as raw memory
    /// Of shared components; see SharedValues.
    bool (*equal)(const void* a, const void* b) = nullptr;
    std::uint64_t (*hash)(const void* value) = nullptr;
};

namespace detail {

template <class C>
inline constexpr bool k_is_enable_state = false;
template <class C>
inline constexpr bool k_is_enable_state<EnableState<C>> = true;

template <class C>
void relocate(void* to, void* from, std::size_t count) noexcept {
    C* source = static_cast<C*>(from);
    C* target = static_cast<C*>(to);
    for (std::size_t i = 0; i < count; ++i) {
        std::construct_at(target + i, std::move(source[i]));
        std::destroy_at(source + i);
    }
}

template <class C>
void destroy(void* first, std::size_t count) noexcept {
    std::destroy_n(static_cast<C*>(first), count);
}

}  // namespace detail

/// All that is known of C; one object per type.
template <Component C>
const ComponentInfo& component_info();

namespace detail {

template <class C>
const ComponentInfo* companion_of() {
    if constexpr (has_enable_bit<C>) return &component_info<EnableState<C>>();
    return nullptr;
}

template <class C>
bool shared_values_equal(const void* a, const void* b) {
    if constexpr (requires(const C& value) { bool(value == value); }) {
        if (*static_cast<const C*>(a) == *static_cast<const C*>(b)) return true;
    } else {
        static_assert(std::has_unique_object_representations_v<C>, "shared values need an operator==");
    }
    return std::memcmp(a, b, sizeof(C)) == 0;
}

/// Equal values must have equal hashes: of its bytes only where these are all that tells values apart. Where
/// nothing is known all values share one hash, and are compared one by one.
template <class C>
std::uint64_t shared_value_hash([[maybe_unused]] const void* value) {
    if constexpr (requires(const C& c) { component_options<C>::hash(c); }) {
        return component_options<C>::hash(*static_cast<const C*>(value));
    } else if constexpr (std::has_unique_object_representations_v<C>) {
        return std::hash<std::string_view>{}({static_cast<const char*>(value), sizeof(C)});
    } else {
        return 0;
    }
}

template <class C>
constexpr auto equal_of() -> bool (*)(const void*, const void*) {
    if constexpr (storage_of<C> == Storage::shared) return &shared_values_equal<C>;
    return nullptr;
}

template <class C>
constexpr auto hash_of() -> std::uint64_t (*)(const void*) {
    if constexpr (storage_of<C> == Storage::shared) return &shared_value_hash<C>;
    return nullptr;
}

}  // namespace detail

template <Component C>
const ComponentInfo& component_info() {
    static_assert(storage_of<C> != Storage::shared || std::is_trivially_copyable_v<C>,
                  "shared values are copied by their bytes");
    static_assert(storage_of<C> == Storage::column || !(has_enable_bit<C> || has_row_mask<C>),
                  "only columns have enable bits and row masks");
    static_assert(!is_tag<C> || !(has_enable_bit<C> || has_row_mask<C>),
                  "a tag has no column that could have an enable bit or a row mask");
    static_assert(!is_tag<C> || storage_of<C> != Storage::shared, "a tag has no value to share");
    static const ComponentInfo info{
        .name = type_name<C>(),
        .type_index = type_index<C>(),
        .size = is_tag<C> ? 0u : static_cast<std::uint32_t>(sizeof(C)),
        .alignment = static_cast<std::uint32_t>(alignof(C)),
        .relocate = is_relocatable<C>::value ? nullptr : &detail::relocate<C>,
        .destroy = std::is_trivially_destructible_v<C> ? nullptr : &detail::destroy<C>,
        .storage = storage_of<C>,
        .row_mask = has_row_mask<C>,
        .companion = detail::companion_of<C>(),
        .is_companion = detail::k_is_enable_state<C>,
        .equal = detail::equal_of<C>(),
        .hash = detail::hash_of<C>()};
    return info;
}

}  // namespace rambla::ecs
