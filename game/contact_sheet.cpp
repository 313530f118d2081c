#include "game/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "assets/assert.h"

namespace rambla::game {
namespace {

constexpr std::uint32_t k_gap_px = 4;

/// IEC 61966-2-1.
float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}
float srgb_from_linear(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

const std::array<float, 256>& linear_of_byte() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        return values;
    }();
    return table;
}

std::byte to_byte(float value) {
    return static_cast<std::byte>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

/// How much of each source texel one target texel covers, along one axis.
struct Footprint {
    std::uint32_t first = 0;
    std::vector<float> weights;  ///< add up to 1
};

std::vector<Footprint> footprints(std::uint32_t from, std::uint32_t to) {
    std::vector<Footprint> result(to);
    const double ratio = static_cast<double>(from) / to;
    for (std::uint32_t i = 0; i < to; ++i) {
        const double begin = i * ratio;
        const double end = std::min((i + 1) * ratio, static_cast<double>(from));
        const auto first = static_cast<std::uint32_t>(begin);
        result[i].first = first;
        for (std::uint32_t texel = first; texel < from && texel < end; ++texel) {
            const double covered = std::min(end, texel + 1.0) - std::max(begin, static_cast<double>(texel));
            result[i].weights.push_back(static_cast<float>(covered / (end - begin)));
        }
    }
    return result;
}

/// Row `y` of the picture in linear light, averaged along x.
void add_shrunk_row(const assets::Image& picture, std::uint32_t y, float weight,
                    const std::vector<Footprint>& columns, std::vector<glm::vec4>& sum) {
    const std::array<float, 256>& linear = linear_of_byte();
    const std::byte* const row = picture.texels.data() + std::size_t{y} * picture.width * 4;
    for (std::size_t x = 0; x < columns.size(); ++x) {
        const std::byte* texel = row + std::size_t{columns[x].first} * 4;
        for (const float column_weight : columns[x].weights) {
            const glm::vec4 value{linear[std::to_integer<std::size_t>(texel[0])],
                                  linear[std::to_integer<std::size_t>(texel[1])],
                                  linear[std::to_integer<std::size_t>(texel[2])],
                                  static_cast<float>(std::to_integer<int>(texel[3])) / 255.0f};
            sum[x] += (weight * column_weight) * value;
            texel += 4;
        }
    }
}

}  // namespace

assets::Image shrunk(const assets::Image& picture, glm::uvec2 size_px) {
    RAMBLA_ASSERT(picture.format == assets::PixelFormat::rgba8, "display pictures have bytes");
    RAMBLA_ASSERT(size_px.x <= picture.width && size_px.y <= picture.height, "only shrinks");
    assets::Image result{.name = picture.name,
                         .width = size_px.x,
                         .height = size_px.y,
                         .format = assets::PixelFormat::rgba8,
                         .texels = std::vector<std::byte>(std::size_t{size_px.x} * size_px.y * 4)};
    const std::vector<Footprint> columns = footprints(picture.width, size_px.x);
    const std::vector<Footprint> rows = footprints(picture.height, size_px.y);
    std::vector<glm::vec4> sum(size_px.x);
    std::byte* out = result.texels.data();
    for (const Footprint& row : rows) {
        std::fill(sum.begin(), sum.end(), glm::vec4{0.0f});
        for (std::size_t i = 0; i < row.weights.size(); ++i) {
            add_shrunk_row(picture, row.first + static_cast<std::uint32_t>(i), row.weights[i], columns, sum);
        }
        for (const glm::vec4& value : sum) {
            for (int channel = 0; channel < 3; ++channel)
                *out++ = to_byte(srgb_from_linear(value[channel]));
            *out++ = to_byte(value.w);
        }
    }
    return result;
}

ContactSheet::ContactSheet(std::uint32_t pictures, glm::uvec2 picture_size_px, std::uint32_t cell_width_px) {
    const std::uint32_t width = std::min(picture_size_px.x, cell_width_px);
    const double aspect = static_cast<double>(picture_size_px.y) / picture_size_px.x;
    cell_px_ = {width, std::max(1u, static_cast<std::uint32_t>(std::lround(width * aspect)))};
    columns_ = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(pictures))));
    const std::uint32_t rows = (pictures + columns_ - 1) / columns_;
    sheet_.name = "contact sheet";
    sheet_.width = columns_ * (cell_px_.x + k_gap_px) + k_gap_px;
    sheet_.height = rows * (cell_px_.y + k_gap_px) + k_gap_px;
    sheet_.texels.assign(std::size_t{sheet_.width} * sheet_.height * 4, std::byte{0});
    for (std::size_t alpha = 3; alpha < sheet_.texels.size(); alpha += 4)
        sheet_.texels[alpha] = std::byte{255};
}

void ContactSheet::place(std::uint32_t cell, const assets::Image& picture) {
    const assets::Image small = shrunk(picture, cell_px_);
    const std::uint32_t left = k_gap_px + (cell % columns_) * (cell_px_.x + k_gap_px);
    const std::uint32_t top = k_gap_px + (cell / columns_) * (cell_px_.y + k_gap_px);
    const std::size_t row_bytes = std::size_t{cell_px_.x} * 4;
    for (std::uint32_t y = 0; y < cell_px_.y; ++y) {
        const std::size_t to = (std::size_t{top + y} * sheet_.width + left) * 4;
        std::memcpy(sheet_.texels.data() + to, small.texels.data() + y * row_bytes, row_bytes);
    }
}

}  // namespace rambla::game
