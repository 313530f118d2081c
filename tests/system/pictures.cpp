#include "system/pictures.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "assets/import/image.h"

namespace rambla::system_test {

assets::Image picture(const std::filesystem::path& file) {
    return assets::read_image(file);
}

int byte_at(const assets::Image& image, std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
    return std::to_integer<int>(image.texels.at((std::size_t{y} * image.width + x) * 4 + channel));
}

double mean_byte(const assets::Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
        if (i % 4 != 3) sum += std::to_integer<int>(image.texels[i]);
    }
    return sum / (static_cast<double>(image.texels.size()) * 0.75);
}

double mean_difference(const assets::Image& a, const assets::Image& b) {
    if (a.width != b.width || a.height != b.height || a.texels.size() != b.texels.size()) {
        throw std::invalid_argument{"pictures of different sizes"};
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < a.texels.size(); ++i) {
        if (i % 4 != 3)
            sum += std::abs(std::to_integer<int>(a.texels[i]) - std::to_integer<int>(b.texels[i]));
    }
    return sum / (static_cast<double>(a.texels.size()) * 0.75);
}

double magenta_share(const assets::Image& image) {
    constexpr int k_clearly = 40;
    std::size_t found = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const int green = byte_at(image, x, y, 1);
            if (byte_at(image, x, y, 0) > green + k_clearly && byte_at(image, x, y, 2) > green + k_clearly)
                ++found;
        }
    }
    return static_cast<double>(found) / (static_cast<double>(image.width) * image.height);
}

std::size_t non_finite_texels(const assets::Image& image) {
    if (image.format != assets::PixelFormat::rgba32f)
        throw std::invalid_argument{"a picture of bytes is always finite"};
    std::size_t found = 0;
    for (std::size_t at = 0; at < image.texels.size(); at += 16) {
        glm::vec3 colour;
        std::memcpy(&colour, image.texels.data() + at, sizeof colour);
        if (!std::isfinite(colour.x) || !std::isfinite(colour.y) || !std::isfinite(colour.z)) ++found;
    }
    return found;
}

}  // namespace rambla::system_test
