#include "game/study/bloom_reference.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render/post/bloom_kernel.h"

namespace rambla::game::study {
namespace {

/// Light by row, in double precision.
struct Plane {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::dvec3> texels{};
};

/// A Gaussian by distance in pixels, and over what it is divided at each place of an axis.
struct AxisWeights {
    std::vector<double> at;
    std::vector<double> inside;
};

AxisWeights axis_weights(std::uint32_t size, double sigma_px) {
    AxisWeights weights;
    for (std::uint32_t distance = 0; distance < size; ++distance) {
        const double off = static_cast<double>(distance) / sigma_px;
        weights.at.push_back(std::exp(-0.5 * off * off));
    }
    weights.inside.assign(size, 0.0);
    for (std::uint32_t place = 0; place < size; ++place)
        for (std::uint32_t from = 0; from < size; ++from)
            weights.inside[place] += weights.at[place > from ? place - from : from - place];
    return weights;
}

/// Spreads along the rows, and exchanges the axes, so that twice is both.
Plane spread_rows_and_turn(const Plane& plane, double sigma_px) {
    const AxisWeights weights = axis_weights(plane.width, sigma_px);
    Plane turned{.width = plane.height,
                 .height = plane.width,
                 .texels = std::vector<glm::dvec3>(plane.texels.size(), glm::dvec3{0.0})};
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>{0, plane.height}, [&](const auto& rows) {
        std::vector<glm::dvec3> sums(plane.width);
        for (std::uint32_t y = rows.begin(); y < rows.end(); ++y) {
            std::fill(sums.begin(), sums.end(), glm::dvec3{0.0});
            for (std::uint32_t from = 0; from < plane.width; ++from) {
                const glm::dvec3 light = plane.texels[std::size_t{y} * plane.width + from];
                if (light == glm::dvec3{0.0}) continue;  // most of a picture does not glow
                for (std::uint32_t x = 0; x < plane.width; ++x)
                    sums[x] += light * weights.at[x > from ? x - from : from - x];
            }
            for (std::uint32_t x = 0; x < plane.width; ++x)
                turned.texels[std::size_t{x} * plane.height + y] = sums[x] / weights.inside[x];
        }
    });
    return turned;
}

}  // namespace

Picture glowing_part(const Picture& exposed, const render::BloomParameters& bloom) {
    const double threshold = bloom.threshold, knee = double{bloom.knee} * threshold;
    Picture glowing = exposed;
    for (glm::vec3& texel : glowing.texels) {
        const glm::dvec3 light{texel};
        const double luminance = glm::dot(light, glm::dvec3{0.2126, 0.7152, 0.0722});
        const double above = luminance - (threshold - knee);
        double part = 0.0;
        if (above > 0.0) part = above < 2.0 * knee ? above * above / (4.0 * knee) : luminance - threshold;
        texel = part > 0.0 ? glm::vec3{light * (part / luminance)} : glm::vec3{0.0f};
    }
    return glowing;
}

Picture spread_exactly(const Picture& light) {
    const Plane plane{
        .width = light.width, .height = light.height, .texels = {light.texels.begin(), light.texels.end()}};
    std::vector<glm::dvec3> sum(light.texels.size(), glm::dvec3{0.0});
    for (const double sigma_px : render::k_bloom_sigmas_px) {
        const Plane spread = spread_rows_and_turn(spread_rows_and_turn(plane, sigma_px), sigma_px);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += spread.texels[i];
    }
    Picture result{.width = light.width, .height = light.height, .texels = {}};
    result.texels.reserve(sum.size());
    for (const glm::dvec3& texel : sum)
        result.texels.emplace_back(texel / static_cast<double>(render::k_bloom_sigmas_px.size()));
    return result;
}

double energy(const Picture& light) {
    double sum = 0.0;
    for (const glm::vec3& texel : light.texels)
        sum += glm::dot(glm::dvec3{texel}, glm::dvec3{1.0});
    return sum;
}

/// Sum over pixels and channels of what is different.
double change(const Picture& before, const Picture& after) {
    double sum = 0.0;
    for (std::size_t i = 0; i < before.texels.size(); ++i)
        sum += glm::dot(glm::dvec3{glm::abs(after.texels[i] - before.texels[i])}, glm::dvec3{1.0});
    return sum;
}

double relative_rms_pct(const Picture& exact, const Picture& found) {
    double squared_error = 0.0, square = 0.0;
    for (std::size_t i = 0; i < exact.texels.size(); ++i) {
        const glm::dvec3 off = glm::dvec3{found.texels[i]} - glm::dvec3{exact.texels[i]};
        squared_error += glm::dot(off, off);
        square += glm::dot(glm::dvec3{exact.texels[i]}, glm::dvec3{exact.texels[i]});
    }
    return square > 0.0 ? 100.0 * std::sqrt(squared_error / square) : 0.0;
}

Picture scaled(Picture light, float factor) {
    for (glm::vec3& texel : light.texels)
        texel *= factor;
    return light;
}

Picture exact_glow(const Picture& scene, const render::BloomParameters& bloom) {
    return scaled(spread_exactly(glowing_part(scene, bloom)), bloom.intensity);
}

Picture sum_of(const Picture& a, const Picture& b) {
    Picture sum = a;
    for (std::size_t i = 0; i < sum.texels.size(); ++i)
        sum.texels[i] += b.texels[i];
    return sum;
}

}  // namespace rambla::game::study
