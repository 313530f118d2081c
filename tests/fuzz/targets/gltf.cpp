#include <algorithm>
#include <string>
#include <string_view>

#include "assets/export/image.h"
#include "fuzz/gltf_seeds.h"
#include "fuzz/import_check.h"
#include "fuzz/scratch.h"
#include "fuzz/target.h"

namespace rambla::fuzz {
namespace {

constexpr std::string_view k_separator = "\n%%%%\n";
constexpr std::size_t k_most_parts = 4;

/// The input is a .gltf and the files that lie beside it, named 1, 2, 3 in their order, with separators
/// between.
void run(Bytes bytes) {
    std::string_view rest{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    for (std::size_t part = 0; part < k_most_parts; ++part) {
        const std::size_t end =
            part + 1 < k_most_parts ? std::min(rest.find(k_separator), rest.size()) : rest.size();
        const std::string name = part == 0 ? "input.gltf" : std::to_string(part);
        if (part > 0 && rest.empty())
            std::filesystem::remove(scratch_folder() / name);
        else
            write_scratch(name, std::as_bytes(std::span{rest.substr(0, end)}));
        rest.remove_prefix(std::min(end + k_separator.size(), rest.size()));
    }
    check_import(scratch_folder() / "input.gltf");
}

void seeds(const SeedTaker& take) {
    for (const GltfSeed& seed : gltf_seeds()) {
        std::string json = seed.json;
        const std::size_t buffer = json.find("\"byteLength\"", json.find("\"buffers\""));
        const std::string text = json.insert(buffer, R"("uri":"1",)").append(k_separator).append(seed.buffer);
        take(seed.name + ".txt", std::as_bytes(std::span{text}));
    }
    const std::vector<std::byte> picture = assets::encode_png(
        {.name = "p", .width = 2, .height = 1, .texels = std::vector<std::byte>(8, std::byte{99})});
    std::string text =
        R"({"asset":{"version":"2.0"},"images":[{"uri":"1"},{"uri":"2"},{"uri":"data:image/png;base64,AAAA"}],
"samplers":[{"minFilter":9984,"wrapS":33071}],"textures":[{"source":0,"sampler":0},{"source":1},{"source":2}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":1},
"emissiveTexture":{"index":2,"texCoord":1}}]})";
    text.append(k_separator).append(reinterpret_cast<const char*>(picture.data()), picture.size());
    take("pictures.txt", std::as_bytes(std::span{text}));
}

const Registration k_gltf{{"gltf", run, seeds}};

}  // namespace
}  // namespace rambla::fuzz
