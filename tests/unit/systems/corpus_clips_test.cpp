// Clips of the sample files: every one plays, and what deforms stays inside its bounds.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "assets/error.h"
#include "assets/import/gltf.h"
#include "support/deformed_vertices.h"
#include "systems/position.h"
#include "systems/simulate/animation.h"
#include "systems/spawn.h"

namespace rambla::systems {
namespace {

namespace fs = std::filesystem;

constexpr int k_poses = 8;

/// A view of everything that a Frame could show: far behind, orthographic, as large as the world.
Eye eye_on_everything(const assets::Scene& scene) {
    float reach = 1.0f;
    for (const assets::Mesh& mesh : scene.meshes) {
        for (const glm::vec3& p : mesh.positions)
            reach = std::max(reach, glm::length(p));
    }
    Eye eye;
    eye.kind = assets::CameraKind::orthographic;
    eye.half_height_m = 1.0e3f * reach;
    eye.near_m = -1.0e3f * reach;
    eye.far_m = 1.0e3f * reach;
    return eye;
}

TEST(GltfCorpusClips, KeepEveryVertexInsideItsBounds) {
    std::set<std::string> skinned_or_morphed;
    int clips = 0;
    for (const char* const folder : {"models", "characters", "edge-valid", "scenes"}) {
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator{fs::path{RAMBLA_GLTF_DIR} / folder}) {
            const fs::path& file = entry.path();
            if (file.extension() != ".gltf" && file.extension() != ".glb") continue;
            assets::Scene scene;
            try {
                scene = assets::import_gltf(file);
            } catch (const assets::Error&) {
                continue;  // which files load is another test's question
            }
            if (scene.clips.empty() && scene.skeletons.empty()) continue;
            ecs::World world;
            const WorldPosition origin{{11, 0, -5}, {128.0f, 0.0f, 3.0f}};
            const SpawnedScene spawned = spawn(world, scene, origin);
            Eye eye = eye_on_everything(scene);
            eye.place = origin;
            const auto check = [&](float interpolation, const std::string& what) {
                const test::Outside found = test::farthest_outside(world, scene, eye, interpolation);
                EXPECT_LE(found.distance_m, 0.0) << file << ", " << what;
                if (found.vertices > 0) skinned_or_morphed.insert(file.filename().string());
            };
            check(1.0f, "at rest");
            if (spawned.player == ecs::Entity{}) continue;
            for (std::uint32_t clip = 0; clip < scene.clips.size(); ++clip) {
                // A step as long as an eighth of the clip: pictures between two steps are as far from both as
                // can be.
                const double speed = static_cast<double>(scene.clips[clip].duration_s) / k_poses / k_step_s;
                world.get_mut<AnimationPlayer>(spawned.player).playing = {.clip = clip,
                                                                          .speed = static_cast<float>(speed)};
                settle_animation(world);
                for (int pose = 0; pose < k_poses; ++pose) {
                    step(world);
                    check(0.6f, "clip " + std::to_string(clip) + ", pose " + std::to_string(pose));
                }
                ++clips;
            }
        }
    }
    for (const char* const file :
         {"Fox.gltf", "Knight.glb", "Mage.glb", "RiggedFigure.glb", "RiggedSimple.glb", "SimpleSkin.gltf",
          "SimpleMorph.gltf", "AnimatedMorphCube.glb", "MorphStressTest.glb"}) {
        EXPECT_TRUE(skinned_or_morphed.contains(file)) << file << " was not drawn";
    }
    EXPECT_GT(clips, 150);
}

}  // namespace
}  // namespace rambla::systems
