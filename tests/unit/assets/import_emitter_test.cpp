#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "draft.h"

namespace rambla::assets::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A document with one material of optical depth 0.5 and one without, these emitters, and a node that names
/// one.
Scene import(const std::string& emitters, const std::string& node = "0") {
    return Draft{}.load(R"(,"materials":[{"extras":{"ramblaOpticalDepth":0.5}},{}],"nodes":[{"extras":)"
                        R"({"ramblaEmitter":)" +
                        node + R"(}}],"extras":{"ramblaEmitters":)" + emitters + "}");
}

TEST(GltfEmitters, AreReadFromExtras) {
    const LogCapture log;
    const Scene scene = import(
        R"([{"name":"fountain","material":0,"count":12,"lifetime":2.5,"spread":0.5,"velocity":[1,6,-2],)"
        R"("velocitySpread":0.25,"acceleration":[0,-9.5,0],"startRadius":0.125,"endRadius":2}])");
    EXPECT_THAT(log.text(), IsEmpty());
    ASSERT_EQ(scene.emitters.size(), 1u);
    const Emitter& emitter = scene.emitters[0];
    EXPECT_EQ(emitter.name, "fountain");
    EXPECT_EQ(emitter.material, 0u);
    EXPECT_EQ(emitter.count, 12u);
    EXPECT_EQ(emitter.lifetime_s, 2.5f);
    EXPECT_EQ(emitter.spread_m, 0.5f);
    EXPECT_EQ(emitter.velocity_m_s, glm::vec3(1, 6, -2));
    EXPECT_EQ(emitter.velocity_spread_m_s, 0.25f);
    EXPECT_EQ(emitter.acceleration_m_s2, glm::vec3(0, -9.5f, 0));
    EXPECT_EQ(emitter.start_radius_m, 0.125f);
    EXPECT_EQ(emitter.end_radius_m, 2.0f);
    EXPECT_EQ(scene.nodes[0].emitter, 0u);
    EXPECT_EQ(scene.materials[0].optical_depth, 0.5f);
    EXPECT_EQ(scene.materials[1].optical_depth, 0.0f);
}

TEST(GltfEmitters, WhatIsMissingIsTheDefault) {
    const LogCapture log;
    const Scene scene = import(R"([{"material":0}])");
    EXPECT_THAT(log.text(), IsEmpty());
    const Emitter usual;
    EXPECT_EQ(scene.emitters[0].count, usual.count);
    EXPECT_EQ(scene.emitters[0].lifetime_s, usual.lifetime_s);
    EXPECT_EQ(scene.emitters[0].start_radius_m, usual.start_radius_m);
}

TEST(GltfEmitters, NumbersOutOfRangeAreSaidAndBecomeTheNearest) {
    const auto warns = [](const std::string& member, const std::string& element) {
        const LogCapture log;
        Scene scene = import(R"([{"material":0,)" + member + "}]");
        EXPECT_THAT(log.text(), HasSubstr("extras.ramblaEmitters[0]." + element)) << member;
        return std::move(scene.emitters.at(0));
    };
    EXPECT_EQ(warns(R"("count":0)", "count").count, 1u);
    EXPECT_EQ(warns(R"("count":1e30)", "count").count, k_max_particles);
    EXPECT_EQ(warns(R"("count":"many")", "count").count, 1u);
    EXPECT_EQ(warns(R"("count":12.5)", "count").count, 12u);
    EXPECT_EQ(warns(R"("lifetime":-1)", "lifetime").lifetime_s, 0.0f);
    EXPECT_EQ(warns(R"("lifetime":1e300)", "lifetime").lifetime_s, 1e4f);
    EXPECT_EQ(warns(R"("startRadius":0)", "startRadius").start_radius_m, 1e-3f);
    EXPECT_EQ(warns(R"("endRadius":[1])", "endRadius").end_radius_m, 1.0f);
    EXPECT_EQ(warns(R"("velocity":[0,1e9,0])", "velocity[1]").velocity_m_s.y, 1e3f);
    EXPECT_EQ(warns(R"("velocity":[0,"up",0])", "velocity[1]").velocity_m_s.y, 0.0f);
    EXPECT_EQ(warns(R"("velocity":[1,2])", "velocity").velocity_m_s, glm::vec3{0.0f});
    EXPECT_EQ(warns(R"("acceleration":7)", "acceleration").acceleration_m_s2, glm::vec3{0.0f});
}

TEST(GltfEmitters, WithoutHazeNothingIsEmitted) {
    for (const char* const material : {"1", "2", "-1", "0.5", "\"smoke\""}) {
        const LogCapture log;
        const Scene scene = import(std::string{R"([{"material":)"} + material + "}]");
        EXPECT_THAT(log.text(), HasSubstr("extras.ramblaEmitters[0].material")) << material;
        EXPECT_EQ(scene.nodes[0].emitter, k_none) << material;
    }
}

TEST(GltfEmitters, NodesThatNameNoneAndListsThatAreNoneAreLeftOut) {
    for (const char* const node : {"1", "-1", "\"first\"", "0.5"}) {
        const LogCapture log;
        EXPECT_EQ(import(R"([{"material":0}])", node).nodes[0].emitter, k_none) << node;
        EXPECT_THAT(log.text(), HasSubstr("nodes[0].extras.ramblaEmitter")) << node;
    }
    for (const char* const list : {"7", "\"x\""}) {
        const LogCapture log;
        EXPECT_THAT(import(list).emitters, IsEmpty()) << list;
        EXPECT_THAT(log.text(), HasSubstr("extras.ramblaEmitters")) << list;
    }
    const LogCapture log;
    EXPECT_EQ(import("[7]").nodes[0].emitter, k_none) << "an emitter that is no object";
}

TEST(GltfEmitters, FewBytesDoNotBecomeMillionsOfParticles) {
    const std::string node = R"({"extras":{"ramblaEmitter":0}})";
    const auto nodes = [&](int count) {
        std::string list = node;
        for (int i = 1; i < count; ++i)
            list.append(",").append(node);
        return R"(,"materials":[{"extras":{"ramblaOpticalDepth":0.5}}],"nodes":[)" + list +
               R"(],"extras":{"ramblaEmitters":[{"material":0,"count":4096}]})";
    };
    EXPECT_EQ(Draft{}.load(nodes(3)).nodes.size(), 3u);
    EXPECT_THAT(Draft{}.error(nodes(30)),
                AllOf(HasSubstr("extras.ramblaEmitter"), HasSubstr("more vertices, indices or particles")));
}

TEST(GltfMaterials, OpticalDepthsOutOfRangeAreSaid) {
    for (const auto& [depth, used] :
         {std::pair{"1e9", k_max_optical_depth}, {"-1", 0.0f}, {"\"deep\"", 0.0f}}) {
        const LogCapture log;
        const Scene scene =
            Draft{}.load(std::string{R"(,"materials":[{"extras":{"ramblaOpticalDepth":)"} + depth + "}}]");
        EXPECT_EQ(scene.materials[0].optical_depth, used) << depth;
        EXPECT_THAT(log.text(), HasSubstr("materials[0].extras.ramblaOpticalDepth")) << depth;
    }
}

}  // namespace
}  // namespace rambla::assets::test
