#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rambla::assets::gltf {

/// Printable, one line, at most 160 bytes: for text out of untrusted files in messages.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The file that a relative URI of a glTF document means: percent-decoded, inside the document's folder even
/// after symbolic links are followed, and a regular file.
/// @param document  the glTF file
/// @param element   of the document, for the message
/// @throws Error
[[nodiscard]] std::filesystem::path resolve_uri(const std::filesystem::path& document,
                                                const std::string& element, const std::string& uri);

/// A whole regular file. @throws Error  naming it, when it is absent, unreadable, or larger than `max_bytes`
[[nodiscard]] std::vector<unsigned char> read_file(const std::filesystem::path& file,
                                                   std::uint64_t max_bytes);

}  // namespace rambla::assets::gltf
