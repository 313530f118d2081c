#include "assets/import/gltf_container.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include "assets/error.h"

namespace rambla::assets::gltf {

namespace {

constexpr std::uint32_t k_magic = 0x46546c67;         // "glTF"
constexpr std::uint32_t k_json_chunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t k_binary_chunk = 0x004e4942;  // "BIN\0"
constexpr std::uint64_t k_header_bytes = 12;
constexpr std::uint64_t k_chunk_header_bytes = 8;

/// Little-endian on every machine that we build for.
std::uint32_t word_at(std::span<const unsigned char> bytes, std::uint64_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

void put_word(std::vector<unsigned char>& bytes, std::uint64_t word) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<unsigned char>(word >> shift & 0xff));
}

std::string_view as_text(std::span<const unsigned char> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    std::uint32_t type = 0;
    std::span<const unsigned char> data;
    std::uint64_t end = 0;  ///< where the next chunk begins
};

Chunk chunk_at(const std::string& file, std::span<const unsigned char> glb, std::uint64_t offset, int index) {
    const std::string element = "chunk[" + std::to_string(index) + "]";
    const std::uint64_t rest = glb.size() - offset;
    if (rest < k_chunk_header_bytes)
        throw Error{file, element, std::to_string(rest) + " bytes of chunk header", "8 (truncated file?)"};
    const std::uint64_t length = word_at(glb, offset);
    const std::uint64_t available = rest - k_chunk_header_bytes;
    if (length > available)
        throw Error{file, element + ".length", std::to_string(length) + " bytes",
                    "at most the " + std::to_string(available) + " that follow (truncated file?)"};
    const std::uint64_t begin = offset + k_chunk_header_bytes;
    return {word_at(glb, offset + 4), glb.subspan(begin, length), begin + length};
}

Container split_glb(const std::string& file, std::span<const unsigned char> bytes) {
    constexpr std::uint64_t k_least = k_header_bytes + k_chunk_header_bytes;
    const std::uint32_t version = bytes.size() < 8 ? 2 : word_at(bytes, 4);
    if (version != 2) throw Error{file, "header.version", "GLB version " + std::to_string(version), "2"};
    if (bytes.size() < k_least)
        throw Error{file, "header", "a file of " + std::to_string(bytes.size()) + " bytes",
                    "at least 20 (truncated file?)"};
    const std::uint64_t length = word_at(bytes, 8);
    if (length > bytes.size() || length < k_least)
        throw Error{file, "header.length", std::to_string(length) + " bytes",
                    "20 to " + std::to_string(bytes.size()) + ", the size of the file (truncated file?)"};
    const auto glb = bytes.first(length);

    const Chunk json = chunk_at(file, glb, k_header_bytes, 0);
    if (json.type != k_json_chunk || json.data.empty())
        throw Error{file, "chunk[0]", json.data.empty() ? "an empty chunk" : "another chunk type", "JSON"};
    Container container{.json = as_text(json.data), .binary = {}, .plain_glb = {}};
    if (json.end < length) {
        // Only the second chunk may be the binary one; chunks of unknown types are skipped as the format
        // asks.
        const Chunk second = chunk_at(file, glb, json.end, 1);
        if (second.type == k_binary_chunk) container.binary = second.data;
        const bool padded = json.end % 4 == 0 && second.end % 4 == 0;
        if (!container.binary.empty() && second.end == length && padded) container.plain_glb = glb;
    }
    return container;
}

bool named_glb(const std::string& file) {
    std::string extension = std::filesystem::path{file}.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    return extension == ".glb";
}

}  // namespace

Container split_container(const std::string& file, std::span<const unsigned char> bytes) {
    if (bytes.empty()) throw Error{file, "", "an empty file", "glTF 2.0"};
    if (bytes.size() >= 4 && word_at(bytes, 0) == k_magic) return split_glb(file, bytes);
    if (named_glb(file)) throw Error{file, "header.magic", "other bytes", "\"glTF\": this is not a GLB file"};
    return {.json = as_text(bytes), .binary = {}, .plain_glb = {}};
}

std::vector<unsigned char> join_container(std::string_view json, std::span<const unsigned char> binary) {
    const std::size_t json_padding = (4 - json.size() % 4) % 4;
    const std::size_t binary_padding = (4 - binary.size() % 4) % 4;
    const std::size_t json_bytes = json.size() + json_padding;
    const std::size_t binary_bytes = binary.size() + binary_padding;
    std::size_t length = k_header_bytes + k_chunk_header_bytes + json_bytes;
    if (binary_bytes > 0) length += k_chunk_header_bytes + binary_bytes;

    std::vector<unsigned char> glb;
    glb.reserve(length);
    put_word(glb, k_magic);
    put_word(glb, 2);
    put_word(glb, length);
    put_word(glb, json_bytes);
    put_word(glb, k_json_chunk);
    glb.insert(glb.end(), json.begin(), json.end());
    glb.insert(glb.end(), json_padding, ' ');
    if (binary_bytes > 0) {
        put_word(glb, binary_bytes);
        put_word(glb, k_binary_chunk);
        glb.insert(glb.end(), binary.begin(), binary.end());
        glb.insert(glb.end(), binary_padding, 0);
    }
    return glb;
}

}  // namespace rambla::assets::gltf
