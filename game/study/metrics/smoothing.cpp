#include "game/study/metrics/smoothing.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "assets/process/srgb.h"
#include "game/study/metrics/edge_distance.h"
#include "game/study/metrics/texels.h"

namespace rambla::game::study {
namespace {

void require_region(const Picture& picture, std::span<const std::uint8_t> region) {
    if (region.size() == picture.texels.size()) return;
    throw std::invalid_argument(fmt::format("a region of {} pixels does not fit a picture of {}x{}",
                                            region.size(), picture.width, picture.height));
}

glm::dvec3 display_value(glm::vec3 light) {
    const glm::vec3 shown = finite_or_black(light);
    return {assets::srgb_from_linear(shown.x), assets::srgb_from_linear(shown.y),
            assets::srgb_from_linear(shown.z)};
}

std::vector<double> display_luminances(const Picture& picture) {
    std::vector<double> values;
    values.reserve(picture.texels.size());
    for (const glm::vec3& light : picture.texels)
        values.push_back(
            assets::srgb_from_linear(static_cast<float>(luminance(glm::dvec3{finite_or_black(light)}))));
    return values;
}

double deviation_about(std::span<const double> values, std::size_t middle, std::size_t width) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t row = middle - width; row <= middle + width; row += width) {
        for (std::size_t i = row - 1; i <= row + 1; ++i) {
            sum += values[i];
            squares += values[i] * values[i];
        }
    }
    constexpr double k_window = 9.0;
    const double mean = sum / k_window;
    return std::sqrt(std::max(squares / k_window - mean * mean, 0.0));
}

}  // namespace

PixelRegions pixel_regions(glm::uvec2 size_px, std::span<const std::uint8_t> is_edge, double within_px,
                           double farther_px) {
    const std::vector<double> distances = edge_distance_px(size_px, is_edge);
    PixelRegions regions{.edges = std::vector<std::uint8_t>(distances.size()),
                         .textures = std::vector<std::uint8_t>(distances.size())};
    for (std::size_t i = 0; i < distances.size(); ++i) {
        regions.edges[i] = distances[i] <= within_px ? 1 : 0;
        regions.textures[i] = distances[i] > farther_px ? 1 : 0;
    }
    return regions;
}

double rms_display(const Picture& reference, const Picture& test, std::span<const std::uint8_t> region) {
    require_same_size(reference, test);
    require_region(reference, region);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
        if (region[i] == 0) continue;
        const glm::dvec3 difference = display_value(test.texels[i]) - display_value(reference.texels[i]);
        sum += glm::dot(difference, difference);
        count += 3;
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

double mean_within(std::span<const float> map, std::span<const std::uint8_t> region) {
    if (map.size() != region.size())
        throw std::invalid_argument(
            fmt::format("a region of {} pixels does not fit a map of {}", region.size(), map.size()));
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (region[i] == 0) continue;
        sum += static_cast<double>(map[i]);
        ++count;
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

double local_contrast(const Picture& picture, std::span<const std::uint8_t> region) {
    require_region(picture, region);
    const std::vector<double> values = display_luminances(picture);
    const std::size_t width = picture.width;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t y = 1; y + 1 < picture.height; ++y) {
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const std::size_t i = y * width + x;
            if (region[i] == 0) continue;
            sum += deviation_about(values, i, width);
            ++count;
        }
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace rambla::game::study
