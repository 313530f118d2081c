#include "assets/process/mips.h"

#include <algorithm>
#include <cmath>

#include "assets/assert.h"
#include "assets/process/coverage.h"
#include "assets/process/image_rows.h"
#include "assets/process/raster.h"

namespace rambla::assets {

namespace {

/// Reads a picture's rows as light, weighted by alpha where colours are. Where alpha is tested it is there or
/// not: the mean then is the share that passes, and a slope of alpha is cut at the same place in all levels.
RowReader light_of(const Image& picture, const ColourMips& options) {
    return [&picture, options](std::uint32_t y, std::span<glm::vec4> row) {
        read_row(picture, options.colour_space, y, row);
        if (options.alpha == AlphaUse::ignored) return;
        for (glm::vec4& texel : row) {
            if (options.alpha == AlphaUse::tested) texel.w = texel.w >= options.cutoff ? 1.0f : 0.0f;
            texel = {texel.w * glm::vec3{texel}, texel.w};
        }
    };
}

/// Colours of a raster of weighted ones; where all alpha is gone, those of `plain`, which are not weighted.
void take_weights_out(Raster& weighted, const Raster& plain) {
    constexpr float k_no_alpha = 1e-6f;
    for (std::size_t i = 0; i < weighted.texels.size(); ++i) {
        glm::vec4& texel = weighted.texels[i];
        const glm::vec3 colour =
            texel.w > k_no_alpha ? glm::vec3{texel} / texel.w : glm::vec3{plain.texels[i]};
        texel = {colour, texel.w};
    }
}

RowReader rows_of(const Raster& raster) {
    return [&raster](std::uint32_t y, std::span<glm::vec4> row) {
        std::copy_n(raster.row(y).begin(), row.size(), row.begin());
    };
}

Raster half_of(const Raster& raster) {
    return resampled(raster.width, raster.height, rows_of(raster), halved(raster.width),
                     halved(raster.height));
}

Raster first_half_of(const Image& picture, const RowReader& rows) {
    return resampled(picture.width, picture.height, rows, halved(picture.width), halved(picture.height));
}

}  // namespace

std::vector<Image> colour_mips(const Image& picture, const ColourMips& options) {
    std::vector<Image> levels{picture};
    const std::uint32_t count = mip_count(picture.width, picture.height);
    if (count == 1) return levels;
    const bool weighs = options.alpha != AlphaUse::ignored;
    const bool tests = options.alpha == AlphaUse::tested;
    const RowReader plain_rows = light_of(picture, {.colour_space = options.colour_space});
    const double coverage = tests ? alpha_coverage(resampled(picture.width, picture.height, plain_rows,
                                                             picture.width, picture.height),
                                                   options.cutoff)
                                  : 0.0;
    Raster light = first_half_of(picture, light_of(picture, options));
    Raster plain = weighs ? first_half_of(picture, plain_rows) : Raster{};
    for (std::uint32_t level = 1; level < count; ++level) {
        if (level > 1) {
            light = half_of(light);
            if (weighs) plain = half_of(plain);
        }
        Raster unweighted;
        if (weighs) {
            unweighted = light;
            take_weights_out(unweighted, plain);
        }
        if (tests) keep_coverage(unweighted, coverage, options.cutoff);
        levels.push_back(to_image(weighs ? unweighted : light, picture.format, options.colour_space));
    }
    return levels;
}

std::vector<Image> normal_mips(const Image& normals) {
    std::vector<Image> levels{normals};
    const std::uint32_t count = mip_count(normals.width, normals.height);
    if (count == 1) return levels;
    Raster mean = first_half_of(normals, unit_normals_of(normals));
    for (std::uint32_t level = 1; level < count; ++level) {
        if (level > 1) mean = half_of(mean);
        Raster shown = mean;
        for (glm::vec4& texel : shown.texels)
            texel = {0.5f + 0.5f * unit_or_up(glm::vec3{texel}), 1.0f};
        levels.push_back(to_image(shown, normals.format, ColourSpace::linear));
    }
    return levels;
}

std::vector<Image> roughness_mips(const Image& picture, const Image& normals, const RoughnessMips& options) {
    RAMBLA_ASSERT(picture.format == PixelFormat::rgba8, "roughness is stored in bytes");
    const bool constant = picture.width == 1 && picture.height == 1;
    const std::uint32_t width = constant ? normals.width : picture.width;
    const std::uint32_t height = constant ? normals.height : picture.height;
    // Green holds α², which is what averages; α is roughness².
    const RowReader squared = [&](std::uint32_t y, std::span<glm::vec4> row) {
        read_row(picture, ColourSpace::linear, y, row);
        for (glm::vec4& texel : row) {
            const float roughness = options.roughness * texel.y;
            texel.y = roughness * roughness * roughness * roughness;
        }
    };
    const RowReader scaled_normals = [&, unit = unit_normals_of(normals)](std::uint32_t y,
                                                                          std::span<glm::vec4> row) {
        unit(y, row);
        for (glm::vec4& texel : row)
            texel = {
                unit_or_up(glm::vec3{texel} * glm::vec3{options.normal_scale, options.normal_scale, 1.0f}),
                0.0f};
    };
    const std::uint32_t count = mip_count(width, height);
    Raster surface = resampled(picture.width, picture.height, squared, width, height);
    Raster mean = resampled(normals.width, normals.height, scaled_normals, width, height);
    std::vector<Image> levels;
    for (std::uint32_t level = 0; level < count; ++level) {
        if (level > 0) {
            surface = half_of(surface);
            mean = half_of(mean);
        }
        Raster shown = surface;
        for (std::size_t i = 0; i < shown.texels.size(); ++i) {
            constexpr float k_shortest = 1e-4f;  // roughness is 1 long before
            const float length = std::clamp(glm::length(glm::vec3{mean.texels[i]}), k_shortest, 1.0f);
            const float variance = (1.0f - length) / length;
            shown.texels[i].y = std::min(1.0f, std::sqrt(std::sqrt(shown.texels[i].y + 2.0f * variance)));
        }
        levels.push_back(to_image(shown, PixelFormat::rgba8, ColourSpace::linear));
    }
    return levels;
}

}  // namespace rambla::assets
