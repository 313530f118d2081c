#include "game/study/frame_tracer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "assets/process/texture.h"
#include "assets/process/texture_plan.h"
#include "game/study/deformed_mesh.h"

namespace rambla::game::study {

struct FrameTracer::Meshes {
    std::vector<std::unique_ptr<const DeformedMesh>> list;
};

namespace {

glm::mat4x3 world_from_local(const systems::Instance& instance) {
    const glm::mat3x4 rows{instance.row0, instance.row1, instance.row2};
    return glm::transpose(rows);
}

bool mirrors(const glm::mat4x3& map) {
    const glm::dvec3 x{map[0]}, y{map[1]}, z{map[2]};
    return glm::dot(glm::cross(x, y), z) < 0.0;
}

/// Fills a TraceScene from a Frame.
class Builder {
public:
    Builder(const systems::Frame& frame, const assets::Scene& scene, const assets::ProcessedScene& processed,
            std::vector<std::unique_ptr<const DeformedMesh>>& deformed)
        : frame_{frame},
          scene_{scene},
          processed_{processed},
          deformed_{deformed},
          targets_{morph_targets(processed)},
          traced_(frame.instances.size(), assets::k_none) {
        for (const assets::ProcessedMesh& mesh : processed.meshes)
            out_.meshes.push_back(assets::trace_mesh(mesh.mesh));
    }

    assets::TraceScene build() {
        for (const systems::DrawBatch& batch : frame_.opaque) {
            for (std::uint32_t i = 0; i < batch.instance_count; ++i) {
                add(batch.first_instance + i, batch.pipeline, batch.material, batch.mesh,
                    assets::k_rays_of_sight);
            }
        }
        const systems::CasterColumns& casters = frame_.casters;
        for (std::size_t row = 0; row < casters.size(); ++row) {
            add(casters.instance[row], casters.pipeline[row], casters.material[row], casters.mesh[row],
                assets::k_rays_of_light);
        }
        return std::move(out_);
    }

private:
    void add(std::uint32_t instance, std::uint32_t pipeline_bits, std::uint32_t material, std::uint32_t mesh,
             std::uint32_t rays) {
        const systems::Pipeline pipeline = systems::unpack_pipeline(pipeline_bits);
        if (pipeline.topology != static_cast<std::uint8_t>(assets::Topology::triangles)) return;
        if (traced_[instance] != assets::k_none) {
            out_.instances[traced_[instance]].rays |= rays;
            return;
        }
        traced_[instance] = static_cast<std::uint32_t>(out_.instances.size());
        const systems::Instance& drawn = frame_.instances[instance];
        const bool placed = pipeline.skinned;  // by its joints
        const glm::mat4x3 map = placed ? glm::mat4x3{1.0f} : world_from_local(drawn);
        out_.instances.push_back({.mesh = mesh_of(mesh, drawn, pipeline),
                                  .material = material_of(material, pipeline),
                                  .object = drawn.object,
                                  .rays = rays,
                                  .world_from_local = map,
                                  .clockwise = pipeline.mirrored != mirrors(map)});
    }

    std::uint32_t mesh_of(std::uint32_t mesh, const systems::Instance& instance, systems::Pipeline pipeline) {
        if (!pipeline.skinned && !pipeline.morphed) return mesh;
        deformed_.push_back(std::make_unique<const DeformedMesh>(
            deformed(processed_.meshes[mesh].mesh, instance, pipeline, frame_, targets_)));
        assets::TraceMesh traced = out_.meshes[mesh];
        traced.positions = deformed_.back()->positions;
        traced.normals = deformed_.back()->normals;
        out_.meshes.push_back(traced);
        return static_cast<std::uint32_t>(out_.meshes.size() - 1);
    }

    std::uint32_t material_of(std::uint32_t material, systems::Pipeline pipeline) {
        const bool masked = pipeline.alpha == static_cast<std::uint8_t>(assets::AlphaMode::mask);
        const std::uint32_t row = std::min(material, static_cast<std::uint32_t>(processed_.materials.size()));
        const auto [place, is_new] =
            materials_.try_emplace(std::tuple{masked ? row : assets::k_none, pipeline.double_sided, masked},
                                   static_cast<std::uint32_t>(out_.materials.size()));
        if (is_new) {
            const assets::Material look =
                row < processed_.materials.size() ? processed_.materials[row] : assets::Material{};
            out_.materials.push_back(
                {.double_sided = pipeline.double_sided,
                 .masked = masked,
                 .cutoff = look.alpha_cutoff,
                 .alpha = look.base_colour.w,
                 .texture = masked ? texture_of(look.base_colour_texture) : assets::k_none,
                 .slot = look.base_colour_texture});
        }
        return place->second;
    }

    std::uint32_t texture_of(const assets::TextureSlot& slot) {
        if (slot.texture >= processed_.textures.size()) return assets::k_none;
        const auto [place, is_new] =
            textures_.try_emplace(slot.texture, static_cast<std::uint32_t>(out_.textures.size()));
        if (is_new) {
            const assets::Texture& texture = processed_.textures[slot.texture];
            const assets::TextureData& kept = processed_.images[texture.image];
            out_.textures.push_back(assets::alpha_texture(
                kept.first_stored == 0 ? kept : made_anew(texture.image), texture.sampler));
        }
        return place->second;
    }

    assets::TextureData made_anew(std::uint32_t image) {
        if (!plan_) plan_ = assets::plan_textures(scene_);
        return assets::process_texture(plan_->jobs[image], plan_->channels[image], scene_.images,
                                       {.compression = assets::Compression::off});
    }

    const systems::Frame& frame_;
    const assets::Scene& scene_;
    const assets::ProcessedScene& processed_;
    std::vector<std::unique_ptr<const DeformedMesh>>& deformed_;
    std::vector<const assets::MorphTarget*> targets_;
    std::vector<std::uint32_t> traced_;  ///< by instance of the Frame: its number in `out_`
    /// By material, double-sided, masked.
    std::map<std::tuple<std::uint32_t, bool, bool>, std::uint32_t> materials_;
    std::map<std::uint32_t, std::uint32_t> textures_;
    std::optional<assets::TexturePlan> plan_;
    assets::TraceScene out_;
};

}  // namespace

FrameTracer::FrameTracer(const systems::Frame& frame, const assets::Scene& scene,
                         const assets::ProcessedScene& processed)
    : camera_{.view_from_world = frame.view.view_from_world,
              .clip_from_view = frame.view.clip_from_view,
              .size_px = frame.view.size_px,
              .orthographic = frame.view.orthographic} {
    auto meshes = std::make_unique<Meshes>();
    tracer_ = std::make_unique<const assets::Tracer>(Builder{frame, scene, processed, meshes->list}.build());
    deformed_ = std::move(meshes);
}

FrameTracer::~FrameTracer() = default;

std::vector<std::uint32_t> object_ids(const assets::HitPicture& picture) {
    std::vector<std::uint32_t> ids;
    ids.reserve(picture.hits.size());
    for (const assets::TraceHit& hit : picture.hits)
        ids.push_back(hit.object);
    return ids;
}

}  // namespace rambla::game::study
