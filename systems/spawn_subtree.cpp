#include "systems/spawn_subtree.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "systems/frame.h"
#include "systems/position.h"
#include "systems/simulate/transform.h"
#include "systems/simulate/trigonometry.h"

namespace rambla::systems {
namespace {

/// Affine map from a node to the spawn's origin, in double precision: a city is kilometres wide, and what
/// never moves need not be cheap to place.
struct Placement {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation_m{0.0};
};

Placement operator*(const Placement& parent, const assets::Transform& local) {
    const glm::dmat3 rotation = glm::mat3_cast(glm::dquat{renormalised(local.rotation)});
    const glm::dvec3 scale{local.scale};
    const glm::dmat3 linear{rotation[0] * scale.x, rotation[1] * scale.y, rotation[2] * scale.z};
    return {parent.linear * linear, parent.linear * glm::dvec3{local.translation_m} + parent.translation_m};
}

LocalTransform local_of(const assets::Transform& transform) {
    return {transform.translation_m, renormalised(transform.rotation), transform.scale};
}

std::uint32_t pipeline_of(const assets::Material& material, assets::Topology topology) {
    return pack({.double_sided = material.double_sided,
                 .mirrored = false,
                 .alpha = static_cast<std::uint8_t>(material.alpha_mode),
                 .topology = static_cast<std::uint8_t>(topology),
                 .unlit = material.unlit});
}

LocalBounds bounds_of(const assets::Mesh& mesh) {
    assets::Bounds bounds = mesh.bounds;
    if (bounds.empty()) {
        for (const glm::vec3& position : mesh.positions)
            bounds.expand(position);
    }
    return {bounds.centre(), bounds.half_extents()};
}

LocalLight local_light(const assets::Light& light) {
    LocalLight made;
    made.intensity = light.colour * light.intensity;
    const float brightest = std::max({made.intensity.x, made.intensity.y, made.intensity.z, 0.0f});
    const float reach_m = std::min(std::sqrt(brightest / k_light_threshold), k_light_reach_m);
    made.radius_m = light.range_m > 0.0f ? light.range_m : reach_m;
    if (light.kind == assets::LightKind::spot) {
        made.cos_inner = static_cast<float>(cosine(static_cast<double>(light.inner_cone_rad)));
        made.cos_outer = static_cast<float>(cosine(static_cast<double>(light.outer_cone_rad)));
    }
    return made;
}

class Spawner {
public:
    Spawner(ecs::World& world, const assets::Scene& scene, const WorldPosition& origin, Mobility mobility)
        : world_{world}, scene_{scene}, origin_{normalised(origin)}, moving_{mobility == Mobility::moving} {}

    std::vector<SpawnedNode> operator()(std::span<const std::uint32_t> roots) {
        std::vector<Pending> open;
        for (const std::uint32_t root : roots)
            open.push_back({root, {}, {}});
        std::reverse(open.begin(), open.end());
        while (!open.empty()) {
            const Pending pending = open.back();
            open.pop_back();
            const assets::Node& node = scene_.nodes.at(pending.node);
            const Placement placement = pending.parent_placement * node.local;
            const ecs::Entity entity = node_entity(node, pending.parent, placement);
            made_.push_back({pending.node, entity});
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                open.push_back({*child, entity, placement});
            }
        }
        return std::move(made_);
    }

private:
    struct Pending {
        std::uint32_t node;
        ecs::Entity parent;
        Placement parent_placement;
    };

    ecs::Entity node_entity(const assets::Node& node, ecs::Entity parent, const Placement& placement) {
        const WorldTransform transform = world_transform(placement);
        LocalTransform local = local_of(node.local);
        std::vector<assets::ModelPart> parts;
        if (node.model != assets::k_none) parts = drawable_parts(scene_.models.at(node.model));

        std::optional<Cell> cell;
        if (parent == ecs::Entity{}) {
            const WorldPosition place = moved(origin_, glm::dvec3{node.local.translation_m});
            cell = Cell{place.cell};
            local.translation_m = place.local_m;
        }
        const ecs::Entity entity = parts.size() == 1 ? part_entity(parts[0], local, parent, cell, transform)
                                   : cell            ? with_mobility(transform, local, *cell)
                                                     : with_mobility(transform, local, Parent{parent});
        if (parts.size() > 1) {
            for (const assets::ModelPart& part : parts)
                part_entity(part, {}, entity, {}, transform);
        }
        if (node.light != assets::k_none) add_light(entity, scene_.lights.at(node.light), placement);
        return entity;
    }

    /// In the cell in which it lies, so that its coordinates stay small.
    WorldTransform world_transform(const Placement& placement) const {
        const WorldPosition place = moved(origin_, placement.translation_m);
        return {place.cell, glm::mat3{placement.linear}, place.local_m};
    }

    std::vector<assets::ModelPart> drawable_parts(const assets::Model& model) const {
        std::vector<assets::ModelPart> parts;
        for (const assets::ModelPart& part : model.parts) {
            if (part.mesh != assets::k_none && !scene_.meshes.at(part.mesh).positions.empty())
                parts.push_back(part);
        }
        return parts;
    }

    ecs::Entity part_entity(const assets::ModelPart& part, const LocalTransform& local, ecs::Entity parent,
                            const std::optional<Cell>& cell, const WorldTransform& transform) {
        static const assets::Material k_default;
        const assets::Material& material =
            part.material == assets::k_none ? k_default : scene_.materials.at(part.material);
        const assets::Mesh& mesh = scene_.meshes.at(part.mesh);
        const Renderable renderable{part.mesh, part.material, pipeline_of(material, mesh.topology)};
        const LocalBounds bounds = bounds_of(mesh);
        const bool casts =
            material.alpha_mode != assets::AlphaMode::blend && mesh.topology == assets::Topology::triangles;
        if (cell && casts) return with_mobility(transform, local, renderable, bounds, *cell);
        if (cell) return with_mobility(transform, local, renderable, bounds, *cell, NoShadow{});
        if (casts) return with_mobility(transform, local, renderable, bounds, Parent{parent});
        return with_mobility(transform, local, renderable, bounds, Parent{parent}, NoShadow{});
    }

    template <class... Cs>
    ecs::Entity with_mobility(const WorldTransform& transform, Cs... components) {
        if (moving_) return world_.create(transform, PreviousWorldTransform{transform}, components...);
        return world_.create(transform, components...);
    }

    void add_light(ecs::Entity entity, const assets::Light& light, const Placement& placement) {
        if (light.kind != assets::LightKind::directional) {
            world_.add(entity, local_light(light));
            return;
        }
        if (sun_found_) {
            spdlog::warn("scene '{}': directional light '{}' is left out: the sun is another one",
                         scene_.name, light.name);
            return;
        }
        const glm::dvec3 to_sun = placement.linear[2];
        const double size = std::sqrt(glm::dot(to_sun, to_sun));
        if (!(size > 0.0)) return;
        sun_found_ = true;
        if (!world_.has_resource<Sunlight>()) world_.set_resource(Sunlight{assets::noon()});
        assets::Environment& environment = world_.resource<Sunlight>().environment;
        environment.direction_to_sun = glm::vec3{to_sun / size};
        environment.sun_illuminance = light.colour * light.intensity;
    }

    ecs::World& world_;
    const assets::Scene& scene_;
    WorldPosition origin_;
    bool moving_;
    bool sun_found_ = false;
    std::vector<SpawnedNode> made_;
};

}  // namespace

std::vector<SpawnedNode> spawn_subtrees(ecs::World& world, const assets::Scene& scene,
                                        std::span<const std::uint32_t> roots, const WorldPosition& origin,
                                        Mobility mobility) {
    return Spawner{world, scene, origin, mobility}(roots);
}

void note_materials(ecs::World& world, const assets::Scene& scene) {
    MaterialFacts facts;
    for (const assets::Material& material : scene.materials) {
        const glm::vec3 e = material.emissive;
        facts.shines.push_back(material.unlit || e.x > 0.0f || e.y > 0.0f || e.z > 0.0f ? 1 : 0);
    }
    world.set_resource(std::move(facts));
}

}  // namespace rambla::systems
