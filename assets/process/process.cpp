#include "assets/process/process.h"

#include <tbb/parallel_for.h>

#include "assets/process/bounds.h"
#include "assets/process/optimise.h"
#include "assets/process/shadow_mesh.h"

namespace rambla::assets {

namespace {

Borders borders_of(MeshUse use, BorderLock lock) {
    const bool locked = lock == BorderLock::always || (lock == BorderLock::between_parts && use.meets_others);
    return locked ? Borders::locked : Borders::free;
}

}  // namespace

std::vector<MeshUse> mesh_uses(const Scene& scene) {
    std::vector<MeshUse> uses(scene.meshes.size());
    for (const Model& model : scene.models)
        for (const ModelPart& part : model.parts) {
            if (part.mesh == k_none) continue;
            MeshUse& use = uses[part.mesh];
            use.meets_others = use.meets_others || model.parts.size() > 1;
            if (part.material == k_none) continue;
            const Material& material = scene.materials[part.material];
            use.see_through = use.see_through || drawn_as(material) != AlphaMode::opaque;
        }
    return uses;
}

ProcessedMesh process_mesh(const Mesh& mesh, MeshUse use, const ProcessParameters& parameters) {
    ProcessedMesh out{.mesh = mesh, .lods = {}, .shadow = {}, .sphere = {}, .occluder = {}};
    merge_identical_vertices(out.mesh);
    out.lods = lod_chain(out.mesh, parameters.lods, borders_of(use, parameters.meshes.lock_borders));
    optimise(out.mesh, out.lods, parameters.meshes.overdraw);
    out.mesh.bounds = bounds_of(out.mesh.positions);
    out.shadow = shadow_mesh(out.mesh, out.lods);
    out.sphere = bounding_sphere_of(out.mesh.positions);
    const bool moves = !mesh.joints.empty() || !mesh.morphs.empty();
    if (!moves && !use.see_through) out.occluder = occluder_proxy(out.mesh, parameters.occluders);
    return out;
}

ProcessedScene process(const Scene& scene, const ProcessParameters& parameters) {
    const std::vector<MeshUse> uses = mesh_uses(scene);
    TexturePlan plan = plan_textures(scene);
    ProcessedScene out;
    out.meshes.resize(scene.meshes.size());
    out.images.resize(plan.jobs.size());
    // One job each, textures first: they take longest.
    tbb::parallel_for(std::size_t{0}, out.images.size() + out.meshes.size(), [&](std::size_t i) {
        if (i < out.images.size())
            out.images[i] =
                process_texture(plan.jobs[i], plan.channels[i], scene.images, parameters.textures);
        else
            out.meshes[i - out.images.size()] =
                process_mesh(scene.meshes[i - out.images.size()], uses[i - out.images.size()], parameters);
    });
    out.materials = std::move(plan.materials);
    out.textures = std::move(plan.textures);
    return out;
}

}  // namespace rambla::assets
