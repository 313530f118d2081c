#include <gtest/gtest.h>

#include "assets/daylight.h"
#include "assets/export/gltf.h"
#include "assets/export/sun.h"
#include "import_support.h"

namespace rambla::assets::test {
namespace {

TEST(ExportedSun, ShinesFromWhereTheEnvironmentHasIt) {
    const glm::vec3 directions[]{noon().direction_to_sun,
                                 {0, 0, 1},
                                 {0, 0, -1},
                                 {0, 1, 0},
                                 {0, -1, 0},
                                 {-1, 0, 0},
                                 glm::normalize(glm::vec3{1e-5f, 0, -1})};
    for (const glm::vec3& direction : directions) {
        Environment light = noon();
        light.direction_to_sun = direction;
        Scene scene;
        scene.nodes.emplace_back();
        scene.roots = {0};
        add_sun(scene, light);
        const ScratchFolder folder;
        export_gltf(folder.path() / "sun.glb", scene);
        const Scene again = import_gltf(folder.path() / "sun.glb");
        ASSERT_EQ(again.lights.size(), 1u);
        ASSERT_EQ(again.roots.size(), 2u);
        const Node& node = again.nodes[again.roots[1]];
        EXPECT_EQ(node.light, 0u);
        const Light& sun = again.lights[0];
        EXPECT_EQ(sun.kind, LightKind::directional);
        // It shines along −Z of its node. Rounding of a quaternion; a degenerate one is off by its threshold.
        EXPECT_LT(glm::distance(node.local.rotation * glm::vec3(0, 0, 1), direction), 3e-5f);
        EXPECT_LT(glm::distance(sun.colour * sun.intensity, light.sun_illuminance), 1e-6f);
        EXPECT_LE(std::max({sun.colour.x, sun.colour.y, sun.colour.z}), 1.0f);
    }
}

TEST(ExportedSun, IsLeftOutWhereThereIsNone) {
    Scene scene;
    add_sun(scene, daylight(k_night));
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_TRUE(scene.nodes.empty());
    EXPECT_TRUE(scene.roots.empty());
}

}  // namespace
}  // namespace rambla::assets::test
