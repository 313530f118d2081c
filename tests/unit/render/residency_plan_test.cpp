#include "render/residency_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "systems/frame.h"

namespace rambla::render {
namespace {

using Levels = std::vector<std::uint8_t>;
constexpr std::uint8_t k_none = systems::k_not_demanded;

/// A square image: level `floor` takes 64 bytes with all that is coarser, and each finer one four times as
/// much.
ImageLevels image_of(std::uint8_t floor, std::uint8_t exact = 20) {
    ImageLevels image{.floor = floor, .exact = exact, .chain_bytes = {}};
    for (std::uint8_t level = 0; level <= floor; ++level) {
        std::uint64_t bytes = 64;
        for (std::uint64_t side = 64; side < std::uint64_t{64} << 2u * (floor - level); side *= 4)
            bytes += 4 * side;
        image.chain_bytes.push_back(bytes);
    }
    return image;
}
// Level 1 takes 320 bytes, and level 0 1344.
constexpr std::uint64_t k_floor = 64, k_middle = 320, k_fine = 1344;

std::uint64_t bytes_of(const ResidencyPlan& plan, std::span<const std::uint8_t> levels) {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < levels.size(); ++i)
        bytes += plan.images()[i].chain_bytes[levels[i]];
    return bytes;
}

/// Aims again and again, as if all loads were done between two frames, with what is resident for a start.
Levels aim(ResidencyPlan& plan, const Levels& demand, Levels resident, std::uint64_t budget,
           std::uint64_t frames = 1) {
    for (std::uint64_t i = 0; i < frames; ++i) {
        plan.aim(demand, resident, Levels(demand.size(), 0), budget);
        resident.assign(plan.targets().begin(), plan.targets().end());
    }
    return resident;
}

/// A budget for what is resident, with room for what it takes to get there.
std::uint64_t budget_for(std::uint64_t resident, std::uint64_t replaced) {
    return resident + replaced + k_floor;
}

TEST(ResidencyPlan, GivesEveryoneWhatIsNeededAndNoMore) {
    ResidencyPlan plan{{image_of(2), image_of(2), image_of(0), image_of(2), image_of(2)}};
    EXPECT_EQ(aim(plan, {1, k_none, 0, 7, 0}, {2, 2, 0, 2, 2}, 1'000'000), (Levels{1, 2, 0, 2, 0}));
}

TEST(ResidencyPlan, KeepsExactHalvesAlone) {
    ResidencyPlan plan{{image_of(4, 1), image_of(4, 1), image_of(4, 1)}};
    EXPECT_EQ(aim(plan, {3, 0, k_none}, {4, 4, 4}, 1'000'000), (Levels{1, 0, 4}));
    // 5440 bytes for level 1 of five; without room for it, what is needed comes before exactness.
    ResidencyPlan tight{{image_of(4, 1), image_of(4)}};
    EXPECT_EQ(aim(tight, {4, 1}, {4, 4}, budget_for(5440 + k_middle, k_floor)), (Levels{3, 1}));
}

TEST(ResidencyPlan, SpendsFirstWhereMostIsMissing) {
    ResidencyPlan plan{{image_of(2), image_of(2), image_of(2)}};
    const std::uint64_t budget = budget_for(3 * k_middle, k_floor);
    EXPECT_EQ(aim(plan, {1, 0, 0}, {2, 2, 2}, budget - 3 * k_middle + 2 * k_middle + k_floor),
              (Levels{2, 1, 1}));
    EXPECT_EQ(aim(plan, {1, 0, 0}, {2, 2, 2}, budget), (Levels{1, 1, 1}));
}

TEST(ResidencyPlan, NeverExceedsTheBudgetWhateverIsDemanded) {
    std::mt19937 random{1};
    const auto below = [&](std::uint32_t count) {
        return std::uniform_int_distribution<std::uint32_t>{0, count - 1}(random);
    };
    for (int run = 0; run < 60; ++run) {
        std::vector<ImageLevels> images;
        Levels resident, floors;
        for (std::uint32_t i = 0, count = 1 + below(40); i < count; ++i) {
            images.push_back(
                image_of(static_cast<std::uint8_t>(below(6)), static_cast<std::uint8_t>(below(6))));
            floors.push_back(images.back().floor);
        }
        resident = floors;
        ResidencyPlan plan{images};
        const std::uint64_t all = std::accumulate(
            images.begin(), images.end(), std::uint64_t{0},
            [](std::uint64_t sum, const ImageLevels& image) { return sum + image.chain_bytes[0]; });
        const std::uint64_t budget =
            plan.floor_bytes() + k_floor + below(static_cast<std::uint32_t>(all + 1));
        for (int frame = 0; frame < 80; ++frame) {
            Levels demand;
            for (std::size_t i = 0; i < images.size(); ++i)
                demand.push_back(below(3) == 0 ? k_none : static_cast<std::uint8_t>(below(8)));
            plan.aim(demand, resident, Levels(demand.size(), 0), budget);
            std::uint64_t replaced = 0;
            for (std::size_t i = 0; i < images.size(); ++i) {
                ASSERT_LE(plan.targets()[i], floors[i]) << "floors stay";
                if (plan.targets()[i] < resident[i])
                    replaced = std::max(replaced, images[i].chain_bytes[resident[i]]);
            }
            // The last texture to arrive lies beside the one that it replaces.
            ASSERT_LE(bytes_of(plan, plan.targets()) + replaced, plan.limit(budget));
            const Levels targets{plan.targets().begin(), plan.targets().end()};
            // Only some arrive before the next frame.
            for (std::size_t i = 0; i < images.size(); ++i)
                if (below(2) == 0) resident[i] = targets[i];
        }
    }
}

TEST(ResidencyPlan, RestsAsLongAsTheDemandDoes) {
    std::mt19937 random{2};
    const auto below = [&](std::uint32_t count) {
        return std::uniform_int_distribution<std::uint32_t>{0, count - 1}(random);
    };
    for (int run = 0; run < 300; ++run) {
        std::vector<ImageLevels> images;
        Levels resident, demand;
        for (std::uint32_t i = 0; i < 12; ++i) {
            images.push_back(image_of(static_cast<std::uint8_t>(below(5))));
            resident.push_back(static_cast<std::uint8_t>(below(images.back().floor + 1u)));
            demand.push_back(below(4) == 0 ? k_none : static_cast<std::uint8_t>(below(5)));
        }
        ResidencyPlan plan{images};
        const std::uint64_t budget = plan.floor_bytes() + below(60'000);
        const Levels settled = aim(plan, demand, resident, budget, 2);
        ASSERT_EQ(aim(plan, demand, settled, budget, 2 * ResidencyPlan::k_hold_frames), settled) << run;
    }
}

TEST(ResidencyPlan, DoesNotSwapWhatIsNeededInTurns) {
    ResidencyPlan plan{{image_of(2), image_of(2)}};
    // Either fits, both do not.
    const std::uint64_t budget = budget_for(k_fine + k_middle, k_floor);
    Levels resident = aim(plan, {0, k_none}, {2, 2}, budget);
    EXPECT_EQ(resident[0], 0);
    for (int frame = 0; frame < 100; ++frame) {
        resident = aim(plan, frame % 2 == 0 ? Levels{k_none, 0} : Levels{0, k_none}, resident, budget);
        ASSERT_EQ(resident[0], 0) << frame;
    }
    resident = aim(plan, {k_none, 0}, resident, budget, ResidencyPlan::k_hold_frames + 1);
    EXPECT_EQ(resident[1], 0) << "what is needed no longer goes at last";
}

TEST(ResidencyPlan, SpendsNothingOnLevelsThatCannotBeHad) {
    ResidencyPlan plan{{image_of(2), image_of(2)}};
    const std::uint64_t room_for_one = budget_for(k_floor + k_fine, k_floor);
    plan.aim(Levels{0, 0}, Levels{2, 2}, Levels{2, 0}, room_for_one);
    EXPECT_EQ(plan.targets()[0], 2);
    EXPECT_EQ(plan.targets()[1], 0);
    EXPECT_EQ(plan.needed()[0], 2);
    plan.aim(Levels{0, 0}, Levels{2, 2}, Levels{1, 0}, budget_for(k_middle + k_fine, k_floor));
    EXPECT_EQ(plan.targets()[0], 1);
    EXPECT_EQ(plan.targets()[1], 0);
}

TEST(ResidencyPlan, KeepsWhatNobodyNeedsWhileThereIsRoom) {
    ResidencyPlan plan{{image_of(2), image_of(2)}};
    const Levels fine = aim(plan, {0, 0}, {2, 2}, 1'000'000);
    EXPECT_EQ(aim(plan, {k_none, k_none}, fine, 1'000'000, 1000), fine);
}

TEST(ResidencyPlan, LetsGoFirstOfWhatWasNeededLeastRecently) {
    ResidencyPlan plan{{image_of(2), image_of(2), image_of(2), image_of(2)}};
    const std::uint64_t budget = budget_for(3 * k_fine + k_floor, k_floor);
    constexpr std::uint64_t k_long = 2 * ResidencyPlan::k_hold_frames;
    Levels resident = aim(plan, {k_none, 0, k_none, k_none}, {2, 2, 2, 2}, budget, k_long);
    resident = aim(plan, {0, k_none, k_none, k_none}, resident, budget, k_long);
    resident = aim(plan, {k_none, k_none, 0, k_none}, resident, budget, k_long);
    EXPECT_EQ(resident, (Levels{0, 0, 0, 2}));
    resident = aim(plan, {k_none, k_none, k_none, 0}, resident, budget, k_long);
    EXPECT_EQ(resident[3], 0);
    EXPECT_EQ(resident[2], 0) << "needed last";
    EXPECT_EQ(resident[0], 0);
    EXPECT_GT(resident[1], 0) << "needed first";
}

TEST(ResidencyPlan, KeepsTheFloorsOfABudgetThatIsTooSmall) {
    ResidencyPlan plan{{image_of(2), image_of(2)}};
    EXPECT_EQ(plan.floor_bytes(), 2 * k_floor);
    for (const std::uint64_t budget : {std::uint64_t{0}, k_floor, 2 * k_floor})
        EXPECT_EQ(aim(plan, {0, 0}, {2, 2}, budget), (Levels{2, 2}));
}

TEST(ResidencyPlan, IsTheSameForTheSameCalls) {
    std::mt19937 random{3};
    std::vector<ImageLevels> images(20, image_of(4));
    ResidencyPlan one{images}, other{images};
    Levels resident(20, 4);
    for (int frame = 0; frame < 50; ++frame) {
        Levels demand;
        for (int i = 0; i < 20; ++i)
            demand.push_back(static_cast<std::uint8_t>(random() % 6));
        one.aim(demand, resident, Levels(demand.size(), 0), 40'000);
        other.aim(demand, resident, Levels(demand.size(), 0), 40'000);
        ASSERT_TRUE(std::equal(one.targets().begin(), one.targets().end(), other.targets().begin()));
        resident.assign(one.targets().begin(), one.targets().end());
    }
}

}  // namespace
}  // namespace rambla::render
