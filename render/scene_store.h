#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "assets/processed.h"
#include "assets/texture_levels.h"
#include "render/gl/buffer.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_array.h"
#include "render/texture_residency.h"

namespace rambla::render {

/// Where a mesh lies in the store's buffers.
struct MeshRange {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::int32_t base_vertex = 0;
    assets::Topology topology = assets::Topology::triangles;
};

/// A scene on the GPU: all meshes in one pair of vertex streams (positions apart, so that depth passes read
/// 12 bytes a vertex; a third one for skinned meshes alone) and one index buffer, their shadow meshes beside
/// them, morph targets, textures with mips, materials in one storage buffer. Indices of meshes and materials
/// are those of the scene.
class SceneStore {
public:
    SceneStore();
    ~SceneStore();
    SceneStore(const SceneStore&) = delete;
    SceneStore& operator=(const SceneStore&) = delete;

    /// Replaces everything by the contents of `scene`.
    /// @param source  of the levels of textures that the scene does not hold; none: those do not come
    void upload(const assets::ProcessedScene& scene, std::shared_ptr<assets::LevelSource> source);

    /// Before frame number `frame` is drawn: see TextureResidency. Images that no program of the settings'
    /// grade of detail samples are not demanded.
    void update_textures(std::span<const std::uint8_t> demand, const Settings& settings, std::uint64_t frame);
    /// Likewise, but waits for all that the frame needs. Waits for the graphics card, too.
    void complete_textures(std::span<const std::uint8_t> demand, const Settings& settings,
                           std::uint64_t frame);
    /// Frames below number `finished` are done.
    void release_textures(std::uint64_t finished);
    [[nodiscard]] const TextureResidency& textures() const;

    /// @param index  assets::k_none: a square of half size 1 in the plane z = 0, for what shaders make up
    [[nodiscard]] const MeshRange& mesh(std::uint32_t index) const;
    /// What a mesh of opaque triangles casts that does not deform, of shadow_vertices().
    [[nodiscard]] const MeshRange& shadow_mesh(std::uint32_t index) const;
    [[nodiscard]] std::uint32_t mesh_count() const;
    [[nodiscard]] std::uint32_t material_count() const;  ///< the default material not counted
    [[nodiscard]] const assets::Material& material(
        std::uint32_t index) const;  ///< assets::k_none: glTF's default

    /// The vertex array of all meshes, or of the skinned ones; attributes as shared/bindings.h names them.
    [[nodiscard]] const gl::VertexArray& vertices(bool skinned) const;
    /// The vertex array of all shadow meshes: positions alone.
    [[nodiscard]] const gl::VertexArray& shadow_vertices() const;
    /// See scene_morphs.h.
    [[nodiscard]] gl::BufferRange morphs() const;
    /// Array of shared::Material; the default material lies behind the scene's own, at material_count().
    [[nodiscard]] gl::BufferRange materials() const;
    /// Row of a material in materials().
    [[nodiscard]] std::uint32_t material_row(std::uint32_t material) const;

    /// Binds a material's textures to the units UNIT_BASE_COLOUR … UNIT_TRANSMISSION.
    void bind_textures(std::uint32_t material) const;
    /// Binds the base colour alone: what masked materials need in depth passes.
    void bind_base_colour(std::uint32_t material) const;

private:
    [[nodiscard]] std::span<const std::uint8_t> sampled(std::span<const std::uint8_t> demand,
                                                        DetailGrade grade);
    void rebind_textures();

    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rambla::render
