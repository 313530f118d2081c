#include "game/study/report/picture_files.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>

#include "assets/error.h"
#include "assets/export/image.h"
#include "assets/import/image.h"

namespace rambla::game::study {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_extension = ".png";

std::string fault_of(const assets::Image& image) {
    if (image.width == 0 || image.height == 0) return "there is no picture of it";
    if (image.format != assets::PixelFormat::rgba8) return "its channels are no bytes";
    if (std::max(image.width, image.height) > k_most_picture_px)
        return fmt::format("it has {} × {} pixels, at most {} × {} are shown", image.width, image.height,
                           k_most_picture_px, k_most_picture_px);
    const std::size_t expected =
        std::size_t{image.width} * image.height * assets::bytes_per_texel(image.format);
    if (image.texels.size() != expected)
        return fmt::format("it has {} bytes of texels instead of {}", image.texels.size(), expected);
    return {};
}

/// Whether a file is a picture of this study: NAME-1-1.png, and not NAME-OTHER-1-1.png of a longer name.
bool belongs_to(const std::string& file, const std::string& study) {
    std::string_view rest = file;
    if (!rest.starts_with(study) || !rest.ends_with(k_extension)) return false;
    rest.remove_prefix(study.size());
    rest.remove_suffix(std::min(rest.size(), k_extension.size()));
    for (int number = 0; number < 2; ++number) {
        if (!rest.starts_with('-')) return false;
        rest.remove_prefix(1);
        const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
        if (digits == 0) return false;
        rest.remove_prefix(digits);
    }
    return rest.empty();
}

void remove_others(const fs::path& folder, const std::string& study, const std::set<std::string>& kept) {
    std::vector<fs::path> others;
    std::error_code failed;
    for (fs::directory_iterator entry{folder, failed}; !failed && entry != fs::directory_iterator{};
         entry.increment(failed)) {
        const std::string file = entry->path().filename().string();
        if (belongs_to(file, study) && !kept.contains(file)) others.push_back(entry->path());
    }
    for (const fs::path& file : others)
        fs::remove(file, failed);
}

}  // namespace

std::string picture_fault(const PictureRow& row, std::size_t index) {
    const assets::Image& image = row.pictures[index].image;
    if (std::string fault = fault_of(image); !fault.empty()) return fault;
    const auto first = std::find_if(row.pictures.begin(), row.pictures.end(),
                                    [](const auto& picture) { return fault_of(picture.image).empty(); });
    if (image.width == first->image.width && image.height == first->image.height) return {};
    return fmt::format("it has {} × {} pixels, and “{}” beside it {} × {}", image.width, image.height,
                       first->label, first->image.width, first->image.height);
}

std::string picture_file(const std::string& study, std::size_t row, std::size_t picture) {
    return fmt::format("{}-{}-{}{}", study, row + 1, picture + 1, k_extension);
}

void write_pictures(const fs::path& folder, const StudyResult& study) {
    std::set<std::string> written;
    for (std::size_t row = 0; row < study.pictures.size(); ++row) {
        const std::vector<LabelledPicture>& pictures = study.pictures[row].pictures;
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            if (const std::string fault = picture_fault(study.pictures[row], i); !fault.empty()) {
                spdlog::warn("{}: the picture “{}” is left out of the report: {}", study.name,
                             pictures[i].label, fault);
                continue;
            }
            const std::string file = picture_file(study.name, row, i);
            assets::write_image(folder / file, pictures[i].image);
            written.insert(file);
        }
    }
    remove_others(folder, study.name, written);
}

void read_pictures(const fs::path& folder, StudyResult& study) {
    constexpr assets::PictureLimits k_limits{.size_px = k_most_picture_px};
    for (std::size_t row = 0; row < study.pictures.size(); ++row) {
        std::vector<LabelledPicture>& pictures = study.pictures[row].pictures;
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            const fs::path file = folder / picture_file(study.name, row, i);
            std::error_code unknown;
            if (!fs::exists(file, unknown)) continue;  // as for one that could not be shown
            try {
                pictures[i].image = assets::read_image(file, k_limits);
            } catch (const assets::Error& error) {
                spdlog::warn("left out of the report: {}", error.what());
            }
        }
    }
}

}  // namespace rambla::game::study
