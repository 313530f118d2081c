#pragma once

#include <glm/glm.hpp>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace rambla::game::study {

/// Whether every element of an XML text is closed in the right order, and no character stands bare that
/// markup is made of. Knows what we write: no comments, CDATA or processing instructions.
inline bool is_well_formed(std::string_view text) {
    std::vector<std::string_view> open;
    while (!text.empty()) {
        const std::size_t begin = text.find('<');
        const std::string_view between = text.substr(0, begin);
        for (std::size_t at = between.find('&'); at != std::string_view::npos; at = between.find('&', at + 1))
            if (between.find(';', at) == std::string_view::npos) return false;
        if (between.find('>') != std::string_view::npos) return false;
        if (begin == std::string_view::npos) break;
        const std::size_t end = text.find('>', begin);
        if (end == std::string_view::npos) return false;
        const std::string_view tag = text.substr(begin + 1, end - begin - 1);
        text.remove_prefix(end + 1);
        const std::string_view name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag.find('<') != std::string_view::npos) return false;
        if (tag.starts_with('/')) {
            if (open.empty() || tag.substr(1) != open.back()) return false;
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(name);
        }
    }
    return open.empty();
}

struct SvgBox {
    glm::dvec2 low, high;
};

/// Where a picture's text stands.
struct SvgText {
    glm::dvec2 at;
    std::string css_class, anchor, text;
};

/// What the tests look at in a figure that to_svg() wrote.
struct SvgFigure {
    glm::dvec2 size{0.0};
    SvgBox frame{};
    std::vector<glm::dvec2> marks{};
    std::vector<std::string> colours{};  ///< of the marks: "s0"
    std::vector<std::string> shapes{};   ///< of the marks: path data
    std::vector<SvgText> texts{};
    std::vector<std::vector<glm::dvec2>>
        fronts{};  ///< the Pareto front's corners; also its sample in the legend

    [[nodiscard]] std::vector<std::string> texts_of(const std::string& css_class) const {
        std::vector<std::string> found;
        for (const SvgText& text : texts)
            if (text.css_class == css_class) found.push_back(text.text);
        return found;
    }
};

inline std::vector<std::smatch> matches(const std::string& svg, const char* pattern) {
    const std::regex regex{pattern};
    return {std::sregex_iterator{svg.begin(), svg.end(), regex}, std::sregex_iterator{}};
}

inline double number(const std::smatch& match, std::size_t group) {
    return std::stod(match[group].str());
}

inline std::vector<glm::dvec2> path_points(const std::string& path) {
    std::vector<glm::dvec2> points;
    for (const std::smatch& corner : matches(path, R"re([ML](\S+) ([^ML]+))re"))
        points.emplace_back(number(corner, 1), number(corner, 2));
    return points;
}

/// @param svg  outlives nothing: all is copied
inline SvgFigure read_svg(const std::string& svg) {
    SvgFigure figure;
    for (const std::smatch& box : matches(svg, R"re(viewBox="0 0 (\S+) (\S+)")re"))
        figure.size = {number(box, 1), number(box, 2)};
    for (const std::smatch& m :
         matches(svg, R"re(<rect class="frame" x="(\S+)" y="(\S+)" width="(\S+)" height="(\S+)"/>)re")) {
        figure.frame.low = {number(m, 1), number(m, 2)};
        figure.frame.high = figure.frame.low + glm::dvec2{number(m, 3), number(m, 4)};
    }
    for (const std::smatch& m :
         matches(svg, R"re(<path class="mark (s\d)" transform="translate\((\S+) (\S+)\)" d="([^"]*)">)re")) {
        figure.colours.push_back(m[1].str());
        figure.marks.emplace_back(number(m, 2), number(m, 3));
        figure.shapes.push_back(m[4].str());
    }
    for (const std::smatch& m :
         matches(svg, R"re(<text class="(\w+)" x="(\S+)" y="(\S+)" text-anchor="(\w+)">([^<]*)</text>)re"))
        figure.texts.push_back({{number(m, 2), number(m, 3)}, m[1].str(), m[4].str(), m[5].str()});
    for (const std::smatch& m : matches(svg, R"re(<path class="front" d="([^"]*)"/>)re"))
        figure.fronts.push_back(path_points(m[1].str()));
    return figure;
}

}  // namespace rambla::game::study
