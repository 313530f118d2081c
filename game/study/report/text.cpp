#include "game/study/report/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace rambla::game::study {
namespace {

constexpr std::string_view k_replacement = "\xEF\xBF\xBD";  // U+FFFD
constexpr std::string_view k_ellipsis = "…";

constexpr bool is_continuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

/// Length in bytes of the well-formed UTF-8 sequence at the start of the text (RFC 3629); 0 if there is none.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
    };
    const std::uint32_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return 0;
    std::uint32_t code = first & (0xFFu >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!is_continuation(text[i])) return 0;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    constexpr std::array<std::uint32_t, 5> k_smallest{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    const bool no_character = code == 0xFFFE || code == 0xFFFF;  // XML has neither
    return code < k_smallest[bytes] || code > 0x10FFFF || surrogate || no_character ? 0 : bytes;
}

/// With a real minus sign.
std::string with_sign(double value, const std::string& magnitude) {
    return value < 0.0 ? fmt::format("−{}", magnitude) : magnitude;
}

/// The first `count` characters.
std::string_view head(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    while (end < text.size()) {
        if (!is_continuation(text[end]) && count-- == 0) break;
        ++end;
    }
    return text.substr(0, end);
}

/// The text's words, those that are too long in pieces.
std::vector<std::string_view> words_of(std::string_view text, std::size_t width) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        std::string_view word = text.substr(0, space);
        text.remove_prefix(std::min(space + 1, text.size()));
        while (!word.empty()) {
            words.push_back(head(word, width));
            word.remove_prefix(words.back().size());
        }
    }
    return words;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        const std::size_t bytes = sequence_length(text.substr(i));
        const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
        if (bytes == 0 || control) {
            result += k_replacement;
        } else if (c == '<') {
            result += "&lt;";
        } else if (c == '>') {
            result += "&gt;";
        } else if (c == '&') {
            result += "&amp;";
        } else if (c == '"') {
            result += "&quot;";
        } else if (c == '\'') {
            result += "&#39;";
        } else {
            result += text.substr(i, bytes);
        }
        i += std::max<std::size_t>(bytes, 1);
    }
    return result;
}

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t j = 0; j < 3; ++j)
            bits = bits << 8 | (j < count ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= count ? k_digits[bits >> (18 - 6 * j) & 63u] : '=';
    }
    return text;
}

std::string exact(double value) {
    if (std::isnan(value)) return "nan";
    return fmt::format("{}", value);
}

std::string brief(double value) {
    if (std::isnan(value)) return "not a number";
    const double size = std::abs(value);
    if (std::isinf(value)) return with_sign(value, "∞");
    if (size == 0.0) return "0";
    constexpr int k_digits = 3;
    // Rounded first, so that 9.999 is seen as 10.0.
    const std::string rounded = fmt::format("{:.{}e}", size, k_digits - 1);
    const std::size_t e = rounded.find('e');
    const int exponent = std::atoi(rounded.c_str() + e + 1);
    if (exponent < -3 || exponent > 5)
        return with_sign(value, fmt::format("{}·10{}", rounded.substr(0, e), superscript(exponent)));
    const bool whole = size == std::floor(size);
    const int decimals = whole ? 0 : std::max(0, k_digits - 1 - exponent);
    return with_sign(value, fmt::format("{:.{}f}", size, decimals));
}

std::string superscript(int number) {
    constexpr std::array<const char*, 10> k_digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number)))
        text += k_digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::size_t length(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::size_t most_lines) {
    std::vector<std::string> lines;
    for (const std::string_view word : words_of(text, width)) {
        const bool fits = !lines.empty() && length(lines.back()) + 1 + length(word) <= width;
        if (fits) {
            lines.back().append(" ").append(word);
        } else if (lines.size() < most_lines) {
            lines.emplace_back(word);
        } else {
            std::string& last = lines.back();
            last = std::string{head(last, width - 1)}.append(k_ellipsis);
            break;
        }
    }
    return lines;
}

}  // namespace rambla::game::study
