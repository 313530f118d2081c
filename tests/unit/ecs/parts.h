#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <tuple>
#include <utility>

#include "ecs/component.h"
#include "ecs/parent.h"

namespace rambla::ecs::test {

struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    bool operator==(const Position&) const = default;
};
struct Velocity {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    bool operator==(const Velocity&) const = default;
};
struct Health {
    int points = 0;
};
struct Byte {
    std::uint8_t value = 0;
};
struct alignas(64) Line {
    std::array<float, 16> values{};
};
struct Frozen {};
struct Hidden {};

/// Knows its own address: copying its bytes breaks it, and every one that is made must end.
class Anchored {
public:
    explicit Anchored(int number = 0) : self_{this}, number_{number} { ++alive; }
    Anchored(Anchored&& other) noexcept : self_{this}, number_{other.number_} { ++alive; }
    Anchored& operator=(Anchored&& other) noexcept {
        number_ = other.number_;
        return *this;
    }
    ~Anchored() {
        self_ = nullptr;
        --alive;
    }

    [[nodiscard]] bool intact() const { return self_ == this; }
    [[nodiscard]] int number() const { return number_; }

    inline static int alive = 0;

private:
    Anchored* self_;
    int number_;
};

/// Owns memory, but may be moved by its bytes.
struct Owner {
    std::unique_ptr<int> value;
};

/// Stored sparse.
struct Burning {
    int heat = 0;
};
struct SparseAnchored : Anchored {
    using Anchored::Anchored;
};
struct Selected {};  ///< a tag

/// Switched on and off per row.
struct Light {
    float lux = 0.0f;
};

/// Written sparsely: chunks remember which rows.
struct Score {
    int points = 0;
};

/// Common to all entities of an archetype.
struct Material {
    std::uint32_t number = 0;
};
struct Tint {  ///< with padding, and parts that compare in their own way
    std::uint8_t kind = 0;
    double strength = 0.0;
    bool operator==(const Tint&) const = default;
};

/// Many distinct components.
template <int N>
struct Part {
    float value = static_cast<float>(N);
};

}  // namespace rambla::ecs::test

template <>
struct rambla::ecs::component_options<rambla::ecs::test::Burning> {
    static constexpr Storage storage = Storage::sparse;
};
template <>
struct rambla::ecs::component_options<rambla::ecs::test::SparseAnchored> {
    static constexpr Storage storage = Storage::sparse;
};
template <>
struct rambla::ecs::component_options<rambla::ecs::test::Selected> {
    static constexpr Storage storage = Storage::sparse;
};
template <>
struct rambla::ecs::component_options<rambla::ecs::test::Light> {
    static constexpr bool enable_bit = true;
};

template <>
struct rambla::ecs::component_options<rambla::ecs::test::Material> {
    static constexpr Storage storage = Storage::shared;
};
template <>
struct rambla::ecs::component_options<rambla::ecs::test::Tint> {
    static constexpr Storage storage = Storage::shared;
    static std::uint64_t hash(const rambla::ecs::test::Tint& tint) { return tint.kind; }
};

template <>
struct rambla::ecs::component_options<rambla::ecs::test::Score> {
    static constexpr bool row_mask = true;
};

template <>
struct rambla::ecs::is_relocatable<rambla::ecs::test::Owner> : std::true_type {};
