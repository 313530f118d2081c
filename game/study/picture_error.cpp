#include "game/study/picture_error.h"

#include <cstdlib>

#include "game/study/metrics/flip.h"
#include "game/study/metrics/psnr.h"
#include "game/study/metrics/texels.h"
#include "game/study/picture.h"

namespace rambla::game::study {
namespace {

/// What few eyes tell apart beside each other: a step of six bits.
constexpr int k_tolerance_255ths = 4;

double wrong_bytes_pct(const assets::Image& reference, const assets::Image& test) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i + 3 < reference.texels.size(); i += 4) {
        bool differs = false;
        for (std::size_t channel = i; channel < i + 3; ++channel)
            differs = differs || std::abs(std::to_integer<int>(reference.texels[channel]) -
                                          std::to_integer<int>(test.texels[channel])) > k_tolerance_255ths;
        wrong += differs ? 1 : 0;
    }
    return percent(wrong, reference.texels.size() / 4);
}

}  // namespace

std::vector<Metric> display_metrics(const assets::Image& reference, const assets::Image& test) {
    const Picture expected = to_picture(reference);
    const Picture found = to_picture(test);
    return {{"flip_mean", ldr_flip(expected, found).mean, ""},
            {"psnr_db", psnr_db(expected, found), "dB"},
            {"wrong_pixels_pct", wrong_bytes_pct(reference, test), "%"}};
}

std::vector<Metric> mean_metrics(const std::vector<std::vector<Metric>>& pictures) {
    if (pictures.empty()) return {};
    std::vector<Metric> mean = pictures.front();
    for (std::size_t i = 0; i < mean.size(); ++i) {
        double sum = 0.0;
        for (const std::vector<Metric>& of_picture : pictures)
            sum += of_picture[i].value;
        mean[i].value = sum / static_cast<double>(pictures.size());
    }
    return mean;
}

}  // namespace rambla::game::study
