#pragma once

#include <array>
#include <cstdint>

#include "assets/generate/builder.h"
#include "assets/generate/draws.h"
#include "assets/generate/evening.h"

namespace rambla::assets::generate {

/// Material of each surface: what a model's parts refer to.
using Scheme = std::array<std::uint32_t, k_surface_count>;

/// All materials of a street, in the scene that they were made in.
struct Palette {
    Scheme standard{};  ///< of everything but buildings and cars
    std::array<std::uint32_t, 9> plasters{};
    std::uint32_t brick = k_none;
    std::uint32_t stone = k_none;
    std::array<std::uint32_t, 3> trims{};
    std::array<std::uint32_t, 2> frames{};
    std::array<std::uint32_t, 4> shutters{};
    std::array<std::uint32_t, 3> doors{};
    std::array<std::uint32_t, 3> shop_frames{};
    std::array<std::uint32_t, 3> awnings{};
    std::array<std::uint32_t, 5> bodies{};  ///< car paint
};

/// Adds textures and materials to the scene; what shines does so as it should at that time.
[[nodiscard]] Palette add_palette(Scene& scene, const Evening& evening, std::uint64_t seed);

/// Adds a picture as a light map, which ends where it ends. It has no mip levels: it is smooth, and its
/// charts would run into each other.
[[nodiscard]] std::uint32_t add_light_map(Scene& scene, Image image);

/// Colours for one building.
/// @param brick  walls of brick instead of plaster
[[nodiscard]] Scheme building_scheme(const Palette& palette, Draws& draws, bool brick);

/// Meshes in a scene that several models may share, each with what it is made of.
struct StoredPart {
    Surface surface = Surface::wall;
    std::uint32_t mesh = k_none;
};

/// Moves parts into the scene's meshes.
[[nodiscard]] std::vector<StoredPart> store(Scene& scene, std::vector<Builder::Part> parts);

/// Adds a model that shows stored parts in the materials of a scheme; returns its index.
std::uint32_t add_model(Scene& scene, const std::string& name, const std::vector<StoredPart>& parts,
                        const Scheme& scheme);

}  // namespace rambla::assets::generate
