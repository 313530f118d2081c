#include "render/gl/shader_text.h"

#include <algorithm>
#include <exception>
#include <regex>
#include <sstream>
#include <string_view>

#include "render/gl/program.h"

namespace rambla::render::gl {

namespace {

constexpr std::string_view k_room_prefix = "render/shaders/";

void append_line(ShaderText& text, std::string_view line, std::size_t file, std::size_t number) {
    text.text += line;
    text.text += '\n';
    text.origins.push_back({static_cast<std::uint32_t>(file), static_cast<std::uint32_t>(number)});
}

/// What stands after `#include`, trimmed; empty for other lines.
std::string_view include_argument(std::string_view line) {
    const auto skip_blanks = [&] {
        const std::size_t first = line.find_first_not_of(" \t");
        line.remove_prefix(std::min(first, line.size()));
    };
    skip_blanks();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skip_blanks();
    if (!line.starts_with("include")) return {};
    line.remove_prefix(7);
    skip_blanks();
    return line;
}

class Expander {
public:
    Expander(const ShaderSource& source, ShaderText& result) : source_{source}, result_{result} {}

    void expand(const std::string& path) {
        const std::string text = source_(path);
        const std::size_t file = result_.files.size();
        result_.files.push_back(path);
        std::istringstream lines{text};
        std::string line;
        for (std::size_t number = 1; std::getline(lines, line); ++number) {
            const std::string_view argument = include_argument(line);
            if (argument.empty()) {
                append_line(result_, line, file, number);
            } else if (!argument.starts_with('<')) {
                include(argument, path, number);
            }
        }
    }

private:
    void include(std::string_view argument, const std::string& from, std::size_t line) {
        const std::string place = from + ":" + std::to_string(line) + ": ";
        const std::size_t end = argument.find('"', 1);
        if (!argument.starts_with('"') || end == std::string_view::npos) {
            throw ShaderError(place + "#include expects a file name in quotation marks");
        }
        std::string_view path = argument.substr(1, end - 1);
        if (path.starts_with(k_room_prefix)) path.remove_prefix(k_room_prefix.size());
        const std::string file{path};
        if (std::find(result_.files.begin(), result_.files.end(), file) != result_.files.end()) return;
        try {
            expand(file);
        } catch (const ShaderError&) {
            throw;
        } catch (const std::exception& error) {
            throw ShaderError(place + "cannot include \"" + file + "\": " + error.what());
        }
    }

    const ShaderSource& source_;
    ShaderText& result_;
};

}  // namespace

ShaderText expand_shader(const std::string& path, const ShaderSource& source,
                         const std::vector<std::pair<std::string, std::string>>& defines) {
    ShaderText result;
    result.files.emplace_back("(defines)");
    std::size_t line = 0;
    append_line(result, "#version 450 core", 0, ++line);
    append_line(result, "#extension GL_ARB_shader_draw_parameters : enable", 0, ++line);
    for (const auto& [name, value] : defines)
        append_line(result, "#define " + name + " " + value, 0, ++line);
    try {
        Expander{source, result}.expand(path);
    } catch (const ShaderError&) {
        throw;
    } catch (const std::exception& error) {
        throw ShaderError(path + ": cannot be read: " + error.what());
    }
    return result;
}

std::string map_shader_log(const std::string& log, const ShaderText& text) {
    // Mesa writes `0:12(5): error: …`, NVIDIA `0(12) : error …`, AMD and Intel `ERROR: 0:12: …`.
    static const std::regex place{
        R"(^((?:ERROR|WARNING): )?\d+(?::(\d{1,9})(?:\(\d+\))?|\((\d{1,9})\)) ?: ?)"};
    std::string mapped;
    std::istringstream lines{log};
    std::string line;
    while (std::getline(lines, line)) {
        while (!line.empty() && (line.back() == '\r' || line.back() == '\0'))
            line.pop_back();
        if (line.empty()) continue;
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const std::size_t number = std::stoul(match[2].matched ? match[2].str() : match[3].str());
            if (number >= 1 && number <= text.origins.size()) {
                const ShaderText::Origin& origin = text.origins[number - 1];
                line = text.files[origin.file] + ":" + std::to_string(origin.line) + ": " + match[1].str() +
                       match.suffix().str();
            }
        }
        mapped += line;
        mapped += '\n';
    }
    if (!mapped.empty()) mapped.pop_back();
    return mapped;
}

}  // namespace rambla::render::gl
