#include "systems/looking.h"

#include <array>
#include <span>

#include "systems/components.h"
#include "systems/look/culling.h"
#include "systems/look/lights.h"
#include "systems/look/texture_demand.h"
#include "systems/pack/queue.h"

namespace rambla::systems {
namespace {

void cull_all(ecs::World& world, ecs::Res<Look> look, ecs::ResMut<Culling> culling) {
    const std::array volumes{look->camera, look->casters};
    (*culling)(world, look->observer, std::span{volumes}.first(look->shadows ? 2 : 1));
}

/// With what it keeps between Frames.
struct FindLights {
    LightSearch search;
    DirectionalLightSearch search_directional;

    void operator()(ecs::World& world, ecs::Res<Look> look, ecs::ResMut<FrameUnderWork> work) {
        Frame& frame = *work->frame;
        frame.counts.lights = search(world, look->observer, look->camera, frame.lights) +
                              search_directional(world, look->observer, frame.directional_lights);
        frame.counts.visible_lights =
            static_cast<std::uint32_t>(frame.lights.size() + frame.directional_lights.size());
    }
};

struct Pack {
    PackQueues queues;

    void operator()(ecs::Res<Culling> culling, ecs::Res<Look> look, ecs::Res<MaterialFacts> facts,
                    ecs::Res<Deformations> poses, ecs::Res<ClipLibrary> library,
                    ecs::ResMut<FrameUnderWork> work) {
        Frame& frame = *work->frame;
        queues(*culling, look->observer, look->forward, *facts, {*poses, *library}, frame);
        frame.counts.renderables = static_cast<std::uint32_t>(culling->seen_by().size());
        frame.counts.broken_bounds = culling->broken_bounds();
    }
};

struct DemandTextures {
    TextureDemand demand;

    void operator()(ecs::Res<Culling> culling, ecs::Res<TextureUses> uses, ecs::Res<Deformations> poses,
                    ecs::ResMut<FrameUnderWork> work) {
        demand(*culling, *uses, *poses, *work->frame);
    }
};

}  // namespace

Looking make_looking() {
    Looking looking{std::make_unique<ecs::Schedule>()};
    ecs::Schedule& schedule = *looking.schedule;
    schedule.add("culling", cull_all)
        .reads<WorldTransform, PreviousWorldTransform, Renderable, LocalBounds, Skinned, Morphed, Opacity,
               NearFade, ParticleSource>();
    schedule.add("lights", FindLights{})
        .reads<WorldTransform, PreviousWorldTransform, LocalLight, DirectionalLight>();
    schedule.add("packing", Pack{})
        .after("culling")
        .after("lights")
        .reads<WorldTransform, PreviousWorldTransform, Renderable, Skinned, Morphed, Opacity, NearFade,
               ParticleSource>();  // through what culling found
    schedule.add("texture demand", DemandTextures{})
        .after("packing")
        .reads<WorldTransform, PreviousWorldTransform, Renderable, Skinned, Morphed>();
    return looking;
}

}  // namespace rambla::systems
