#include "game/study/picture.h"

#include <array>
#include <cstring>

#include "assets/assert.h"
#include "assets/process/srgb.h"

namespace rambla::game::study {
namespace {

glm::vec3 light_of_bytes(const std::byte* texel) {
    const std::array<float, 256>& light = assets::linear_from_srgb_bytes();
    return {light[std::to_integer<std::size_t>(texel[0])], light[std::to_integer<std::size_t>(texel[1])],
            light[std::to_integer<std::size_t>(texel[2])]};
}

glm::vec3 light_of_floats(const std::byte* texel) {
    std::array<float, 3> light;
    std::memcpy(light.data(), texel, sizeof light);
    return {light[0], light[1], light[2]};
}

}  // namespace

Picture to_picture(const assets::Image& image) {
    const std::size_t count = std::size_t{image.width} * image.height;
    const std::size_t stride = assets::bytes_per_texel(image.format);
    RAMBLA_ASSERT(image.texels.size() == count * stride, "an image holds every texel of its size");
    Picture picture{.width = image.width, .height = image.height, .texels = {}};
    picture.texels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* const texel = image.texels.data() + i * stride;
        picture.texels.push_back(image.format == assets::PixelFormat::rgba8 ? light_of_bytes(texel)
                                                                            : light_of_floats(texel));
    }
    return picture;
}

}  // namespace rambla::game::study
