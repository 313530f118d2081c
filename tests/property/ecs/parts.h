#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ecs/component.h"
#include "ecs/parent.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::property {

using test::Anchored;
using test::Burning;
using test::Byte;
using test::Frozen;
using test::Health;
using test::Hidden;
using test::Light;
using test::Line;
using test::Material;
using test::Owner;
using test::Position;
using test::Score;
using test::Selected;
using test::SparseAnchored;
using test::Tint;

/// Anchored, but a value of it can be given to many.
struct Ticket : Anchored {
    explicit Ticket(int number = 0) noexcept : Anchored{number} {}
    Ticket(const Ticket& other) noexcept : Anchored{other.number()} {}
    Ticket(Ticket&&) noexcept = default;
    Ticket& operator=(Ticket&&) noexcept = default;
    ~Ticket() = default;
};

/// As wide as a vector register: moved by bytes in a way of its own.
struct Quad {
    std::array<float, 4> values{};
};

/// All components of the random worlds, by number: moved by bytes, by constructor, owning, wide, narrow,
/// without value, holding an entity, switched per row, stored sparse, shared, copied, changes told by row.
using Parts = std::tuple<Health, Position, Anchored, Owner, Line, Byte, Frozen, Hidden, Parent, Light,
                         Burning, SparseAnchored, Selected, Material, Tint, Ticket, Score, Quad>;
inline constexpr std::size_t k_part_count = std::tuple_size_v<Parts>;

/// By part: how it is stored.
inline constexpr auto k_storage = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{storage_of<std::tuple_element_t<I, Parts>>...};
}
(std::make_index_sequence<k_part_count>{});

[[nodiscard]] constexpr std::uint64_t key_of(Entity entity) {
    return (std::uint64_t{entity.generation} << 32u) | entity.index;
}
[[nodiscard]] constexpr Entity entity_of(std::uint64_t key) {
    return {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32u)};
}

/// From here on indices belong to no entity and no placeholder: parents that nobody ever was.
inline constexpr std::uint32_t k_nowhere = 0x7f000000u;

[[nodiscard]] constexpr OnParentEnd policy_of(std::uint32_t n) {
    return n % 2 == 0 ? OnParentEnd::destroyed : OnParentEnd::freed;
}
/// The policy is in the highest bit, which no generation here reaches.
[[nodiscard]] constexpr std::uint64_t parent_key(const Parent& parent) {
    return key_of(parent.entity) | (parent.on_end == OnParentEnd::freed ? std::uint64_t{1} << 63u : 0u);
}
[[nodiscard]] constexpr Parent parent_of(std::uint64_t key) {
    constexpr std::uint64_t k_freed = std::uint64_t{1} << 63u;
    const bool freed = (key & k_freed) != 0;
    return {entity_of(key & ~k_freed), freed ? OnParentEnd::freed : OnParentEnd::destroyed};
}

/// A component made from any number, and the number that tells it from others of its type: what the model
/// keeps instead of it.
template <class C>
[[nodiscard]] C make_part(std::uint32_t n) {
    if constexpr (std::is_same_v<C, Health>) return {static_cast<int>(n >> 1u)};
    if constexpr (std::is_same_v<C, Position>) return {static_cast<float>(n >> 8u), 1.0f, 2.0f};
    if constexpr (std::is_base_of_v<Anchored, C>) return C{static_cast<int>(n >> 1u)};
    if constexpr (std::is_same_v<C, Light>) return {static_cast<float>(n >> 8u)};
    if constexpr (std::is_same_v<C, Burning>) return {static_cast<int>(n >> 1u)};
    if constexpr (std::is_same_v<C, Material>) return {n >> 30u};  // few, as each makes archetypes
    if constexpr (std::is_same_v<C, Tint>) return {static_cast<std::uint8_t>(n >> 31u), 0.5};
    if constexpr (std::is_same_v<C, Score>) return {static_cast<int>(n >> 1u)};
    if constexpr (std::is_same_v<C, Owner>) return {std::make_unique<int>(static_cast<int>(n >> 1u))};
    if constexpr (std::is_same_v<C, Byte>) return {static_cast<std::uint8_t>(n)};
    if constexpr (std::is_same_v<C, Parent>) return {{k_nowhere + (n >> 8u), 0}, policy_of(n)};
    if constexpr (is_tag<C>) return {};
    if constexpr (std::is_same_v<C, Line>) {
        Line line;
        line.values.fill(static_cast<float>(n >> 8u));
        return line;
    }
    if constexpr (std::is_same_v<C, Quad>) {
        const auto value = static_cast<float>(n >> 8u);
        return {{value, value, value, value}};
    }
}

/// Nothing when the component is damaged.
template <class C>
[[nodiscard]] std::optional<std::uint64_t> read_part(const C& part) {
    if constexpr (std::is_same_v<C, Health>) return static_cast<std::uint64_t>(part.points);
    if constexpr (std::is_same_v<C, Position>) {
        if (part.y != 1.0f || part.z != 2.0f) return {};
        return static_cast<std::uint64_t>(part.x);
    }
    if constexpr (std::is_same_v<C, Light>) return static_cast<std::uint64_t>(part.lux);
    if constexpr (std::is_same_v<C, Burning>) return static_cast<std::uint64_t>(part.heat);
    if constexpr (std::is_same_v<C, Material>) return part.number;
    if constexpr (std::is_same_v<C, Score>) return static_cast<std::uint64_t>(part.points);
    if constexpr (std::is_same_v<C, Tint>) {
        if (part.strength != 0.5) return {};
        return part.kind;
    }
    if constexpr (std::is_base_of_v<Anchored, C>) {
        if (!part.intact()) return {};
        return static_cast<std::uint64_t>(part.number());
    }
    if constexpr (std::is_same_v<C, Owner>) {
        if (part.value == nullptr) return ~std::uint64_t{0};  // as it is made without a value
        return static_cast<std::uint64_t>(*part.value);
    }
    if constexpr (std::is_same_v<C, Byte>) return part.value;
    if constexpr (std::is_same_v<C, Parent>) return parent_key(part);
    if constexpr (is_tag<C>) return 0;
    if constexpr (std::is_same_v<C, Line> || std::is_same_v<C, Quad>) {
        for (float value : part.values)
            if (value != part.values[0]) return {};
        return static_cast<std::uint64_t>(part.values[0]);
    }
}

/// What read_part gives for make_part(n).
template <class C>
[[nodiscard]] std::uint64_t value_of(std::uint32_t n) {
    return *read_part(make_part<C>(n));
}

template <class C, std::size_t I = 0>
[[nodiscard]] constexpr std::size_t part_number() {
    if constexpr (std::is_same_v<C, std::tuple_element_t<I, Parts>>) {
        return I;
    } else {
        return part_number<C, I + 1>();
    }
}

/// Calls f.template operator()<C>() for the component with this number.
template <class F>
decltype(auto) with_part(std::size_t number, F&& f) {
    using Result = decltype(f.template operator()<Health>());
    return [&]<std::size_t... I>(std::index_sequence<I...>)->Result {
        using Call = Result (*)(F&);
        static constexpr std::array<Call, k_part_count> calls{[](F& g) -> Result {
            return g.template operator()<std::tuple_element_t<I, Parts>>();
        }...};
        return calls[number](f);
    }
    (std::make_index_sequence<k_part_count>{});
}

}  // namespace rambla::ecs::property
