#include "assets/process/image_rows.h"

#include <array>
#include <cmath>
#include <cstring>

#include "assets/process/srgb.h"

namespace rambla::assets {

namespace {

using Bytes = std::array<std::uint8_t, 4>;

void read_floats(const std::byte* texels, std::span<glm::vec4> row) {
    std::memcpy(row.data(), texels, row.size_bytes());
    for (glm::vec4& texel : row)
        for (int c = 0; c < 4; ++c)
            if (!std::isfinite(texel[c])) texel[c] = 0.0f;
}

}  // namespace

void read_row(const Image& picture, ColourSpace colour_space, std::uint32_t y, std::span<glm::vec4> row) {
    const std::byte* const texels =
        &picture.texels[std::size_t{y} * picture.width * bytes_per_texel(picture.format)];
    if (picture.format == PixelFormat::rgba32f) return read_floats(texels, row);
    const std::array<float, 256>& light = linear_from_srgb_bytes();
    for (std::size_t x = 0; x < row.size(); ++x) {
        Bytes texel;
        std::memcpy(texel.data(), texels + 4 * x, 4);
        row[x] = glm::vec4{texel[0], texel[1], texel[2], texel[3]} / 255.0f;
        if (colour_space == ColourSpace::srgb)
            row[x] = {light[texel[0]], light[texel[1]], light[texel[2]], row[x].w};
    }
}

glm::vec3 unit_or_up(glm::vec3 normal) {
    constexpr float k_no_direction = 1e-4f;
    const float length = glm::length(normal);
    return length > k_no_direction ? normal / length : glm::vec3{0.0f, 0.0f, 1.0f};
}

RowReader unit_normals_of(const Image& picture) {
    return [&picture](std::uint32_t y, std::span<glm::vec4> row) {
        read_row(picture, ColourSpace::linear, y, row);
        for (glm::vec4& texel : row)
            texel = {unit_or_up(2.0f * glm::vec3{texel} - 1.0f), 0.0f};
    };
}

Image to_image(const Raster& raster, PixelFormat format, ColourSpace colour_space) {
    Image image{.name = {}, .width = raster.width, .height = raster.height, .format = format, .texels = {}};
    image.texels.resize(raster.texels.size() * bytes_per_texel(format));
    if (format == PixelFormat::rgba32f) {
        std::memcpy(image.texels.data(), raster.texels.data(), image.texels.size());
        return image;
    }
    for (std::size_t i = 0; i < raster.texels.size(); ++i) {
        glm::vec4 texel = raster.texels[i];
        if (colour_space == ColourSpace::srgb)
            texel = {srgb_from_linear(texel.x), srgb_from_linear(texel.y), srgb_from_linear(texel.z),
                     texel.w};
        const Bytes bytes{byte_from_unit(texel.x), byte_from_unit(texel.y), byte_from_unit(texel.z),
                          byte_from_unit(texel.w)};
        std::memcpy(&image.texels[4 * i], bytes.data(), 4);
    }
    return image;
}

}  // namespace rambla::assets
