#include "game/study/metrics/flip_view.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

#include "game/study/metrics/flip_colour.h"

namespace rambla::game::study::flip {
namespace {

class Plane {
public:
    Plane(std::size_t width, std::size_t height) : width_{width}, height_{height}, values_(width * height) {}

    [[nodiscard]] std::span<float> row(std::size_t y) { return {values_.data() + y * width_, width_}; }

    /// Rows around y; beyond the border the outermost one.
    [[nodiscard]] auto rows_around(std::size_t y) const {
        return [this, y](int offset) {
            const auto last = static_cast<std::ptrdiff_t>(height_) - 1;
            const auto wanted = static_cast<std::ptrdiff_t>(y) + offset;
            const auto row = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(wanted, 0, last));
            return values_.data() + row * width_;
        };
    }

private:
    std::size_t width_;
    std::size_t height_;
    std::vector<float> values_;
};

/// A picture filtered along its rows.
struct RowFiltered {
    std::array<Plane, 4> blur;  ///< as Kernels::blur
    Plane gaussian;             ///< the three of the luminance
    Plane edge;
    Plane point;
};

/// The opponent channels of a picture's row, continued beyond its ends.
class PaddedRow {
public:
    PaddedRow(std::size_t width, int padding) : padding_{static_cast<std::size_t>(padding)} {
        for (std::vector<float>& channel : channels_)
            channel.resize(width + 2 * padding_);
    }
    void read(std::span<const glm::vec3> texels) {
        for (std::size_t x = 0; x < texels.size(); ++x)
            write(padding_ + x, opponent_from_rgb(texels[x]));
        for (std::size_t i = 0; i < padding_; ++i) {
            write(i, opponent_from_rgb(texels.front()));
            write(padding_ + texels.size() + i, opponent_from_rgb(texels.back()));
        }
    }
    /// The row shifted by an offset within the padding.
    [[nodiscard]] auto shifted(int channel) const {
        const float* const first = channels_[static_cast<std::size_t>(channel)].data() + padding_;
        return [first](int offset) {
            return first + offset;
        };
    }

private:
    void write(std::size_t i, glm::vec3 opponent) {
        channels_[0][i] = opponent.x;
        channels_[1][i] = opponent.y;
        channels_[2][i] = opponent.z;
    }

    std::size_t padding_;
    std::array<std::vector<float>, 3> channels_{};
};

using Rows = tbb::blocked_range<std::size_t>;

RowFiltered filter_rows(const Picture& picture, const Kernels& kernels) {
    const std::size_t width = picture.width;
    const Plane empty{width, picture.height};
    RowFiltered filtered{{empty, empty, empty, empty}, empty, empty, empty};
    const int padding = std::max(radius_of(kernels.blur[0].kernel), radius_of(kernels.gaussian));
    tbb::parallel_for(Rows{0, picture.height}, [&](const Rows& rows) {
        PaddedRow padded{width, padding};
        for (std::size_t y = rows.begin(); y < rows.end(); ++y) {
            padded.read(std::span{picture.texels}.subspan(y * width, width));
            for (std::size_t i = 0; i < kernels.blur.size(); ++i)
                add_weighted(kernels.blur[i].kernel, padded.shifted(kernels.blur[i].channel),
                             filtered.blur[i].row(y));
            add_weighted(kernels.gaussian, padded.shifted(0), filtered.gaussian.row(y));
            add_weighted_differences(kernels.edge, padded.shifted(0), filtered.edge.row(y));
            add_weighted_differences(kernels.point, padded.shifted(0), filtered.point.row(y));
        }
    });
    return filtered;
}

/// A row of everything, filtered along both axes.
class SeenRow {
public:
    explicit SeenRow(std::size_t width) {
        for (std::vector<float>* const sums : all())
            sums->resize(width);
    }
    void filter(const RowFiltered& rows, const Kernels& kernels, std::size_t y) {
        for (std::vector<float>* const sums : all())
            std::fill(sums->begin(), sums->end(), 0.0f);
        for (std::size_t i = 0; i < kernels.blur.size(); ++i)
            add_weighted(kernels.blur[i].kernel, rows.blur[i].rows_around(y),
                         opponent_[static_cast<std::size_t>(kernels.blur[i].channel)]);
        add_weighted(kernels.gaussian, rows.edge.rows_around(y), edge_x_);
        add_weighted_differences(kernels.edge, rows.gaussian.rows_around(y), edge_y_);
        add_weighted(kernels.gaussian, rows.point.rows_around(y), point_x_);
        add_weighted_differences(kernels.point, rows.gaussian.rows_around(y), point_y_);
    }
    [[nodiscard]] Seen at(std::size_t x) const {
        const glm::vec3 rgb = rgb_from_opponent({opponent_[0][x], opponent_[1][x], opponent_[2][x]});
        return {.hunt_lab = hunt_lab_from_rgb(glm::clamp(rgb, 0.0f, 1.0f)),
                .edge = std::sqrt(edge_x_[x] * edge_x_[x] + edge_y_[x] * edge_y_[x]),
                .point = std::sqrt(point_x_[x] * point_x_[x] + point_y_[x] * point_y_[x])};
    }

private:
    [[nodiscard]] std::array<std::vector<float>*, 7> all() {
        return {&opponent_[0], &opponent_[1], &opponent_[2], &edge_x_, &edge_y_, &point_x_, &point_y_};
    }

    std::array<std::vector<float>, 3> opponent_{};
    std::vector<float> edge_x_{};
    std::vector<float> edge_y_{};
    std::vector<float> point_x_{};
    std::vector<float> point_y_{};
};

}  // namespace

std::vector<Seen> see(const Picture& picture, const Kernels& kernels) {
    const std::size_t width = picture.width;
    std::vector<Seen> seen(picture.texels.size());
    if (seen.empty()) return seen;
    const RowFiltered filtered = filter_rows(picture, kernels);
    tbb::parallel_for(Rows{0, picture.height}, [&](const Rows& rows) {
        SeenRow row{width};
        for (std::size_t y = rows.begin(); y < rows.end(); ++y) {
            row.filter(filtered, kernels, y);
            for (std::size_t x = 0; x < width; ++x)
                seen[y * width + x] = row.at(x);
        }
    });
    return seen;
}

float difference(const Seen& a, const Seen& b) {
    const float feature = std::max(std::abs(a.edge - b.edge), std::abs(a.point - b.point));
    // The paper's exponent q_f is 0.5. A strength reaches √2, on a corner at most.
    const float feature_difference = std::min(std::sqrt(feature / std::numbers::sqrt2_v<float>), 1.0f);
    return std::pow(colour_difference(a.hunt_lab, b.hunt_lab), 1.0f - feature_difference);
}

}  // namespace rambla::game::study::flip
