#include "render/scene_morphs.h"

#include <bit>
#include <cstring>

#include "render/shaders/shared/deformation.h"

namespace rambla::render {
namespace {

/// Appends a column and returns where vertex 0 of the whole buffer would find its words.
std::uint32_t add_column(std::vector<std::uint32_t>& words, std::span<const glm::vec3> column,
                         std::int32_t base_vertex) {
    const auto first = static_cast<std::uint32_t>(words.size());
    for (const glm::vec3& delta : column) {
        for (int axis = 0; axis < 3; ++axis)
            words.push_back(std::bit_cast<std::uint32_t>(delta[axis]));
    }
    return first - 3u * static_cast<std::uint32_t>(base_vertex);
}

}  // namespace

std::vector<std::uint32_t> pack_morphs(std::span<const assets::ProcessedMesh> meshes,
                                       std::span<const MeshRange> ranges) {
    std::size_t targets = 0;
    for (const assets::ProcessedMesh& processed : meshes)
        targets += processed.mesh.morphs.size();
    std::vector<std::uint32_t> words(targets * shared::k_morph_target_words);
    std::size_t place = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        for (const assets::MorphTarget& morph : meshes[m].mesh.morphs) {
            shared::MorphTarget target{0, 0, 0, 0};
            const auto add = [&](std::span<const glm::vec3> column, shared::uint flag, shared::uint& first) {
                if (column.empty()) return;
                target.columns |= flag;
                first = add_column(words, column, ranges[m].base_vertex);
            };
            add(morph.positions, shared::k_morph_positions, target.positions);
            add(morph.normals, shared::k_morph_normals, target.normals);
            add(morph.tangents, shared::k_morph_tangents, target.tangents);
            std::memcpy(&words[place], &target, sizeof(target));
            place += shared::k_morph_target_words;
        }
    }
    return words;
}

}  // namespace rambla::render
