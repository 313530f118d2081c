#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assets/import/gltf.h"
#include "assets/import/gltf_shape_check.h"

namespace rambla::assets::gltf {

/// What a document says of one of its buffers.
struct BufferClaim {
    enum class Source { none, data_uri, external };
    Source source = Source::none;
    std::string uri;  ///< only for external ones
    std::uint64_t byte_length = 0;
};

/// What must be known of a document before it is handed to tinygltf, which trusts its input in places.
struct Preflight {
    std::string version;
    std::string min_version;
    std::vector<std::string> extensions_required;
    std::vector<BufferClaim> buffers;
    std::map<std::string, std::uint64_t, std::less<>> counts;  ///< elements of each top-level array
    bool has_integral_floats = false;                          ///< numbers such as 1.0 or 1e0
    std::vector<Finding> warnings;
};

/// Walks the JSON once without keeping it: its syntax, its depth (tinygltf recurses), its number of values
/// (tinygltf multiplies them), the types and ranges of what the importer relies on (gltf_shape_check.h), its
/// version and its required extensions.
/// @throws Error  for broken JSON, values that cannot be meant, another version than 2.x, and every required
/// extension that is not supported
[[nodiscard]] Preflight preflight(const std::string& file, std::string_view json, const ImportLimits& limits);

/// Writes "1.0" and "1e0" as "1  ", in their place: glTF takes all for integers, tinygltf only the last.
/// @return  the whole text, where a number such as "1e9" needs more room
[[nodiscard]] std::optional<std::string> write_plain_integers(std::span<char> json);

/// Whether files that use the extension look as they should.
[[nodiscard]] bool supports_extension(std::string_view name);

}  // namespace rambla::assets::gltf
