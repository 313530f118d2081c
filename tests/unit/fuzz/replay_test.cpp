#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "assets/import/gltf.h"
#include "fuzz/gltf_seeds.h"
#include "fuzz/scratch.h"
#include "fuzz/target.h"

namespace rambla::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> content(const fs::path& file) {
    std::ifstream in{file, std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

struct FuzzTargets : testing::Test {
    FuzzTargets() { spdlog::set_level(spdlog::level::off); }
    ~FuzzTargets() override { spdlog::set_level(spdlog::level::info); }
    const fs::path regressions = fs::path{RAMBLA_SOURCE_DIR} / "tests/fuzz/regressions";
};

/// What once broke a promise; a target that breaks one again ends this program.
TEST_F(FuzzTargets, SurviveWhatFuzzingHasFound) {
    for (const Target& target : targets()) {
        if (!fs::exists(regressions / target.name)) continue;
        for (const auto& entry : fs::directory_iterator{regressions / target.name}) {
            SCOPED_TRACE(entry.path().string());
            std::fprintf(stderr, "%s\n", entry.path().c_str());
            target.run(content(entry.path()));
        }
    }
}

TEST_F(FuzzTargets, HaveSeedsThatTheyTakeAndAlsoInPart) {
    for (const Target& target : targets()) {
        std::set<std::string> names;
        target.seeds([&](const std::string& name, Bytes bytes) {
            EXPECT_TRUE(names.insert(name).second) << name;
            target.run(bytes);
            target.run(bytes.first(bytes.size() / 2));
        });
        EXPECT_GE(names.size(), 3u) << target.name;
        target.run({});
    }
}

/// Fuzzing starts from files that load: from others it would not get far.
TEST_F(FuzzTargets, SeedsOfGltfLoad) {
    for (const GltfSeed& seed : gltf_seeds()) {
        const std::vector<unsigned char> glb = glb_of(seed);
        const assets::Scene scene =
            assets::import_gltf(write_scratch("seed.glb", std::as_bytes(std::span{glb})));
        EXPECT_FALSE(scene.meshes.empty()) << seed.name;
    }
}

TEST_F(FuzzTargets, EachRegressionBelongsToOne) {
    for (const auto& entry : fs::directory_iterator{regressions}) {
        const std::string name = entry.path().filename().string();
        const std::vector<Target> all = targets();
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Target& target) {
            return target.name == name;
        })) << name;
    }
}

}  // namespace
}  // namespace rambla::fuzz
