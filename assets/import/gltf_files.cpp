#include "assets/import/gltf_files.h"

#include <algorithm>
#include <fstream>
#include <optional>

#include "assets/error.h"

namespace rambla::assets::gltf {

namespace fs = std::filesystem;

namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percent_decoded(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
        if (low >= 0) {
            name.push_back(static_cast<char>(high * 16 + low));
            i += 2;
        } else {
            name.push_back(uri[i]);
        }
    }
    return name;
}

/// "http:", "file:" and the like; a single letter before the colon counts too (a drive).
bool has_scheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    return colon != std::string_view::npos && uri.find_first_of("/?# ") > colon;
}

bool leaves_folder(const fs::path& name) {
    const fs::path normal = name.lexically_normal();
    return normal.is_absolute() || normal.has_root_name() || (!normal.empty() && *normal.begin() == "..");
}

bool lies_inside(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

/// Exporters write names raw as well as percent-encoded: whichever of the two exists.
std::optional<fs::path> existing(const fs::path& folder, const std::string& uri) {
    for (const std::string& name : {percent_decoded(uri), uri}) {
        if (name.empty() || name.find('\0') != std::string::npos || leaves_folder(name)) continue;
        std::error_code failed;
        if (fs::exists(folder / name, failed)) return folder / name;
    }
    return std::nullopt;
}

}  // namespace

std::string in_quotes(std::string_view text) {
    constexpr std::size_t k_longest = 160;
    std::string line = "\"";
    for (const char c : text.substr(0, k_longest)) {
        const auto byte = static_cast<unsigned char>(c);
        line.push_back(byte < 0x20 || byte == 0x7f ? '?' : c);
    }
    if (text.size() > k_longest) line.append("...");
    return line.append("\"");
}

fs::path resolve_uri(const fs::path& document, const std::string& element, const std::string& uri) {
    const fs::path folder = document.has_parent_path() ? document.parent_path() : fs::path{"."};
    constexpr std::string_view k_expected = "a file name relative to the document, inside its folder";
    if (has_scheme(uri) || leaves_folder(percent_decoded(uri)) || leaves_folder(uri))
        throw Error{document.string(), element, in_quotes(uri), k_expected};
    const std::optional<fs::path> file = existing(folder, uri);
    if (!file) throw Error{document.string(), element, in_quotes(uri) + " is missing", "a file"};
    std::error_code failed;
    const fs::path real = fs::canonical(*file, failed);
    if (failed || !lies_inside(real, fs::canonical(folder, failed)))
        throw Error{document.string(), element, in_quotes(uri) + " is a link out of the folder", k_expected};
    if (!fs::is_regular_file(real, failed))
        throw Error{document.string(), element, in_quotes(uri) + " is not a regular file", "a file"};
    return real;
}

std::vector<unsigned char> read_file(const fs::path& file, std::uint64_t max_bytes) {
    std::error_code failed;
    if (!fs::exists(file, failed)) throw Error{file.string(), "", "no such file", ""};
    if (!fs::is_regular_file(file, failed)) throw Error{file.string(), "", "not a regular file", "a file"};
    const std::uint64_t size = fs::file_size(file, failed);
    if (failed) throw Error{file.string(), "", "cannot be read: " + failed.message(), ""};
    if (size > max_bytes)
        throw Error{file.string(), "", std::to_string(size) + " bytes",
                    "at most " + std::to_string(max_bytes)};
    // Piece by piece, so that the zeros that a vector is filled with first are still in the cache when they
    // are overwritten.
    constexpr std::uint64_t k_piece_bytes = 128 << 10;
    std::vector<unsigned char> bytes;
    bytes.reserve(static_cast<std::size_t>(size));
    std::ifstream stream{file, std::ios::binary};
    while (bytes.size() < size) {
        const std::size_t begin = bytes.size();
        const std::uint64_t wanted = std::min(k_piece_bytes, size - begin);
        bytes.resize(begin + static_cast<std::size_t>(wanted));
        stream.read(reinterpret_cast<char*>(&bytes[begin]), static_cast<std::streamsize>(wanted));
        if (!stream) throw Error{file.string(), "", "cannot be read", ""};
    }
    return bytes;
}

}  // namespace rambla::assets::gltf
