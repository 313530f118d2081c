#pragma once

#include <array>
#include <span>
#include <string_view>

#include "assets/image.h"
#include "assets/parameter.h"
#include "assets/process/texture_plan.h"
#include "assets/texture_data.h"

namespace rambla::assets {

enum class Compression : std::uint8_t { off, fast, good };
inline constexpr std::array<std::string_view, 3> k_compressions{"off", "fast", "good"};

struct TextureParameters {
    Compression compression = Compression::good;
};
inline constexpr std::array k_texture_parameters{
    parameter<&TextureParameters::compression>("compression", k_compressions,
                                               "How much time block compression of textures may take."),
};

/// All levels of a picture for one use, compressed for the channels that are read: one in bc4, two in bc5 if
/// they are linear, alpha that is not opaque everywhere in bc3, else bc1. Float pictures, light maps
/// and what is smaller than a block stay as they are.
/// @param images  of the scene that the job was planned for
[[nodiscard]] TextureData process_texture(const TextureJob& job, ChannelMask channels,
                                          std::span<const Image> images, const TextureParameters& parameters);

}  // namespace rambla::assets
