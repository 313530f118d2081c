#include "assets/import/gltf_document.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <span>

#include "assets/error.h"
#include "assets/import/gltf_container.h"
#include "assets/import/gltf_files.h"
#include "assets/import/gltf_preflight.h"

namespace rambla::assets::gltf {

namespace {

/// A claim of data that exists nowhere is honoured with zeros up to here.
constexpr std::uint64_t k_placeholder_bytes = 16u << 20;

/// tinygltf asks for files while it parses: buffers are served from here one after the other, images never
/// (they are read later, each when it is decoded).
struct FileServer {
    const Document& document;
    const Preflight& claims;
    std::uint64_t bytes_left = 0;
    std::vector<unsigned char> pending;
    std::exception_ptr failure;

    bool fetch() {
        const std::size_t index = document.model.buffers.size();
        if (failure || index >= claims.buffers.size()) return false;
        const BufferClaim& claim = claims.buffers[index];
        if (claim.source != BufferClaim::Source::external) return false;
        try {
            const std::string element = element_name("buffers", index, ".uri");
            pending = read_file(resolve_uri(document.path, element, claim.uri), bytes_left);
            if (pending.size() < claim.byte_length)
                document.fail(element,
                              in_quotes(claim.uri) + " holds " + std::to_string(pending.size()) + " bytes",
                              std::to_string(claim.byte_length) + " (byteLength)");
            pending.resize(claim.byte_length);
            bytes_left -= pending.size();
            return true;
        } catch (const std::exception&) {
            failure = std::current_exception();
            return false;
        }
    }
};

FileServer& server(void* user) {
    return *static_cast<FileServer*>(user);
}
bool file_exists(const std::string&, void* user) {
    return server(user).fetch();
}
std::string same_path(const std::string& path, void*) {
    return path;
}
bool read_pending(std::vector<unsigned char>* out, std::string*, const std::string&, void* user) {
    *out = std::move(server(user).pending);
    return true;
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

/// Keeps the bytes of a data URI. Images in buffer views are found again later: tinygltf has not checked the
/// view.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

/// The element at which tinygltf stopped: it fills its arrays in this order.
std::string failed_element(const tinygltf::Model& model, const Preflight& claims) {
    const std::pair<std::string_view, std::size_t> sections[] = {
        {"buffers", model.buffers.size()},     {"bufferViews", model.bufferViews.size()},
        {"accessors", model.accessors.size()}, {"meshes", model.meshes.size()},
        {"nodes", model.nodes.size()},         {"scenes", model.scenes.size()},
        {"materials", model.materials.size()}, {"images", model.images.size()},
        {"textures", model.textures.size()},   {"animations", model.animations.size()},
        {"skins", model.skins.size()},         {"samplers", model.samplers.size()},
        {"cameras", model.cameras.size()}};
    for (const auto& [name, parsed] : sections) {
        const auto claimed = claims.counts.find(name);
        if (claimed != claims.counts.end() && parsed < claimed->second) return element_name(name, parsed);
    }
    return element_name("extensions.KHR_lights_punctual.lights", model.lights.size());
}

/// The first thing that tinygltf says, on one line: what it quotes out of files may have several.
std::string first_line(const std::string& text) {
    std::size_t end = 0;
    bool quoted = false;
    while (end < text.size() && (quoted || text[end] != '\n'))
        quoted = quoted != (text[end++] == '"');
    const std::string line = in_quotes(std::string_view{text}.substr(0, end));
    return line.substr(1, line.size() - 2);
}

[[noreturn]] void fail_parsing(const Document& document, const Preflight& claims,
                               const std::string& message) {
    const std::string reason = first_line(message);
    // tinygltf looks at the indices of primitives between meshes and nodes.
    if (reason.starts_with("primitive indices") || reason.starts_with("accessor["))
        document.fail("meshes", reason, "indices of accessors with a buffer view");
    const std::string element = failed_element(document.model, claims);
    if (element.starts_with("buffers[")) {
        const std::size_t index = document.model.buffers.size();
        if (index < claims.buffers.size() && claims.buffers[index].source == BufferClaim::Source::data_uri)
            document.fail(
                element + ".uri", "a data URI that cannot be decoded",
                std::to_string(claims.buffers[index].byte_length) + " bytes in base64 (byteLength)");
    }
    document.fail(element, reason.empty() ? "something unreadable" : reason, "glTF 2.0");
}

/// The parts joined anew, for files that are valid but that tinygltf refuses: with an empty binary chunk,
/// with chunks of unknown type, or with buffers without data, which get zeros. Nothing, if the file will do
/// as it is.
std::vector<unsigned char> rejoined(const Document& document, const Container& parts,
                                    const Preflight& claims) {
    std::uint64_t longest = parts.binary.size();
    std::uint64_t placeholders = 0;
    for (std::size_t i = 0; i < claims.buffers.size(); ++i) {
        const BufferClaim& claim = claims.buffers[i];
        if (claim.source != BufferClaim::Source::none) continue;
        if (i == 0 && claim.byte_length <= parts.binary.size()) continue;
        placeholders += claim.byte_length;
        if (claim.byte_length > k_placeholder_bytes || placeholders > k_placeholder_bytes)
            document.fail(element_name("buffers", i),
                          std::to_string(claim.byte_length) + " bytes without data",
                          "a URI or a binary chunk");
        longest = std::max(longest, claim.byte_length);
    }
    const bool is_complete = longest == parts.binary.size();
    if (is_complete && !parts.plain_glb.empty()) return {};
    std::vector<unsigned char> binary(parts.binary.begin(), parts.binary.end());
    binary.resize(longest);
    return join_container(parts.json, binary);
}

bool parse(tinygltf::TinyGLTF& parser, Document& document, const Container& parts, const Preflight& claims,
           std::string& error) {
    std::string ignored;
    const bool without_data =
        std::any_of(claims.buffers.begin(), claims.buffers.end(),
                    [](const BufferClaim& claim) { return claim.source == BufferClaim::Source::none; });
    if (!without_data)
        return parser.LoadASCIIFromString(&document.model, &error, &ignored, parts.json.data(),
                                          static_cast<unsigned int>(parts.json.size()), "");
    const std::vector<unsigned char> joined = rejoined(document, parts, claims);
    const std::span<const unsigned char> glb = joined.empty() ? parts.plain_glb : joined;
    const bool parsed = parser.LoadBinaryFromMemory(&document.model, &error, &ignored, glb.data(),
                                                    static_cast<unsigned int>(glb.size()), "");
    // Only the first buffer may live in the binary chunk; tinygltf gives it to all that have no data.
    for (std::size_t i = 1; parsed && i < std::min(claims.buffers.size(), document.model.buffers.size()); ++i)
        if (claims.buffers[i].source == BufferClaim::Source::none)
            std::fill(document.model.buffers[i].data.begin(), document.model.buffers[i].data.end(), 0);
    return parsed;
}

/// Where Document::warn puts its lines on this thread; null: it logs them.
thread_local std::vector<std::string>* held_warnings = nullptr;

/// The JSON part of a file, to write to.
std::span<char> json_in(std::vector<unsigned char>& bytes, std::string_view json) {
    char* const begin = reinterpret_cast<char*>(bytes.data());
    return {begin + (json.data() - begin), json.size()};
}

void warn_of_extensions(const Document& document) {
    std::vector<std::string> names = document.model.extensionsUsed;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& name : names)
        if (!supports_extension(name))
            document.warn("extensionsUsed", in_quotes(name) + " is not supported and ignored");
}

}  // namespace

void Document::fail(std::string_view element, std::string_view found, std::string_view expected) const {
    throw Error{path.string(), element, found, expected};
}

void Document::warn(std::string_view element, std::string_view text) const {
    const std::string line = path.string().append(": ").append(element).append(": ").append(text);
    if (held_warnings != nullptr)
        held_warnings->push_back(line);
    else
        spdlog::warn("{}", line);
}

WarningHold::WarningHold(std::vector<std::string>& lines) {
    held_warnings = &lines;
}

WarningHold::~WarningHold() {
    held_warnings = nullptr;
}

void Document::spend(std::string_view element, std::uint64_t wanted) {
    const std::atomic_ref left{elements_left};
    std::uint64_t before = left.load();
    do {
        if (wanted > before)
            fail(element, std::to_string(wanted) + " more vertices, indices or particles",
                 "at most " + std::to_string(before) + " for a file of this size");
    } while (!left.compare_exchange_weak(before, before - wanted));
}

std::uint32_t Document::checked(int index, std::size_t size, std::string_view element,
                                std::string_view what) const {
    if (index < 0 || static_cast<std::size_t>(index) >= size)
        fail(element, std::string{what} + " " + std::to_string(index),
             size == 0 ? "none: the file has no such array" : "0 to " + std::to_string(size - 1));
    return static_cast<std::uint32_t>(index);
}

std::string element_name(std::string_view array, std::size_t index, std::string_view suffix) {
    return std::string{array}.append("[").append(std::to_string(index)).append("]").append(suffix);
}

Document load_document(const std::filesystem::path& file, const ImportLimits& limits) {
    Document document{.path = file, .limits = limits, .model = {}, .elements = 0, .elements_left = 0};
    std::vector<unsigned char> bytes = read_file(file, limits.file_bytes);
    Container parts = split_container(file.string(), bytes);
    const Preflight claims = preflight(file.string(), parts.json, limits);
    std::optional<std::string> plain;
    if (claims.has_integral_floats) plain = write_plain_integers(json_in(bytes, parts.json));
    if (plain) {
        parts.json = *plain;
        parts.plain_glb = {};
    }

    FileServer files{document, claims, limits.file_bytes - bytes.size(), {}, nullptr};
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_encoded, nullptr);
    parser.SetFsCallbacks({file_exists, same_path, read_pending, write_nothing, &files});
    std::string error;
    bool parsed = false;
    try {
        parsed = parse(parser, document, parts, claims, error);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& unexpected) {
        error = unexpected.what();
    }
    if (files.failure) std::rethrow_exception(files.failure);
    if (!parsed) fail_parsing(document, claims, error);

    // Zeros that stand for missing data buy nothing.
    std::uint64_t total = parts.json.size() + parts.binary.size();
    for (std::size_t i = 0; i < std::min(claims.buffers.size(), document.model.buffers.size()); ++i)
        if (claims.buffers[i].source != BufferClaim::Source::none)
            total += document.model.buffers[i].data.size();
    constexpr std::uint64_t k_elements_per_byte = 8;
    constexpr std::uint64_t k_elements_at_least = 1'000'000;
    document.elements = std::min(limits.vertices, std::max(k_elements_at_least, k_elements_per_byte * total));
    document.elements_left = document.elements;
    warn_of_extensions(document);
    for (const Finding& warning : claims.warnings)
        document.warn(warning.element, warning.text);
    return document;
}

}  // namespace rambla::assets::gltf
