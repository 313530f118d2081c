#include "systems/pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstring>
#include <thread>
#include <utility>

#include "support/allocation_counter.h"
#include "systems/pack/queue.h"
#include "systems/position.h"
#include "systems/spawn.h"
#include "unit/systems/random.h"
#include "unit/systems/worlds.h"

namespace rambla::systems {
namespace {

using test::add_node;
using test::box_scene;
using test::small_place;

Eye eye_at(glm::vec3 p) {
    Eye eye;
    eye.place = normalised({{0, 0, 0}, p});
    return eye;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Everything that is drawn, but not where in the world or when.
void expect_same_picture(const Frame& a, const Frame& b) {
    EXPECT_TRUE(same_bytes(a.instances, b.instances));
    EXPECT_TRUE(same_bytes(a.opaque, b.opaque));
    EXPECT_TRUE(same_bytes(a.blended, b.blended));
    EXPECT_TRUE(same_bytes(a.lights, b.lights));
    EXPECT_TRUE(same_bytes(a.casters.instance, b.casters.instance));
    EXPECT_TRUE(same_bytes(a.casters.mesh, b.casters.mesh));
    EXPECT_TRUE(same_bytes(a.casters.centre_x, b.casters.centre_x));
    EXPECT_TRUE(same_bytes(a.casters.centre_z, b.casters.centre_z));
    EXPECT_TRUE(same_bytes(a.casters.half_y, b.casters.half_y));
    EXPECT_EQ(a.needs_emission, b.needs_emission);
    EXPECT_EQ(a.view.view_from_world, b.view.view_from_world);
    EXPECT_EQ(a.view.clip_from_view, b.view.clip_from_view);
}

glm::vec3 place_of(const Instance& instance) {
    return {instance.row0.w, instance.row1.w, instance.row2.w};
}

TEST(BuildFrame, InstancesAreRelativeToTheCamera) {
    assets::Scene scene = box_scene();
    assets::Transform local;
    local.translation_m = {3, 0, -10};
    local.scale = {1, 2, 3};
    scene.nodes[add_node(scene, assets::k_none, local)].model = 0;
    ecs::World world;
    const WorldPosition origin{{400, 0, -4000}, {128, 0, 128}};
    const SpawnedScene spawned = spawn(world, scene, origin);
    Eye eye;
    eye.place = moved(origin, {1.0, 0.5, 0.0});
    Frame frame;
    build_frame(world, eye, 1.0f, frame);
    ASSERT_EQ(frame.instances.size(), 1u);
    EXPECT_EQ(place_of(frame.instances[0]), glm::vec3(2.0f, -0.5f, -10.0f));
    EXPECT_EQ(frame.instances[0].row1.y, 2.0f);
    EXPECT_EQ(frame.instances[0].object, spawned.nodes[0].index);
    EXPECT_EQ(frame.view.eye_cell, origin.cell);
    ASSERT_EQ(frame.casters.size(), 1u);
    EXPECT_NEAR(frame.casters.half_z[0], 1.5f, 1e-3f);
    EXPECT_EQ(frame.casters.instance[0], 0u);
    EXPECT_EQ(frame.counts.renderables, 1u);
    EXPECT_EQ(frame.counts.visible, 1u);
}

TEST(BuildFrame, LooksWhereTheEyeLooks) {
    assets::Scene scene = box_scene();
    assets::Transform local;
    local.translation_m = {10, 0, 0};
    scene.nodes[add_node(scene, assets::k_none, local)].model = 0;
    ecs::World world;
    spawn(world, scene, {});
    Frame frame;
    Eye eye;
    build_frame(world, eye, 1.0f, frame);
    EXPECT_TRUE(frame.opaque.empty());
    eye.rotation = glm::angleAxis(-1.5707963f, glm::vec3{0, 1, 0});  // −Z turned to +X
    build_frame(world, eye, 1.0f, frame);
    EXPECT_EQ(frame.opaque.size(), 1u);
    const glm::vec4 in_view = frame.view.view_from_world * glm::vec4{10, 0, 0, 1};
    EXPECT_NEAR(in_view.z, -10.0f, 1e-5f);
    eye.kind = assets::CameraKind::orthographic;
    eye.far_m = 5.0f;
    build_frame(world, eye, 1.0f, frame);
    EXPECT_TRUE(frame.opaque.empty()) << "behind the far plane";
    EXPECT_TRUE(frame.view.orthographic);
}

TEST(BuildFrame, EqualNeighboursBecomeOneInstancedDraw) {
    assets::Scene scene = box_scene();
    scene.materials.push_back({});
    scene.meshes.push_back(scene.meshes[0]);
    scene.models = {{"a", {{0, 0}}, {}}, {"b", {{0, 1}}, {}}, {"c", {{1, 0}}, {}}};
    for (std::uint32_t i = 0; i < 300; ++i) {
        assets::Transform local;
        local.translation_m = {0, 0, -5.0f - static_cast<float>((i * 37) % 300)};
        if (i % 10 == 0) local.scale.x = -1.0f;
        scene.nodes[add_node(scene, assets::k_none, local)].model = i % 3;
    }
    ecs::World world;
    spawn(world, scene, {});
    Frame frame;
    build_frame(world, Eye{}, 1.0f, frame);
    EXPECT_EQ(frame.instances.size(), 300u) << "casters share the instances of what is visible";
    EXPECT_EQ(frame.opaque.size(), 6u) << "two meshes with one and two materials, plain and mirrored";
    std::uint32_t next = 0;
    std::uint32_t mirrored = 0;
    for (const DrawBatch& batch : frame.opaque) {
        EXPECT_EQ(batch.first_instance, next);
        next += batch.instance_count;
        if (unpack_pipeline(batch.pipeline).mirrored) mirrored += batch.instance_count;
        float depth = 0.0f;
        for (std::uint32_t i = batch.first_instance; i < next; ++i) {
            EXPECT_EQ(frame.instances[i].material, batch.material);
            EXPECT_EQ(frame.instances[i].row0.x < 0.0f, unpack_pipeline(batch.pipeline).mirrored);
            // Front to back, but for the 7 bits of mantissa that the key keeps.
            EXPECT_GE(-frame.instances[i].row2.w, depth * (1.0f - 1.0f / 128.0f));
            depth = std::max(depth, -frame.instances[i].row2.w);
        }
    }
    EXPECT_EQ(next, 300u);
    EXPECT_EQ(mirrored, 30u);
    for (std::size_t i = 1; i < frame.casters.size(); ++i) {
        const bool same_mesh = frame.casters.mesh[i] == frame.casters.mesh[i - 1] &&
                               frame.casters.material[i] == frame.casters.material[i - 1] &&
                               frame.casters.pipeline[i] == frame.casters.pipeline[i - 1];
        if (same_mesh) {
            EXPECT_EQ(frame.casters.instance[i], frame.casters.instance[i - 1] + 1);
        }
    }
}

TEST(BuildFrame, BlendedThingsComeBackToFront) {
    assets::Scene scene = box_scene();
    scene.materials[0].alpha_mode = assets::AlphaMode::blend;
    for (std::uint32_t i = 0; i < 100; ++i) {
        assets::Transform local;
        local.translation_m = {0, 0, -5.0f - 0.001f * static_cast<float>((i * 37) % 100)};
        scene.nodes[add_node(scene, assets::k_none, local)].model = 0;
    }
    ecs::World world;
    spawn(world, scene, {});
    Frame frame;
    build_frame(world, Eye{}, 1.0f, frame);
    EXPECT_TRUE(frame.opaque.empty());
    EXPECT_EQ(frame.casters.size(), 0u);
    ASSERT_EQ(frame.instances.size(), 100u);
    EXPECT_EQ(frame.blended.size(), 1u);
    for (std::size_t i = 1; i < 100; ++i)
        EXPECT_GT(frame.instances[i].row2.w, frame.instances[i - 1].row2.w);
}

TEST(BuildFrame, SaysWhetherSomethingVisibleShines) {
    assets::Scene scene = box_scene();
    scene.materials.emplace_back().emissive = {0, 0, 2};
    scene.models.push_back({"lamp", {{0, 1}}, {}});
    assets::Transform local;
    local.translation_m = {0, 0, -10};
    scene.nodes[add_node(scene, assets::k_none, local)].model = 0;
    local.translation_m = {0, 0, 10};
    scene.nodes[add_node(scene, assets::k_none, local)].model = 1;
    ecs::World world;
    spawn(world, scene, {});
    Frame frame;
    Eye eye;
    build_frame(world, eye, 1.0f, frame);
    EXPECT_FALSE(frame.needs_emission) << "the lamp is behind the camera";
    eye.rotation = glm::angleAxis(3.1415927f, glm::vec3{0, 1, 0});
    build_frame(world, eye, 1.0f, frame);
    EXPECT_TRUE(frame.needs_emission);
}

TEST(BuildFrame, LightMapsNeedWhatEmissionNeeds) {
    assets::Scene scene = box_scene();
    scene.nodes[add_node(scene, assets::k_none, {})].model = 0;
    scene.materials[0].metalness = 0.0f;
    for (const bool mapped : {false, true}) {
        if (mapped) scene.materials[0].light_map_texture.texture = 0;
        ecs::World world;
        spawn(world, scene, {});
        Frame frame;
        build_frame(world, eye_at({0, 0, 10}), 1.0f, frame);
        ASSERT_EQ(frame.opaque.size(), 1u);
        EXPECT_EQ(frame.needs_emission, mapped);
    }
}

TEST(BuildFrame, WithoutSunNothingThrowsShadows) {
    ecs::World world;
    spawn(world, small_place(0, 0), {}, 1);
    Frame frame;
    build_frame(world, eye_at({0, 2, 15}), 1.0f, frame);
    EXPECT_GT(frame.casters.size(), 0u);
    world.resource<Sunlight>().environment.sun_illuminance = glm::vec3{0.0f};
    build_frame(world, eye_at({0, 2, 15}), 1.0f, frame);
    EXPECT_EQ(frame.casters.size(), 0u);
    EXPECT_EQ(frame.counts.lights, 1u);
}

TEST(BuildFrame, TheEndOfOneStepIsTheBeginningOfTheNext) {
    ecs::World world;
    spawn(world, small_place(20, 4), {}, 1);
    for (int i = 0; i < 50; ++i)
        step(world);
    Frame end, begin, middle;
    const Eye eye = eye_at({0, 2, 25});
    build_frame(world, eye, 1.0f, end);
    step(world);
    build_frame(world, eye, 0.0f, begin);
    build_frame(world, eye, 0.5f, middle);
    expect_same_picture(end, begin);
    EXPECT_DOUBLE_EQ(end.time_s, begin.time_s);
    EXPECT_FALSE(same_bytes(begin.instances, middle.instances)) << "walkers move in between";
}

TEST(BuildFrame, ASteadyFrameAllocatesNothing) {
    ecs::World world;
    spawn(world, small_place(60, 8), {}, 1);
    Frame frames[2];
    const Eye eye = eye_at({0, 2, 25});
    for (int i = 0; i < 300; ++i) {
        step(world);
        build_frame(world, eye, 0.5f, frames[i % 2]);
    }
    const std::size_t before = test::allocation_count();
    for (int i = 0; i < 100; ++i) {
        step(world);
        build_frame(world, eye, 0.5f, frames[i % 2]);
    }
    EXPECT_EQ(test::allocation_count(), before);
    EXPECT_GT(frames[0].counts.visible, 50u);
}

TEST(Simulation, GivesTheSameBitsForAnyNumberOfThreads) {
    const auto run = [](std::size_t threads, Frame& frame) {
        const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, threads};
        ecs::World world;
        spawn(world, small_place(1200, 100), {}, 5);  // enough for every system to go parallel
        for (int i = 0; i < 60; ++i)
            step(world);
        build_frame(world, eye_at({0, 30, 60}), 0.25f, frame);
        EXPECT_EQ(worker_threads(world), threads) << "whatever the number of cores";
        return state_hash(world);
    };
    Frame one, two, eight;
    const std::uint64_t hash = run(1, one);
    EXPECT_EQ(run(2, two), hash);
    EXPECT_EQ(run(8, eight), hash);
    expect_same_picture(one, two);
    expect_same_picture(one, eight);
}

TEST(Simulation, TheStateHashTellsStatesApart) {
    const auto run = [](std::uint64_t seed, int steps) {
        ecs::World world;
        spawn(world, small_place(10, 2), {}, seed);
        for (int i = 0; i < steps; ++i)
            step(world);
        return state_hash(world);
    };
    const std::uint64_t hash = run(1, 200);
    EXPECT_EQ(run(1, 200), hash);
    EXPECT_NE(run(2, 200), hash);
    EXPECT_NE(run(1, 201), hash);
    ecs::World world;
    spawn(world, small_place(10, 2), {}, 1);
    const std::uint64_t before = state_hash(world);
    Frame frame;
    build_frame(world, Eye{}, 0.5f, frame);
    EXPECT_EQ(state_hash(world), before) << "looking changes nothing";
    ecs::Query<LocalTransform> locals;
    for (auto [column] : locals.chunks(world)) {
        column[0].translation_m.x = std::nextafter(column[0].translation_m.x, 1e9f);
        break;
    }
    EXPECT_NE(state_hash(world), before) << "one bit of one float counts";
}

TEST(Simulation, TimesItsSystems) {
    ecs::World world;
    spawn(world, small_place(100, 2), {}, 1);
    step(world);
    Frame frame;
    build_frame(world, Eye{}, 1.0f, frame);
    for (const SystemTiming& timing : world.resource<StepTimings>().all()) {
        EXPECT_GT(timing.ms, 0.0) << timing.name;
        EXPECT_LT(timing.ms, 1000.0) << timing.name;
    }
}

TEST(Simulation, TellsWhoListensOfEveryStepAndLook) {
    ecs::World world;
    spawn(world, small_place(10, 2), {}, 1);
    std::vector<std::pair<SystemsRun::Kind, std::uint64_t>> heard;
    world.set_resource(SystemsListener{[&heard](const SystemsRun& run) {
        heard.emplace_back(run.kind, run.number);
        EXPECT_FALSE(run.systems.empty());
        for (const SystemTiming& system : run.systems) {
            EXPECT_GE(system.begin, run.begin) << system.name;
            EXPECT_LE(system.begin, run.end) << system.name;
            EXPECT_NE(system.thread, std::thread::id{}) << system.name;
        }
    }});
    Frame frame;
    step(world);
    build_frame(world, Eye{}, 1.0f, frame);
    step(world);
    build_frame(world, Eye{}, 1.0f, frame);
    using Kind = SystemsRun::Kind;
    EXPECT_THAT(heard, testing::ElementsAre(std::pair{Kind::step, 1u}, std::pair{Kind::look, 0u},
                                            std::pair{Kind::step, 2u}, std::pair{Kind::look, 1u}));
}

TEST(Mirrors, FollowsTheSignOfTheDeterminant) {
    EXPECT_FALSE(mirrors(glm::mat3{1.0f}));
    EXPECT_TRUE(mirrors(glm::mat3{-1.0f}));
    EXPECT_FALSE(mirrors(glm::mat3{0.0f}));
    glm::mat3 tiny{1e-30f};
    EXPECT_FALSE(mirrors(tiny));
    tiny[1] = -tiny[1];
    EXPECT_TRUE(mirrors(tiny)) << "the float product of the scales would be zero";
}

}  // namespace
}  // namespace rambla::systems
