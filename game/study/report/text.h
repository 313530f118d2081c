#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rambla::game::study {

/// Text for XML and HTML, inside elements and quoted attributes. Bytes that are no UTF-8 and characters that
/// XML does not have become U+FFFD, since one of them would make a reader refuse the whole file.
[[nodiscard]] std::string escaped(std::string_view text);

/// Bytes as characters for a data URI (RFC 4648, section 4).
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

/// The shortest decimal that reads back as the same double, in any locale: "0.1", "1e-07", "inf", "-inf",
/// "nan".
[[nodiscard]] std::string exact(double value);

/// A number for people with about three digits: "0.0123", "12.3", "12345", "1.2·10⁻⁷", "∞", "not a number".
[[nodiscard]] std::string brief(double value);

/// Digits as they stand in an exponent: "⁻⁵".
[[nodiscard]] std::string superscript(int number);

/// Characters of UTF-8 text, those that take no room of their own included.
[[nodiscard]] std::size_t length(std::string_view text);

/// Lines of at most `width` characters, broken at spaces, inside words that are longer than that. What goes
/// beyond `most_lines` is cut and ends in "…".
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t width,
                                               std::size_t most_lines);

}  // namespace rambla::game::study
