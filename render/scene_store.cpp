#include "render/scene_store.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "assets/assert.h"
#include "render/gl/calls.h"
#include "render/passes/surface_detail.h"
#include "render/scene_materials.h"
#include "render/scene_meshes.h"
#include "render/scene_morphs.h"
#include "render/scene_shadows.h"
#include "render/scene_textures.h"
#include "render/shaders/shared/bindings.h"
#include "systems/frame.h"

namespace rambla::render {

struct SceneStore::State {
    SceneMeshes meshes;
    SceneShadows shadows;
    gl::Buffer morphs;
    SceneTextures textures;
    SceneMaterials materials;
    std::vector<std::uint8_t> demand;  ///< scratch
};

SceneStore::SceneStore() : state_{std::make_unique<State>()} {
    upload({}, nullptr);
}
SceneStore::~SceneStore() = default;

void SceneStore::upload(const assets::ProcessedScene& scene, std::shared_ptr<assets::LevelSource> source) {
    // The old scene goes first: two large scenes need not fit beside each other.
    state_ = std::make_unique<State>();
    state_->meshes = upload_meshes(scene.meshes);
    state_->shadows = upload_shadows(scene.meshes);
    const std::vector<std::uint32_t> morphs = pack_morphs(scene.meshes, state_->meshes.ranges);
    if (!morphs.empty())
        state_->morphs = gl::Buffer{"morphs", morphs.size() * sizeof(std::uint32_t), morphs.data()};
    state_->textures = upload_textures(scene, std::move(source));
    state_->materials = upload_materials(scene, state_->textures);
}

std::span<const std::uint8_t> SceneStore::sampled(std::span<const std::uint8_t> demand, DetailGrade grade) {
    state_->demand.assign(demand.begin(), demand.end());
    const std::uint32_t units = sampled_units(grade);
    for (std::size_t image = 0; image < demand.size(); ++image) {
        const std::vector<SlotOfImage>& slots = state_->materials.slots_of_images[image];
        const auto is_sampled = [&](const SlotOfImage& slot) {
            return (units >> slot.unit & 1u) != 0u;
        };
        if (!slots.empty() && std::none_of(slots.begin(), slots.end(), is_sampled))
            state_->demand[image] = systems::k_not_demanded;
    }
    return state_->demand;
}

void SceneStore::update_textures(std::span<const std::uint8_t> demand, const Settings& settings,
                                 std::uint64_t frame) {
    state_->textures.images->begin_frame(frame);
    state_->textures.images->update(sampled(demand, settings.detail.grade), settings.textures);
    rebind_textures();
}

void SceneStore::complete_textures(std::span<const std::uint8_t> demand, const Settings& settings,
                                   std::uint64_t frame) {
    const gl::UncountedCalls waits_by_its_nature;
    TextureResidency& images = *state_->textures.images;
    images.begin_frame(frame);
    images.complete(sampled(demand, settings.detail.grade), settings.textures, [&images] {
        glFinish();
        images.release(std::numeric_limits<std::uint64_t>::max());
    });
    rebind_textures();
}

void SceneStore::release_textures(std::uint64_t finished) {
    state_->textures.images->release(finished);
}

const TextureResidency& SceneStore::textures() const {
    return *state_->textures.images;
}

void SceneStore::rebind_textures() {
    const TextureResidency& images = *state_->textures.images;
    for (const std::uint32_t image : images.changed())
        rebind_image(state_->materials, image, images.name(image));
}

const MeshRange& SceneStore::mesh(std::uint32_t index) const {
    if (index == assets::k_none) return state_->meshes.quad;
    RAMBLA_ASSERT(index < state_->meshes.ranges.size(), "Frames use the uploaded scene's indices");
    return state_->meshes.ranges[index];
}

const MeshRange& SceneStore::shadow_mesh(std::uint32_t index) const {
    RAMBLA_ASSERT(index < state_->shadows.ranges.size(), "Frames use the uploaded scene's indices");
    return state_->shadows.ranges[index];
}

std::uint32_t SceneStore::mesh_count() const {
    return static_cast<std::uint32_t>(state_->meshes.ranges.size());
}

std::uint32_t SceneStore::material_count() const {
    return static_cast<std::uint32_t>(state_->materials.materials.size() - 1);
}

std::uint32_t SceneStore::material_row(std::uint32_t material) const {
    return std::min(material, material_count());
}

const assets::Material& SceneStore::material(std::uint32_t index) const {
    return state_->materials.materials[material_row(index)];
}

const gl::VertexArray& SceneStore::vertices(bool skinned) const {
    return skinned ? state_->meshes.skinned_vertices : state_->meshes.vertices;
}

gl::BufferRange SceneStore::morphs() const {
    return state_->morphs.range();
}

const gl::VertexArray& SceneStore::shadow_vertices() const {
    return state_->shadows.vertices;
}

gl::BufferRange SceneStore::materials() const {
    return state_->materials.buffer.range();
}

void SceneStore::bind_textures(std::uint32_t material) const {
    const auto& slots = state_->materials.slots[material_row(material)];
    glBindTextures(UNIT_BASE_COLOUR, static_cast<GLsizei>(slots.textures.size()), slots.textures.data());
    glBindSamplers(UNIT_BASE_COLOUR, static_cast<GLsizei>(slots.samplers.size()), slots.samplers.data());
}

void SceneStore::bind_base_colour(std::uint32_t material) const {
    const auto& slots = state_->materials.slots[material_row(material)];
    glBindTextureUnit(UNIT_BASE_COLOUR, slots.textures[UNIT_BASE_COLOUR]);
    glBindSampler(UNIT_BASE_COLOUR, slots.samplers[UNIT_BASE_COLOUR]);
}

}  // namespace rambla::render
