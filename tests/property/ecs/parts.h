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
using test::Selected;
using test::SparseAnchored;

/// All components of the random worlds, by number: moved by bytes, by constructor, owning, wide, narrow,
/// without value, holding an entity, switched per row, stored sparse, shared.
using Parts = std::tuple<Health, Position, Anchored, Owner, Line, Byte, Frozen, Hidden, Parent, Light,
                         Burning, SparseAnchored, Selected, Material>;
inline constexpr std::size_t k_part_count = std::tuple_size_v<Parts>;

[[nodiscard]] constexpr std::uint64_t key_of(Entity entity) {
    return (std::uint64_t{entity.generation} << 32u) | entity.index;
}
[[nodiscard]] constexpr Entity entity_of(std::uint64_t key) {
    return {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32u)};
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
    if constexpr (std::is_same_v<C, Owner>) return {std::make_unique<int>(static_cast<int>(n >> 1u))};
    if constexpr (std::is_same_v<C, Byte>) return {static_cast<std::uint8_t>(n)};
    if constexpr (std::is_same_v<C, Parent>) return {{n & 0xffu, 1u + (n >> 28u)}};
    if constexpr (is_tag<C>) return {};
    if constexpr (std::is_same_v<C, Line>) {
        Line line;
        line.values.fill(static_cast<float>(n >> 8u));
        return line;
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
    if constexpr (std::is_base_of_v<Anchored, C>) {
        if (!part.intact()) return {};
        return static_cast<std::uint64_t>(part.number());
    }
    if constexpr (std::is_same_v<C, Owner>) {
        if (part.value == nullptr) return ~std::uint64_t{0};  // as it is made without a value
        return static_cast<std::uint64_t>(*part.value);
    }
    if constexpr (std::is_same_v<C, Byte>) return part.value;
    if constexpr (std::is_same_v<C, Parent>) return key_of(part.entity);
    if constexpr (is_tag<C>) return 0;
    if constexpr (std::is_same_v<C, Line>) {
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
