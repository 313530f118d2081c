#include <gtest/gtest.h>

#include <array>
#include <random>

#include "draft.h"
#include "support/scene_check.h"

namespace rambla::assets::test {
namespace {

/// A document with a part of everything that can move, repeat or stand for something else.
std::string rich_document() {
    Draft draft;
    const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
    draft.add(corners, "VEC3");
    draft.add<std::uint8_t>({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
    draft.add<float>({.5f, .5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    draft.add<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                     "MAT4");
    draft.add<float>({0, 0.5f, 1}, "SCALAR");
    draft.add<float>({0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC4");
    draft.add<std::int16_t>({0, 32767, 100, 5, 6, 7}, "SCALAR", R"(,"normalized":true)");
    draft.add<std::uint16_t>({2}, "SCALAR");
    draft.add<float>({7, 8, 9}, "VEC3");
    draft.add_text(R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,)"
                   R"("indices":{"bufferView":7,"componentType":5123},"values":{"bufferView":8}}})");
    draft.add<std::uint16_t>({0, 1, 2}, "SCALAR");
    return draft.bytes(
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"indices":10,)"
        R"("targets":[{"POSITION":9},{"POSITION":0}]}],"weights":[0.5,0.25]}],)"
        R"("skins":[{"joints":[1,2],"inverseBindMatrices":3}],"nodes":[)"
        R"({"mesh":0,"skin":0,"children":[1],"extensions":{"MSFT_lod":{"ids":[3,4]}}},{"children":[2]},{},)"
        R"({"mesh":0,"weights":[1,0]},{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":)"
        R"({"attributes":{"TRANSLATION":0,"SCALE":0}}}}],"scene":0,"scenes":[{"nodes":[0]}],)"
        R"("animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}},)"
        R"({"sampler":1,"target":{"node":3,"path":"weights"}}],)"
        R"("samplers":[{"input":4,"output":5},{"input":4,"output":6,"interpolation":"STEP"}]}])");
}

/// Replaces one number of the document's text by another of the same number of digits, or one byte of it.
std::string mutated(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t size) {
        return random() % size;
    };
    const std::size_t json_end = bytes.rfind(std::string("BIN\0", 4)) - 4;
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        const bool in_text = below(4) != 0;
        std::size_t at =
            in_text ? 20 + below(json_end - 20) : json_end + 8 + below(bytes.size() - json_end - 8);
        if (!in_text) {
            constexpr std::array<char, 5> k_bytes{0, 1, '\x7f', '\x80', '\xff'};
            bytes[at] = k_bytes[below(k_bytes.size())];
            continue;
        }
        while (at < json_end && (bytes[at] < '0' || bytes[at] > '9'))
            ++at;
        if (at < json_end) bytes[at] = static_cast<char>('0' + below(10));
    }
    return bytes;
}

TEST(GltfMutations, EveryMutantLoadsSoundOrIsRefused) {
    const std::string document = rich_document();
    const ScratchFolder folder;
    ASSERT_EQ(import_error(folder.write("a.glb", document)), "");
    EXPECT_EQ(problem_of(import_gltf(folder.path() / "a.glb")), "");
    const LogCapture silent;
    std::mt19937 random{1};
    int refused = 0;
    constexpr int k_mutants = 4000;
    for (int i = 0; i < k_mutants; ++i) {
        const std::filesystem::path file = folder.write("a.glb", mutated(document, random));
        try {
            EXPECT_EQ(problem_of(import_gltf(file)), "") << "mutant " << i;
        } catch (const Error&) {
            ++refused;
        }
        if (HasFailure()) break;
    }
    // Both happen often: the mutants reach behind the first check, and the checks see most of them.
    EXPECT_GT(refused, k_mutants / 10);
    EXPECT_LT(refused, k_mutants * 9 / 10);
}

}  // namespace
}  // namespace rambla::assets::test
