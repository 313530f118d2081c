#include "render/texture_residency.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "render/level_upload.h"
#include "support/texture_levels.h"
#include "systems/frame.h"
#include "unit/render/gl_fixture.h"

namespace rambla::render {
namespace {

using assets::TexelFormat;
using tests::floors_of;
using tests::noise_texture;
using tests::TestLevels;
using Levels = std::vector<std::uint8_t>;

constexpr std::uint8_t k_none = systems::k_not_demanded;
constexpr float k_plenty_mib = 1024.0f;

std::vector<assets::TextureData> some_images() {
    return {noise_texture(256, 256, 1),
            noise_texture(512, 128, 2),
            noise_texture(256, 256, 3, TexelFormat::bc1),
            noise_texture(200, 300, 4),  // of sides that do not halve exactly
            noise_texture(32, 32, 5),
            noise_texture(130, 258, 6, TexelFormat::bc5)};
}

/// Bytes on the graphics card of all levels from one on.
std::uint64_t chain_bytes(const assets::TextureData& image, std::uint32_t first) {
    return gl::storage_bytes(describe_levels(image, first));
}

float mib(std::uint64_t bytes) {
    return static_cast<float>(static_cast<double>(bytes) / 1048576.0);
}

/// Images of which the finer levels come from a source, as a renderer holds them that has each frame drawn at
/// once.
struct Images {
    explicit Images(const std::vector<assets::TextureData>& all)
        : whole{all}, source{std::make_shared<TestLevels>(all)}, residency{floors_of(all), source} {}

    void update(const Levels& demand, const TextureParameters& parameters) {
        residency.begin_frame(frame);
        residency.update(demand, parameters);
        residency.release(++frame);
    }
    void complete(const Levels& demand, const TextureParameters& parameters) {
        residency.begin_frame(frame);
        residency.complete(demand, parameters, [this] {
            glFinish();
            residency.release(frame + 1);
        });
        residency.release(++frame);
    }
    [[nodiscard]] std::uint32_t finest(std::uint32_t image) const {
        GLint levels = 0;
        glGetTextureParameteriv(residency.name(image), GL_TEXTURE_IMMUTABLE_LEVELS, &levels);
        return static_cast<std::uint32_t>(whole[image].levels.size()) - static_cast<std::uint32_t>(levels);
    }
    /// Whether every resident level holds the image's texels.
    [[nodiscard]] bool texels_are_right(std::uint32_t image) const {
        const assets::TextureData& expected = whole[image];
        for (std::uint32_t level = finest(image); level < expected.levels.size(); ++level) {
            const auto number = static_cast<GLint>(level - finest(image));
            std::vector<std::byte> found(expected.levels[level].size);
            const auto size = static_cast<GLsizei>(found.size());
            if (expected.format == TexelFormat::rgba8) {
                glGetTextureImage(residency.name(image), number, GL_RGBA, GL_UNSIGNED_BYTE, size,
                                  found.data());
            } else {
                glGetCompressedTextureImage(residency.name(image), number, size, found.data());
            }
            const auto bytes = assets::bytes_of(expected, level, level + 1);
            if (!std::equal(found.begin(), found.end(), bytes.begin(), bytes.end())) return false;
        }
        return true;
    }

    std::vector<assets::TextureData> whole;
    std::shared_ptr<TestLevels> source;
    std::uint64_t frame = 0;
    TextureResidency residency;
};

struct TextureResidencyTest : WithGl {};

TEST_F(TextureResidencyTest, BringsTheLevelsThatAreDemandedAndNoFinerOnes) {
    Images images{some_images()};
    EXPECT_EQ(images.finest(0), 2u) << "64 texels";
    const std::uint64_t floors = images.residency.feedback().resident_bytes;
    images.complete({0, 1, 1, 0, k_none, 2}, {k_plenty_mib, 16.0f});
    const std::vector<std::uint32_t> expected{0, 1, 1, 0, 0, 1};  // 130 texels halve once
    for (std::uint32_t i = 0; i < 6; ++i) {
        EXPECT_EQ(images.finest(i), expected[i]) << i;
        EXPECT_TRUE(images.texels_are_right(i)) << i;
    }
    EXPECT_GT(images.residency.feedback().resident_bytes, floors);
    EXPECT_EQ(images.residency.feedback().loads, 5u);
    EXPECT_EQ(images.residency.feedback().below_demand, 0u);
    EXPECT_THAT(images.residency.changed(), testing::UnorderedElementsAre(0, 1, 2, 3, 5));
}

TEST_F(TextureResidencyTest, NeverHoldsMoreThanItsBudgetWhateverIsDemanded) {
    std::mt19937 random{1};
    std::vector<assets::TextureData> all;
    std::uint64_t whole_bytes = 0, floor_bytes = 0;
    for (std::uint32_t i = 0; i < 24; ++i) {
        const auto format = std::vector{TexelFormat::rgba8, TexelFormat::bc1, TexelFormat::bc3}[random() % 3];
        all.push_back(noise_texture(1u << (5 + random() % 5), 1u << (5 + random() % 5), i, format));
        whole_bytes += chain_bytes(all.back(), 0);
        floor_bytes += chain_bytes(all.back(), assets::floor_level(all.back()));
    }
    for (const std::uint64_t part : {2, 5, 10}) {
        Images images{all};
        const std::uint64_t budget = floor_bytes + whole_bytes / part;
        const TextureParameters parameters{mib(budget), 0.0625f};
        for (int frame = 0; frame < 250; ++frame) {
            Levels demand;
            // What is seen stays for a while, and changes all at once.
            std::mt19937 scene{static_cast<std::uint32_t>(frame / 30)};
            for (std::size_t i = 0; i < all.size(); ++i)
                demand.push_back(scene() % 3 == 0 ? k_none : static_cast<std::uint8_t>(scene() % 5));
            images.source->allow(random() % 4);
            images.update(demand, parameters);
            ASSERT_LE(images.residency.feedback().resident_bytes, budget);
            ASSERT_LE(images.residency.feedback().peak_bytes, budget) << "not for a moment";
        }
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            ASSERT_LE(images.finest(i), assets::floor_level(all[i]));
            ASSERT_TRUE(images.texels_are_right(i)) << i;
        }
        EXPECT_GT(images.residency.feedback().loads, 24u);
        EXPECT_GT(images.residency.feedback().peak_bytes, budget / 2) << "and makes use of it";
    }
}

TEST_F(TextureResidencyTest, UploadsNoMoreForAFrameThanAllowed) {
    Images images{{noise_texture(512, 512, 1)}};
    // Levels 0 to 2: 512² + 256² + 128² texels, 4 bytes each, of which a frame brings 64 KiB.
    const int frames = (512 * 512 + 256 * 256 + 128 * 128) * 4 / 65536;
    for (int frame = 0; frame < frames; ++frame) {
        images.update({0}, {k_plenty_mib, 0.0625f});
        ASSERT_EQ(images.finest(0), 3u) << frame;
    }
    images.update({0}, {k_plenty_mib, 0.0625f});
    EXPECT_EQ(images.finest(0), 0u) << "the request took the first frame";
    EXPECT_TRUE(images.texels_are_right(0));
}

TEST_F(TextureResidencyTest, DrawsOnWithWhatItHasWhileLoadsArePending) {
    Images images{some_images()};
    images.source->allow(0);
    for (int frame = 0; frame < 20; ++frame)
        images.update({0, 0, 0, 0, 0, 0}, {k_plenty_mib, 16.0f});
    EXPECT_EQ(images.finest(0), 2u);
    EXPECT_EQ(images.residency.feedback().pending_loads, 4u);
    EXPECT_EQ(images.residency.feedback().below_demand, 5u);
    EXPECT_EQ(images.source->asked(), 4u) << "nothing is asked for twice";
    images.source->allow(100);
    for (int frame = 0; frame < 3; ++frame)
        images.update({0, 0, 0, 0, 0, 0}, {k_plenty_mib, 16.0f});
    EXPECT_EQ(images.finest(0), 0u);
    EXPECT_EQ(images.residency.feedback().below_demand, 0u);
}

TEST_F(TextureResidencyTest, StaysAtTheLevelItHasWhenFinerOnesCannotBeHad) {
    Images images{some_images()};
    images.source->lose(1);
    images.complete({0, 0, k_none, k_none, k_none, k_none}, {k_plenty_mib, 16.0f});
    EXPECT_EQ(images.finest(0), 0u);
    EXPECT_EQ(images.finest(1), 3u);
    EXPECT_EQ(images.residency.feedback().below_demand, 1u);
    for (int frame = 0; frame < 10; ++frame)
        images.update({0, 0, k_none, k_none, k_none, k_none}, {k_plenty_mib, 16.0f});
    EXPECT_EQ(images.source->asked(), 2u) << "it is not asked for again";
}

// The first and the second fill the budget. The first is needed less then, the second not at all, and when
// that is no news any more, the third is needed.
TEST_F(TextureResidencyTest, NeverTakesAwayWhatIsNeededWhileOthersAreNot) {
    Images images{{noise_texture(512, 512, 1), noise_texture(512, 512, 2), noise_texture(512, 544, 3)}};
    const TextureParameters parameters{
        mib(2 * chain_bytes(images.whole[0], 0) + 3 * chain_bytes(images.whole[2], 3)), 16.0f};
    images.complete({0, 0, k_none}, parameters);
    ASSERT_EQ(images.finest(0), 0u);
    ASSERT_EQ(images.finest(1), 0u);
    for (std::uint64_t frame = 0; frame <= ResidencyPlan::k_hold_frames; ++frame)
        images.update({1, k_none, k_none}, parameters);
    ASSERT_EQ(images.finest(0), 0u);
    ASSERT_EQ(images.finest(1), 0u);
    for (int frame = 0; frame < 20; ++frame) {
        images.update({1, k_none, 0}, parameters);
        ASSERT_LE(images.finest(0), 1u) << frame;
    }
    EXPECT_EQ(images.finest(0), 1u) << "there is no room for more";
    EXPECT_EQ(images.finest(2), 0u);
}

TEST_F(TextureResidencyTest, FollowsABudgetThatShrinks) {
    Images images{some_images()};
    images.complete({0, 0, 0, 0, 0, 0}, {k_plenty_mib, 16.0f});
    std::uint64_t floors = 0;
    for (const assets::TextureData& image : images.whole)
        floors += chain_bytes(image, assets::floor_level(image));
    const std::uint64_t budget = 3 * floors;
    for (int frame = 0; frame < 20; ++frame)
        images.update({0, 0, 0, 0, 0, 0}, {mib(budget), 16.0f});
    EXPECT_LE(images.residency.feedback().resident_bytes, budget);
    EXPECT_EQ(images.residency.passing_textures(), 0u);
    for (std::uint32_t i = 0; i < 6; ++i)
        EXPECT_TRUE(images.texels_are_right(i)) << i;
}

TEST_F(TextureResidencyTest, KeepsTheFloorsOfABudgetThatIsTooSmall) {
    Images images{some_images()};
    const std::uint64_t floors = images.residency.feedback().resident_bytes;
    images.complete({0, 0, 0, 0, 0, 0}, {0.01f, 16.0f});
    EXPECT_EQ(images.residency.feedback().resident_bytes, floors);
    EXPECT_EQ(images.residency.feedback().loads, 0u);
}

TEST_F(TextureResidencyTest, HoldsAllThatItIsGivenWithoutASource) {
    TextureResidency residency{some_images(), nullptr};
    const std::uint64_t bytes = residency.feedback().resident_bytes;
    residency.update(Levels{k_none, k_none, k_none, k_none, k_none, k_none}, {0.125f, 16.0f});
    EXPECT_TRUE(residency.changed().empty());
    EXPECT_EQ(residency.feedback().resident_bytes, bytes);
    GLint levels = 0;
    glGetTextureParameteriv(residency.name(0), GL_TEXTURE_IMMUTABLE_LEVELS, &levels);
    EXPECT_EQ(levels, 9);
}

}  // namespace
}  // namespace rambla::render
