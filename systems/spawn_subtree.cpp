#include "systems/spawn_subtree.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "systems/frame.h"
#include "systems/pack/particles.h"
#include "systems/position.h"
#include "systems/simulate/clip_library.h"
#include "systems/simulate/transform.h"
#include "systems/simulate/trigonometry.h"
#include "systems/spawn_skins.h"

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
    Spawner(ecs::World& world, const assets::Scene& scene, const WorldPosition& origin, Mobility mobility,
            const std::optional<NearFade>& near_fade)
        : world_{world},
          scene_{scene},
          library_{world.resource<ClipLibrary>()},
          origin_{normalised(origin)},
          moving_{mobility == Mobility::moving},
          near_fade_{near_fade} {}

    SpawnedSubtrees operator()(std::span<const std::uint32_t> roots) {
        made_.stand = stand_for(roots);
        std::vector<Pending> open;
        for (const std::uint32_t root : roots)
            open.push_back({root, made_.stand, {}, moving_});
        std::reverse(open.begin(), open.end());
        while (!open.empty()) {
            const Pending pending = open.back();
            open.pop_back();
            const assets::Node& node = scene_.nodes[pending.node];
            const Placement placement = pending.parent_placement * node.local;
            const bool moving = pending.parent_moves || library_.moves(pending.node);
            const ecs::Entity entity = node_entity(pending.node, pending.parent, placement, moving);
            made_.nodes.push_back({pending.node, entity});
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                open.push_back({*child, entity, placement, moving});
            }
        }
        SkinSpawner skins{world_, scene_, made_};
        for (const SkinnedPart& part : skinned_parts_) {
            const ecs::Entity shown = skins.add(part);
            if (near_fade_) world_.add(shown, *near_fade_);
        }
        return std::move(made_);
    }

private:
    struct Pending {
        std::uint32_t node;
        ecs::Entity parent;
        Placement parent_placement;
        bool parent_moves;
    };

    /// The entity above the roots, if any of what lies under them is animated or skinned.
    ecs::Entity stand_for(std::span<const std::uint32_t> roots) {
        bool plays = false;
        bool skins = false;
        std::vector<std::uint32_t> open{roots.begin(), roots.end()};
        while (!open.empty()) {
            const std::uint32_t index = open.back();
            open.pop_back();
            const assets::Node& node = scene_.nodes.at(index);
            plays = plays || library_.moves(index) || library_.morphs(index);
            skins = skins || node.skeleton != assets::k_none;
            open.insert(open.end(), node.children.begin(), node.children.end());
        }
        if (!plays && !skins) return {};
        const LocalTransform local{origin_.local_m, {1.0f, 0.0f, 0.0f, 0.0f}, glm::vec3{1.0f}};
        const WorldTransform transform{origin_.cell, glm::mat3{1.0f}, origin_.local_m};
        const ecs::Entity stand = with_mobility(moving_, transform, local, Cell{origin_.cell});
        if (plays) world_.add(stand, AnimationPlayer{});
        return stand;
    }

    ecs::Entity node_entity(std::uint32_t index, ecs::Entity parent, const Placement& placement,
                            bool moving) {
        const assets::Node& node = scene_.nodes[index];
        const WorldTransform transform = world_transform(placement);
        LocalTransform local = local_of(node.local);
        std::vector<assets::ModelPart> skinned;
        std::vector<assets::ModelPart> parts;
        for (const assets::ModelPart& part : drawable_parts(node))
            (is_skinned(node, part) ? skinned : parts).push_back(part);

        std::optional<Cell> cell;
        if (parent == ecs::Entity{}) {
            const WorldPosition place = moved(origin_, glm::dvec3{node.local.translation_m});
            cell = Cell{place.cell};
            local.translation_m = place.local_m;
        }
        const bool alone = parts.size() == 1 && skinned.empty();
        const ecs::Entity entity = alone  ? part_entity(parts[0], local, parent, cell, transform, moving)
                                   : cell ? with_mobility(moving, transform, local, *cell)
                                          : with_mobility(moving, transform, local, Parent{parent});
        if (library_.moves(index)) world_.add(entity, AnimatedNode{made_.stand, index, local, {}});
        const ecs::Entity morph = add_morph(entity, index);
        if (alone) {
            if (is_morphed(parts[0])) world_.add(entity, Morphed{morph});
        } else {
            for (const assets::ModelPart& part : parts) {
                const ecs::Entity shown = part_entity(part, {}, entity, {}, transform, moving);
                if (is_morphed(part)) world_.add(shown, Morphed{morph});
            }
        }
        for (const assets::ModelPart& part : skinned)
            skinned_parts_.push_back({part, node.skeleton, entity, is_morphed(part) ? morph : ecs::Entity{}});
        if (node.emitter != assets::k_none)
            add_source(scene_.emitters.at(node.emitter), entity, transform, moving);
        if (node.light != assets::k_none) add_light(entity, scene_.lights.at(node.light), placement);
        return entity;
    }

    [[nodiscard]] const assets::Mesh& mesh_of(const assets::ModelPart& part) const {
        return scene_.meshes.at(part.mesh);
    }
    [[nodiscard]] bool is_morphed(const assets::ModelPart& part) const {
        return !mesh_of(part).morphs.empty();
    }
    /// A mesh that names joints which the skeleton lacks is drawn where its node is.
    [[nodiscard]] bool is_skinned(const assets::Node& node, const assets::ModelPart& part) const {
        if (node.skeleton == assets::k_none || mesh_of(part).weights.empty()) return false;
        const std::vector<JointBox>& used = library_.mesh(part.mesh).joint_boxes;
        const std::size_t joints = scene_.skeletons.at(node.skeleton).joints.size();
        if (!used.empty() && used.back().joint < joints) return true;
        spdlog::warn("scene '{}': mesh '{}' stays rigid: it wants joint {} of {} in skeleton '{}'",
                     scene_.name, mesh_of(part).name, used.empty() ? 0 : used.back().joint, joints,
                     scene_.skeletons[node.skeleton].name);
        return false;
    }

    /// The weights of a node's morph targets. @return  who holds them; null if it has none
    ecs::Entity add_morph(ecs::Entity entity, std::uint32_t index) {
        const assets::Node& node = scene_.nodes[index];
        std::size_t targets = 0;
        for (const assets::ModelPart& part : drawable_parts(node))
            targets = std::max(targets, mesh_of(part).morphs.size());
        if (targets == 0) return {};
        const auto count = static_cast<std::uint32_t>(targets);
        const std::vector<float>& given =
            node.morph_weights.empty() ? scene_.models[node.model].morph_weights : node.morph_weights;
        const ecs::Entity player = library_.morphs(index) ? made_.stand : ecs::Entity{};
        world_.add(entity, Morph{count});
        for (std::uint32_t i = 0; i < count; ++i) {
            const float rest = i < given.size() ? given[i] : 0.0f;
            world_.create(MorphWeight{entity, player, index, i, rest, rest, rest, {}}, Parent{entity});
        }
        return entity;
    }

    /// In the cell in which it lies, so that its coordinates stay small.
    WorldTransform world_transform(const Placement& placement) const {
        const WorldPosition place = moved(origin_, placement.translation_m);
        return {place.cell, glm::mat3{placement.linear}, place.local_m};
    }

    [[nodiscard]] std::vector<assets::ModelPart> drawable_parts(const assets::Node& node) const {
        std::vector<assets::ModelPart> parts;
        if (node.model == assets::k_none) return parts;
        for (const assets::ModelPart& part : scene_.models.at(node.model).parts) {
            if (part.mesh != assets::k_none && !scene_.meshes.at(part.mesh).positions.empty())
                parts.push_back(part);
        }
        return parts;
    }

    ecs::Entity part_entity(const assets::ModelPart& part, const LocalTransform& local, ecs::Entity parent,
                            const std::optional<Cell>& cell, const WorldTransform& transform, bool moving) {
        const Renderable renderable = renderable_of(scene_, part, false);
        const LocalBounds bounds = bounds_of(mesh_of(part));
        const ecs::Entity entity =
            cell ? with_mobility(moving, transform, local, renderable, bounds, *cell)
                 : with_mobility(moving, transform, local, renderable, bounds, Parent{parent});
        if (!casts_shadows(scene_, part)) world_.add(entity, NoShadow{});
        if (near_fade_) world_.add(entity, *near_fade_);
        return entity;
    }

    template <class... Cs>
    ecs::Entity with_mobility(bool moving, const WorldTransform& transform, Cs... components) {
        if (moving) return world_.create(transform, PreviousWorldTransform{transform}, components...);
        return world_.create(transform, components...);
    }

    /// In an entity of its own: the node may show a model as well.
    void add_source(const assets::Emitter& emitter, ecs::Entity parent, const WorldTransform& transform,
                    bool moving) {
        const bool unlit = emitter.material != assets::k_none && scene_.materials.at(emitter.material).unlit;
        const Pipeline pipeline{
            .alpha = static_cast<std::uint8_t>(assets::AlphaMode::blend), .unlit = unlit, .haze = true};
        const Renderable renderable{assets::k_none, emitter.material, pack(pipeline)};
        ParticleSource source{emitter.count,          emitter.lifetime_s,          emitter.spread_m,
                              emitter.velocity_m_s,   emitter.velocity_spread_m_s, emitter.acceleration_m_s2,
                              emitter.start_radius_m, emitter.end_radius_m,        parent.index};
        const LocalBounds bounds = particle_bounds(source);
        with_mobility(moving, transform, LocalTransform{}, renderable, bounds, source, Parent{parent},
                      NoShadow{});
    }

    void add_light(ecs::Entity entity, const assets::Light& light, const Placement& placement) {
        if (light.kind != assets::LightKind::directional) {
            world_.add(entity, local_light(light));
            return;
        }
        if (sun_found_) {
            world_.add(entity, DirectionalLight{light.colour * light.intensity});
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
    const ClipLibrary& library_;
    WorldPosition origin_;
    bool moving_;
    std::optional<NearFade> near_fade_;
    bool sun_found_ = false;
    SpawnedSubtrees made_;
    std::vector<SkinnedPart> skinned_parts_;
};

}  // namespace

SpawnedSubtrees spawn_subtrees(ecs::World& world, const assets::Scene& scene,
                               std::span<const std::uint32_t> roots, const WorldPosition& origin,
                               Mobility mobility, const std::optional<NearFade>& near_fade) {
    if (!world.has_resource<ClipLibrary>()) note_clips(world, scene);
    return Spawner{world, scene, origin, mobility, near_fade}(roots);
}

void note_clips(ecs::World& world, const assets::Scene& scene) {
    world.set_resource(ClipLibrary{scene});
}

void note_materials(ecs::World& world, const assets::Scene& scene) {
    MaterialFacts facts;
    for (const assets::Material& material : scene.materials) {
        const glm::vec3 e = material.emissive;
        const bool emits = e.x > 0.0f || e.y > 0.0f || e.z > 0.0f;
        facts.needs_emission.push_back(material.unlit || emits || assets::is_light_mapped(material) ? 1 : 0);
    }
    world.set_resource(std::move(facts));
}

}  // namespace rambla::systems
