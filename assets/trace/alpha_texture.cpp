#include "assets/trace/alpha_texture.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>

#include "assets/process/blocks.h"
#include "assets/texture_levels.h"

namespace rambla::assets {
namespace {

using Level = AlphaTexture::Level;

Level level_of(const Image& image, ChannelSource source) {
    const std::size_t count = std::size_t{image.width} * image.height;
    if (count == 0 || image.texels.size() != count * bytes_per_texel(image.format))
        throw std::invalid_argument{
            fmt::format("'{}' has {} bytes, but {} x {} texels with alpha are expected", image.name,
                        image.texels.size(), image.width, image.height)};
    Level level{image.width, image.height, std::vector<float>(count, 1.0f)};
    if (source == ChannelSource::one) return level;
    const auto channel = static_cast<std::size_t>(source);
    for (std::size_t i = 0; i < count; ++i) {
        if (source == ChannelSource::zero) {
            level.alpha[i] = 0.0f;
        } else if (image.format == PixelFormat::rgba8) {
            level.alpha[i] = static_cast<float>(image.texels[4 * i + channel]) / 255.0f;
        } else {
            std::memcpy(&level.alpha[i], &image.texels[16 * i + 4 * channel], sizeof(float));
        }
    }
    return level;
}

Image picture_of(const TextureData& texture, std::uint32_t number) {
    const TextureLevel& level = texture.levels[number];
    const std::span<const std::byte> bytes = bytes_of(texture, number, number + 1);
    if (texture.format != TexelFormat::rgba8 && texture.format != TexelFormat::rgba32f)
        return decompressed(bytes, texture.format, level.width, level.height);
    Image image;
    image.name = texture.name;
    image.width = level.width;
    image.height = level.height;
    image.format = texture.format == TexelFormat::rgba8 ? PixelFormat::rgba8 : PixelFormat::rgba32f;
    image.texels.assign(bytes.begin(), bytes.end());
    return image;
}

/// Where a texel of any number lies in a row of `size`. OpenGL 4.5, table 8.20.
std::size_t wrapped(double texel, double size, WrapMode mode) {
    double place = 0.0;
    switch (mode) {
        case WrapMode::repeat:
            place = texel - size * std::floor(texel / size);
            break;
        case WrapMode::mirrored_repeat: {
            const double in_two = texel - 2.0 * size * std::floor(texel / (2.0 * size));
            place = in_two < size ? in_two : 2.0 * size - 1.0 - in_two;
            break;
        }
        case WrapMode::clamp_to_edge:
            place = texel;
            break;
    }
    return static_cast<std::size_t>(std::clamp(place, 0.0, size - 1.0));
}

double texel(const Level& level, const Sampler& sampler, double x, double y) {
    const std::size_t column = wrapped(x, level.width, sampler.wrap_u);
    const std::size_t row = wrapped(y, level.height, sampler.wrap_v);
    return level.alpha[row * level.width + column];
}

double in_level(const Level& level, const Sampler& sampler, Filter filter, glm::dvec2 uv) {
    const glm::dvec2 place = uv * glm::dvec2{level.width, level.height};
    if (filter == Filter::nearest) return texel(level, sampler, std::floor(place.x), std::floor(place.y));
    const glm::dvec2 corner = glm::floor(place - 0.5);
    const glm::dvec2 f = place - 0.5 - corner;
    const auto row = [&](double y) {
        return glm::mix(texel(level, sampler, corner.x, y), texel(level, sampler, corner.x + 1.0, y), f.x);
    };
    return glm::mix(row(corner.y), row(corner.y + 1.0), f.y);
}

}  // namespace

AlphaTexture alpha_texture(const Image& image, const Sampler& sampler) {
    AlphaTexture result;
    result.levels.push_back(level_of(image, ChannelSource::alpha));
    result.sampler = sampler;
    return result;
}

AlphaTexture alpha_texture(const TextureData& texture, const Sampler& sampler) {
    if (texture.levels.empty() || texture.first_stored > 0)
        throw std::invalid_argument{fmt::format(
            "'{}' has no bytes of its finer levels, which its alpha mask needs: keep all", texture.name)};
    AlphaTexture result;
    result.sampler = sampler;
    for (std::uint32_t i = 0; i < texture.levels.size(); ++i)
        result.levels.push_back(level_of(picture_of(texture, i), texture.swizzle[3]));
    return result;
}

glm::dvec2 transformed_uv(const TextureSlot& slot, glm::dvec2 uv) {
    const double c = std::cos(static_cast<double>(slot.rotation_rad));
    const double s = std::sin(static_cast<double>(slot.rotation_rad));
    const glm::dvec2 scaled = uv * glm::dvec2{slot.scale};
    return glm::dvec2{c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x} + glm::dvec2{slot.offset};
}

double sampled_alpha(const AlphaTexture& texture, glm::dvec2 uv, double texels_per_pixel) {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return 1.0;
    const Sampler& sampler = texture.sampler;
    // Level of detail: log2 of the footprint. Magnified up to 0 (section 8.15: the threshold is ½ only for
    // a linear magnifying filter with unmixed levels of a nearest one, which is rare and close enough).
    if (!(texels_per_pixel > 1.0)) return in_level(texture.levels[0], sampler, sampler.magnify, uv);
    if (sampler.mip == MipFilter::none) return in_level(texture.levels[0], sampler, sampler.minify, uv);
    const double coarsest = static_cast<double>(texture.levels.size() - 1);
    const double lod = std::min(std::log2(texels_per_pixel), coarsest);
    const auto level = [&](double number) {
        return in_level(texture.levels[static_cast<std::size_t>(number)], sampler, sampler.minify, uv);
    };
    if (sampler.mip == MipFilter::nearest) return level(std::min(std::floor(lod + 0.5), coarsest));
    const double finer = std::floor(lod);
    return glm::mix(level(finer), level(std::min(finer + 1.0, coarsest)), lod - finer);
}

}  // namespace rambla::assets
