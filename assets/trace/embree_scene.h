#pragma once

#include <cstddef>
#include <memory>

#include "assets/trace/placed_scene.h"

struct RTCSceneTy;  // of Embree, whose headers stay in this folder's sources

namespace rambla::assets {

/// A scene as Embree searches it: each mesh once, and instances of them, numbered like the scene's own. Knows
/// nothing of materials. Masks and culling are left to filter functions of the queries' contexts.
class EmbreeScene {
public:
    /// @param placed  must outlive this
    /// Leaves the caller's floating-point modes to the caller: see ScopedFloatMode.
    /// @throws std::runtime_error  with what Embree says, if it fails
    explicit EmbreeScene(const PlacedScene& placed);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    [[nodiscard]] RTCSceneTy* world() const;
    /// No vertex of any instance is farther from where the instance's local origin is; m.
    [[nodiscard]] double reach_m() const;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Embree searches in a mesh's own space, where its errors are this number times those in the world. Beyond
/// that, an instance gets a copy of its mesh in the world's space instead. Maps that are singular do too.
inline constexpr double k_largest_condition = 256.0;

}  // namespace rambla::assets
