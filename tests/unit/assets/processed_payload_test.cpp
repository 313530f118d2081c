#include "assets/cache/processed_payload.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "assets/cache/payload_stream.h"
#include "assets/mesh_columns.h"
#include "assets/process/blocks.h"
#include "assets/process/process.h"
#include "unit/assets/process_support.h"
#include "unit/assets/processed_equality.h"

namespace rambla::assets::test {
namespace {

using Bytes = std::vector<std::byte>;

/// Two morphing, skinned triangles with one of everything else that a processed mesh may have; made by hand,
/// so that none of its columns is empty.
ProcessedMesh small_mesh() {
    std::mt19937 random{4};
    ProcessedMesh processed;
    processed.mesh = random_full_mesh(random, 4, 2);
    processed.mesh.name = "m";
    processed.mesh.morphs[0].name = "smile";
    processed.mesh.morphs[1].normals.clear();
    for (const glm::vec3 position : processed.mesh.positions)
        processed.mesh.bounds.expand(position);
    processed.lods.indices = {0, 1, 2, 1, 2, 3};
    processed.lods.levels = {
        {.range = {0, 3}, .error_m = 0.25f, .normal_error_deg = 3.0f, .uv_error = 0.5f, .sloppy = false},
        {.range = {3, 3}, .error_m = 0.5f, .normal_error_deg = 2.0f, .uv_error = 0.0f, .sloppy = true}};
    ShadowMesh& shadow = processed.shadow;
    shadow.positions = {processed.mesh.positions.begin(), processed.mesh.positions.begin() + 3};
    shadow.joints.assign(3, {1, 0, 2, 3});
    shadow.weights.assign(3, {0.5f, 0.25f, 0.25f, 0.0f});
    shadow.morph_positions = {{}, std::vector<glm::vec3>(3, {1, 2, 3})};
    shadow.levels = {{0, 3}, {3, 3}, {6, 0}};
    shadow.indices = {0, 1, 2, 2, 1, 0};
    processed.sphere = {.centre = {1, 2, 3}, .radius = 4.0f};
    processed.occluder = {
        .boxes = {{.min = {0, 0, 0}, .max = {1, 2, 3}}}, .volume_share = 0.5f, .gap_m = 0.1f};
    return processed;
}

TextureData small_texture() {
    TextureData texture{
        .name = "bark",
        .format = TexelFormat::bc5,
        .colour_space = ColourSpace::linear,
        .swizzle = {ChannelSource::red, ChannelSource::green, ChannelSource::one, ChannelSource::zero},
        .normal_map = true,
        .levels = {{.width = 5, .height = 3, .offset = 0, .size = 32, .rms_error = 0.25f},
                   {.width = 2, .height = 1, .offset = 32, .size = 16, .rms_error = 0.5f},
                   {.width = 1, .height = 1, .offset = 48, .size = 16, .rms_error = 0.0f}},
        .bytes = {}};
    for (int i = 0; i < 64; ++i)
        texture.bytes.push_back(static_cast<std::byte>(7 * i));
    return texture;
}

/// Everything that drawing and culling take for granted.
void expect_sound(const ProcessedMesh& processed) {
    const std::size_t vertices = processed.mesh.positions.size();
    for_each_column(processed.mesh,
                    [&](const auto& column) { EXPECT_TRUE(column.empty() || column.size() == vertices); });
    for (const std::uint32_t index : processed.mesh.indices)
        EXPECT_LT(index, vertices);
    for (const std::uint32_t index : processed.lods.indices)
        EXPECT_LT(index, vertices);
    for (const LodLevel& level : processed.lods.levels) {
        EXPECT_LE(std::uint64_t{level.range.first} + level.range.count, processed.lods.indices.size());
        EXPECT_GE(level.error_m, 0.0f);
    }
    for (const std::uint32_t index : processed.shadow.indices)
        EXPECT_LT(index, processed.shadow.positions.size());
    for (const IndexRange range : processed.shadow.levels)
        EXPECT_LE(std::uint64_t{range.first} + range.count, processed.shadow.indices.size());
    EXPECT_EQ(processed.shadow.levels.size(), processed.lods.levels.size() + 1);
    EXPECT_EQ(processed.shadow.morph_positions.size(), processed.mesh.morphs.size());
    EXPECT_LE(processed.mesh.bounds.min.x, processed.mesh.bounds.max.x);
}

void expect_sound(const TextureData& texture) {
    ASSERT_FALSE(texture.levels.empty());
    EXPECT_EQ(texture.levels.back().width, 1u);
    EXPECT_EQ(texture.levels.back().height, 1u);
    std::size_t end = 0;
    for (const TextureLevel& level : texture.levels) {
        EXPECT_EQ(level.offset, end);
        EXPECT_EQ(level.size, stored_size(texture.format, level.width, level.height));
        end += level.size;
    }
    EXPECT_EQ(end, texture.bytes.size());
    EXPECT_LE(texture.format, TexelFormat::bc5);
    for (const ChannelSource source : texture.swizzle)
        EXPECT_LE(source, ChannelSource::one);
}

/// Reads damaged bytes: what is not refused must be sound, and say nothing but what the bytes say.
template <class Read>
bool expect_refused_or_sound(const Bytes& bytes, Read&& read, const std::string& how) {
    SCOPED_TRACE(how);
    const auto result = read(bytes);
    if (!result) return true;
    expect_sound(*result);
    EXPECT_EQ(to_payload(*result), bytes);
    return false;
}

template <class Read>
void damage_everywhere(const Bytes& whole, Read&& read) {
    ASSERT_TRUE(read(whole));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(read(std::span{whole}.first(size))) << "cut at " << size;
    Bytes longer = whole;
    longer.push_back({});
    EXPECT_FALSE(read(longer));
    std::size_t refused = 0;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        Bytes damaged = whole;
        damaged[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
        refused += expect_refused_or_sound(damaged, read, "bit " + std::to_string(bit)) ? 1 : 0;
    }
    EXPECT_GT(refused, 64u) << "all counts are checked";
    // Wherever a count stands, one that asks for more than there is must not be believed.
    for (const std::uint64_t huge : {std::uint64_t{whole.size()}, std::uint64_t{1} << 33,
                                     std::uint64_t{1} << 61, (std::uint64_t{1} << 63) / 6, ~std::uint64_t{0}})
        for (std::size_t at = 0; at + sizeof huge <= whole.size(); ++at) {
            Bytes damaged = whole;
            std::memcpy(&damaged[at], &huge, sizeof huge);
            expect_refused_or_sound(damaged, read, std::to_string(huge) + " at " + std::to_string(at));
        }
}

TEST(ProcessedPayload, MeshesComeBackAsTheyWere) {
    const ProcessedMesh small = small_mesh();
    const std::optional<ProcessedMesh> back = mesh_from_payload(to_payload(small));
    ASSERT_TRUE(back);
    expect_equal(*back, small);
    const std::optional<ProcessedMesh> empty_back = mesh_from_payload(to_payload(process_mesh({}, {}, {})));
    ASSERT_TRUE(empty_back);
    EXPECT_TRUE(empty_back->mesh.positions.empty());
    EXPECT_TRUE(empty_back->mesh.bounds.empty());
    EXPECT_LT(empty_back->sphere.radius, 0.0f);
}

TEST(ProcessedPayload, WhatProcessingMakesOfEveryTopologyIsTaken) {
    std::mt19937 random{5};
    for (const Topology topology : {Topology::triangles, Topology::lines, Topology::points}) {
        Mesh mesh = random_full_mesh(random, 30, 20);
        mesh.topology = topology;
        const ProcessedMesh processed = process_mesh(mesh, {}, {});
        const std::optional<ProcessedMesh> back = mesh_from_payload(to_payload(processed));
        ASSERT_TRUE(back) << static_cast<int>(topology);
        expect_equal(*back, processed);
    }
    const ProcessedMesh with_levels = process_mesh(torus(24, 16, 3.0f), {}, {});
    ASSERT_FALSE(with_levels.lods.levels.empty());
    const std::optional<ProcessedMesh> back = mesh_from_payload(to_payload(with_levels));
    ASSERT_TRUE(back);
    expect_equal(*back, with_levels);
}

TEST(ProcessedPayload, TexturesComeBackAsTheyWere) {
    const TextureData texture = small_texture();
    const std::optional<TextureData> back = texture_from_payload(to_payload(texture));
    ASSERT_TRUE(back);
    expect_equal(*back, texture);
}

TEST(ProcessedPayload, ADamagedMeshIsRefusedOrSound) {
    damage_everywhere(to_payload(small_mesh()), mesh_from_payload);
}

TEST(ProcessedPayload, ADamagedTextureIsRefusedOrSound) {
    damage_everywhere(to_payload(small_texture()), texture_from_payload);
}

TEST(ProcessedPayload, MeshesThatContradictThemselvesAreRefused) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<std::pair<std::string, std::function<void(ProcessedMesh&)>>> contradictions{
        {"index",
         [](ProcessedMesh& m) {
             m.mesh.indices[5] = 4;
         }},
        {"part of a triangle",
         [](ProcessedMesh& m) {
             m.mesh.indices.pop_back();
         }},
        {"short column",
         [](ProcessedMesh& m) {
             m.mesh.uv1.pop_back();
         }},
        {"long column",
         [](ProcessedMesh& m) {
             m.mesh.morphs[1].tangents.emplace_back();
         }},
        {"joints without weights",
         [](ProcessedMesh& m) {
             m.mesh.weights.clear();
         }},
        {"topology",
         [](ProcessedMesh& m) {
             m.mesh.topology = static_cast<Topology>(3);
         }},
        {"position",
         [&](ProcessedMesh& m) {
             m.mesh.positions[3].z = nan;
         }},
        {"bounds",
         [&](ProcessedMesh& m) {
             m.mesh.bounds.max.x = inf;
         }},
        {"bounds turned over",
         [](ProcessedMesh& m) {
             std::swap(m.mesh.bounds.min, m.mesh.bounds.max);
         }},
        {"no bounds",
         [](ProcessedMesh& m) {
             m.mesh.bounds = {};
         }},
        {"level's index",
         [](ProcessedMesh& m) {
             m.lods.indices[0] = 4;
         }},
        {"level's range",
         [](ProcessedMesh& m) {
             m.lods.levels[1].range.first = 4;
         }},
        {"range around 2^32",
         [](ProcessedMesh& m) {
             m.lods.levels[1].range = {0xffffffff, 3};
         }},
        {"part of a level's triangle",
         [](ProcessedMesh& m) {
             m.lods.levels[0].range.count = 2;
         }},
        {"errors that decrease",
         [](ProcessedMesh& m) {
             m.lods.levels[0].error_m = 0.75f;
         }},
        {"negative error",
         [](ProcessedMesh& m) {
             m.lods.levels[0].error_m = -0.1f;
         }},
        {"error",
         [&](ProcessedMesh& m) {
             m.lods.levels[1].error_m = nan;
         }},
        {"normal error",
         [&](ProcessedMesh& m) {
             m.lods.levels[1].normal_error_deg = inf;
         }},
        {"texture error",
         [&](ProcessedMesh& m) {
             m.lods.levels[1].uv_error = nan;
         }},
        {"shadow's index",
         [](ProcessedMesh& m) {
             m.shadow.indices[2] = 3;
         }},
        {"shadow's range",
         [](ProcessedMesh& m) {
             m.shadow.levels[2] = {6, 3};
         }},
        {"shadow's levels",
         [](ProcessedMesh& m) {
             m.shadow.levels.pop_back();
         }},
        {"shadow's column",
         [](ProcessedMesh& m) {
             m.shadow.weights.pop_back();
         }},
        {"shadow's joints",
         [](ProcessedMesh& m) {
             m.shadow.joints.clear();
         }},
        {"shadow's position",
         [&](ProcessedMesh& m) {
             m.shadow.positions[0].y = -inf;
         }},
        {"shadow's morph",
         [](ProcessedMesh& m) {
             m.shadow.morph_positions[1].pop_back();
         }},
        {"shadow's morphs",
         [](ProcessedMesh& m) {
             m.shadow.morph_positions.pop_back();
         }},
        {"sphere",
         [&](ProcessedMesh& m) {
             m.sphere.radius = nan;
         }},
        {"sphere's centre",
         [&](ProcessedMesh& m) {
             m.sphere.centre.x = inf;
         }},
        {"box",
         [](ProcessedMesh& m) {
             std::swap(m.occluder.boxes[0].min, m.occluder.boxes[0].max);
         }},
        {"share",
         [&](ProcessedMesh& m) {
             m.occluder.volume_share = nan;
         }},
        {"gap", [&](ProcessedMesh& m) {
             m.occluder.gap_m = -1.0f;
         }}};
    for (const auto& [name, contradict] : contradictions) {
        ProcessedMesh mesh = small_mesh();
        contradict(mesh);
        EXPECT_FALSE(mesh_from_payload(to_payload(mesh))) << name;
    }
}

TEST(ProcessedPayload, TexturesThatContradictThemselvesAreRefused) {
    const std::vector<std::pair<std::string, std::function<void(TextureData&)>>> contradictions{
        {"format",
         [](TextureData& t) {
             t.format = static_cast<TexelFormat>(6);
         }},
        {"colour space",
         [](TextureData& t) {
             t.colour_space = static_cast<ColourSpace>(2);
         }},
        {"swizzle",
         [](TextureData& t) {
             t.swizzle[3] = static_cast<ChannelSource>(6);
         }},
        {"error",
         [](TextureData& t) {
             t.levels[1].rms_error = -0.5f;
         }},
        {"no error", [](TextureData& t) {
             t.levels[2].rms_error = std::numeric_limits<float>::infinity();
         }}};
    for (const auto& [name, contradict] : contradictions) {
        TextureData texture = small_texture();
        contradict(texture);
        EXPECT_FALSE(texture_from_payload(to_payload(texture))) << name;
    }
    // Sizes: they follow the name and the seven bytes that say what kind of texture it is.
    const Bytes whole = to_payload(small_texture());
    constexpr std::size_t k_width_at = 8 + 4 + 7;
    for (const std::uint32_t width : {0u, 1u, 4u, 9u, 1u << 20, 0xffffffffu}) {
        Bytes bytes = whole;
        std::memcpy(&bytes[k_width_at], &width, sizeof width);
        EXPECT_FALSE(texture_from_payload(bytes)) << width;
    }
}

TEST(PayloadStream, WhatIsReadBeyondSomethingWrongIsNothing) {
    PayloadWriter out;
    out.add(std::uint32_t{7});
    out.add_count(1000);
    out.add(std::uint32_t{9});
    const Bytes bytes = out.take();
    PayloadReader in{bytes};
    EXPECT_EQ(in.value<std::uint32_t>(), 7u);
    EXPECT_TRUE(in.column<std::uint32_t>().empty()) << "a thousand numbers in four bytes";
    EXPECT_EQ(in.value<std::uint32_t>(), 0u) << "not the 9 behind it";
    EXPECT_TRUE(in.text().empty());
    EXPECT_FALSE(in.good());
    PayloadReader early{bytes};
    EXPECT_EQ(early.value<std::uint32_t>(), 7u);
    EXPECT_FALSE(early.good()) << "something is left";
}

}  // namespace
}  // namespace rambla::assets::test
