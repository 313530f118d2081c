#include "game/study/report/page_pictures.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "assets/export/image.h"
#include "game/study/report/picture_files.h"
#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

/// The width of a column of pictures, and the least one of broad pictures: 20 rem of 16 px each in
/// page_style.cpp.
constexpr std::uint32_t k_column_px = 320;
/// More would make a flat square of a few pixels.
constexpr std::uint32_t k_largest_factor = 16;

/// How much a picture is enlarged: as far as fits into every column.
std::uint32_t factor_of(const assets::Image& image) {
    return std::clamp(k_column_px / image.width, 1u, k_largest_factor);
}

/// What stands for the picture where it cannot be seen.
std::string alternative(const PictureRow& row, const LabelledPicture& picture, const std::string& file) {
    if (row.title.empty() && picture.label.empty()) return file;
    return fmt::format("{}{}{}", row.title, row.title.empty() || picture.label.empty() ? "" : ": ",
                       picture.label);
}

std::string figure_of(const PictureRow& row, const LabelledPicture& picture, const std::string& file) {
    const assets::Image& image = picture.image;
    const std::uint32_t factor = factor_of(image);
    return fmt::format(
        "<figure><a href=\"{}\"><img{} width=\"{}\" height=\"{}\" alt=\"{}\" "
        "src=\"data:image/png;base64,{}\"/></a><figcaption>{}</figcaption></figure>\n",
        escaped(file), factor > 1 ? " class=\"pixels\"" : "", factor * image.width, factor * image.height,
        escaped(alternative(row, picture, file)), base64(assets::encode_png(image)), escaped(picture.label));
}

std::uint32_t broadest(const PictureRow& row) {
    std::uint32_t width = 0;
    for (const LabelledPicture& picture : row.pictures)
        width = std::max(width, picture.image.width);
    return width;
}

std::string row_html(const StudyResult& study, std::size_t index) {
    const PictureRow& row = study.pictures[index];
    std::string figures;
    std::string missing;
    for (std::size_t i = 0; i < row.pictures.size(); ++i) {
        const LabelledPicture& picture = row.pictures[i];
        if (const std::string fault = picture_fault(row, i); fault.empty())
            figures += figure_of(row, picture, picture_file(study.name, index, i));
        else
            missing += fmt::format("<p class=\"small\">“{}” is not shown: {}.</p>\n", escaped(picture.label),
                                   escaped(fault));
    }
    if (row.pictures.empty()) missing = "<p class=\"small\">There are no pictures.</p>\n";
    const std::string title =
        row.title.empty() ? std::string{} : fmt::format("<h3>{}</h3>\n", escaped(row.title));
    const char* const css_class = broadest(row) > k_column_px ? "pictures broad" : "pictures";
    const std::string shown =
        figures.empty() ? std::string{} : fmt::format("<div class=\"{}\">\n{}</div>\n", css_class, figures);
    return fmt::format("<div class=\"block\">{}{}{}</div>\n", title, shown, missing);
}

}  // namespace

std::string pictures_html(const StudyResult& study) {
    std::string html;
    for (std::size_t row = 0; row < study.pictures.size(); ++row)
        html += row_html(study, row);
    return html;
}

}  // namespace rambla::game::study
