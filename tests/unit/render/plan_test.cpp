#include "render/graph/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace rambla::render::graph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::uint32_t transient(Recording& frame, std::uint32_t layout = 0) {
    return frame.add_resource({.layout = layout});
}
std::uint32_t kept(Recording& frame) {
    return frame.add_resource({.transient = false, .keep = true});
}

/// A pass that reads `from` (unless none) and draws all of `to`.
std::uint32_t draw(Recording& frame, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t pass = frame.add_pass();
    if (from != k_none) frame.read(pass, from, Use::sampled);
    return frame.write(pass, to, Use::attachment, false);
}

TEST(RenderGraphPlan, RunsOnlyWhatLeadsToAKeptResource) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t a = draw(frame, k_none, transient(frame));  // 0
    const std::uint32_t unread = draw(frame, a, transient(frame));  // 1
    static_cast<void>(draw(frame, unread, transient(frame)));       // 2
    static_cast<void>(draw(frame, a, screen));                      // 3
    Planner planner;
    EXPECT_THAT(planner.plan(frame).order, ElementsAre(0, 3));
}

TEST(RenderGraphPlan, KeepsPassesWithSideEffectsAndWhatTheyRead) {
    Recording frame;
    const std::uint32_t a = draw(frame, k_none, transient(frame));
    const std::uint32_t capture = frame.add_pass();
    frame.read(capture, a, Use::transfer);
    Planner planner;
    EXPECT_THAT(planner.plan(frame).order, IsEmpty());
    frame.passes[capture].side_effect = true;
    EXPECT_THAT(planner.plan(frame).order, ElementsAre(0, 1));
}

TEST(RenderGraphPlan, CullsAWriterWhoseWorkIsClearedAwayUnread) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t first = draw(frame, k_none, screen);
    static_cast<void>(draw(frame, k_none, first));
    Planner planner;
    EXPECT_THAT(planner.plan(frame).order, ElementsAre(1));
}

TEST(RenderGraphPlan, KeepsAWriterWhoseWorkIsLoaded) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t first = draw(frame, k_none, screen);
    const std::uint32_t hud = frame.add_pass();
    static_cast<void>(frame.write(hud, first, Use::attachment, true));
    Planner planner;
    EXPECT_THAT(planner.plan(frame).order, ElementsAre(0, 1));
}

TEST(RenderGraphPlan, MovesALateReaderBeforeTheNextWriter) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t scene = draw(frame, k_none, transient(frame));  // 0
    const std::uint32_t blend = frame.add_pass();                       // 1 draws over the scene
    const std::uint32_t blended = frame.write(blend, scene, Use::attachment, true);
    const std::uint32_t late = draw(frame, scene, transient(frame));  // 2 wants the scene without blending
    const std::uint32_t last = frame.add_pass();                      // 3
    frame.read(last, blended, Use::sampled);
    frame.read(last, late, Use::sampled);
    static_cast<void>(frame.write(last, screen, Use::attachment, false));
    Planner planner;
    EXPECT_THAT(planner.plan(frame).order, ElementsAre(0, 2, 1, 3));
}

TEST(RenderGraphPlan, KeepsTheRecordedOrderWhereNothingForbidsIt) {
    Recording frame;
    for (int i = 0; i < 6; ++i)
        static_cast<void>(draw(frame, k_none, kept(frame)));
    Planner planner;
    EXPECT_THAT(planner.plan(frame).order, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(RenderGraphPlan, RefusesACircle) {
    Recording frame;
    const std::uint32_t a0 = draw(frame, k_none, kept(frame));
    const std::uint32_t b0 = draw(frame, k_none, kept(frame));
    const std::uint32_t first = frame.add_pass();  // replaces a, wants the old b
    frame.read(first, b0, Use::sampled);
    static_cast<void>(frame.write(first, a0, Use::attachment, false));
    const std::uint32_t second = frame.add_pass();  // replaces b, wants the old a
    frame.read(second, a0, Use::sampled);
    static_cast<void>(frame.write(second, b0, Use::attachment, false));
    Planner planner;
    EXPECT_THROW(static_cast<void>(planner.plan(frame)), std::logic_error);
}

TEST(RenderGraphPlan, RefusesWritingToReplacedContentsAndReadingUnwrittenOnes) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    static_cast<void>(draw(frame, k_none, screen));
    EXPECT_THROW(static_cast<void>(draw(frame, k_none, screen)), std::logic_error);
    const std::uint32_t pass = frame.add_pass();
    EXPECT_THROW(frame.read(pass, transient(frame), Use::sampled), std::logic_error);
    EXPECT_THROW(static_cast<void>(frame.write(pass, transient(frame), Use::attachment, true)),
                 std::logic_error);
    EXPECT_THROW(frame.read(pass, k_none, Use::sampled), std::logic_error);
}

TEST(RenderGraphPlan, SharesMemoryBetweenLifetimesThatDoNotOverlap) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t a = draw(frame, k_none, transient(frame));
    const std::uint32_t b = draw(frame, a, transient(frame));
    const std::uint32_t c = draw(frame, b, transient(frame));  // a is dead by now
    static_cast<void>(draw(frame, c, screen));
    Planner planner;
    const Plan& plan = planner.plan(frame);
    EXPECT_EQ(plan.slot_layouts.size(), 2u);
    EXPECT_EQ(plan.lifetimes[1].slot, plan.lifetimes[3].slot);
    EXPECT_NE(plan.lifetimes[1].slot, plan.lifetimes[2].slot);
    EXPECT_EQ(plan.lifetimes[0].slot, k_none) << "imported textures have memory of their own";
}

TEST(RenderGraphPlan, NeverSharesMemoryBetweenLayouts) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t a = draw(frame, k_none, transient(frame, 0));
    const std::uint32_t b = draw(frame, a, transient(frame, 1));
    const std::uint32_t c = draw(frame, b, transient(frame, 2));
    static_cast<void>(draw(frame, c, screen));
    Planner planner;
    EXPECT_EQ(planner.plan(frame).slot_layouts.size(), 3u);
}

TEST(RenderGraphPlan, PutsABarrierOfTheReadersKindBehindStorageWrites) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t fill = frame.add_pass();
    const std::uint32_t list = frame.write(fill, transient(frame), Use::storage, true);
    const std::uint32_t first = frame.add_pass();
    frame.read(first, list, Use::indirect);
    frame.passes[first].side_effect = true;
    const std::uint32_t second = frame.add_pass();
    frame.read(second, list, Use::indirect);
    frame.read(second, list, Use::storage);
    static_cast<void>(frame.write(second, screen, Use::attachment, false));
    Planner planner;
    const Plan& plan = planner.plan(frame);
    EXPECT_THAT(plan.order, ElementsAre(0, 1, 2));
    EXPECT_THAT(plan.barriers, ElementsAre(0u, mask_of(Use::indirect), mask_of(Use::storage)))
        << "the first reader's barrier has served the second's indirect read already";
}

TEST(RenderGraphPlan, NeedsNoBarrierBehindAttachments) {
    Recording frame;
    const std::uint32_t a = draw(frame, k_none, transient(frame));
    static_cast<void>(draw(frame, a, kept(frame)));
    Planner planner;
    EXPECT_THAT(planner.plan(frame).barriers, ElementsAre(0u, 0u));
}

TEST(RenderGraphPlan, PutsABarrierBeforeTheNextTenantOfMemoryWithIncoherentWrites) {
    Recording frame;
    const std::uint32_t screen = kept(frame);
    const std::uint32_t fill = frame.add_pass();
    const std::uint32_t image = frame.write(fill, transient(frame), Use::image, true);
    const std::uint32_t b = draw(frame, image, transient(frame));
    const std::uint32_t tenant = draw(frame, b, transient(frame));  // moves into the image's memory
    static_cast<void>(draw(frame, tenant, screen));
    Planner planner;
    const Plan& plan = planner.plan(frame);
    ASSERT_EQ(plan.lifetimes[1].slot, plan.lifetimes[3].slot);
    EXPECT_EQ(plan.barriers[2], mask_of(Use::attachment));
}

/// Random frames, checked against the definitions rather than against another implementation.
class RandomFrames : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomFrames, AreOrderedAndPlacedSafely) {
    std::mt19937 random{GetParam()};
    const auto below = [&](std::size_t n) {
        return static_cast<std::uint32_t>(random() % n);
    };
    Recording frame;
    static_cast<void>(kept(frame));
    for (int r = 0; r < 8; ++r)
        transient(frame, below(2));
    std::vector<std::uint32_t> written;
    for (std::uint32_t p = 0; p < 24; ++p) {
        const std::uint32_t pass = frame.add_pass();
        for (std::uint32_t reads = below(3); reads > 0 && !written.empty(); --reads) {
            // Only newest contents: others may well be part of a circle.
            const std::uint32_t version = written[below(written.size())];
            if (frame.versions[version].next == k_none) frame.read(pass, version, Use::sampled);
        }
        const std::uint32_t target = frame.resources[below(frame.resources.size())].latest;
        const bool has_contents = frame.versions[target].writer != k_none;
        written.push_back(frame.write(pass, target, Use::attachment, has_contents && below(2) == 0));
    }
    Planner planner;
    const Plan& plan = planner.plan(frame);

    std::vector<std::uint32_t> position(frame.passes.size(), k_none);
    for (std::uint32_t i = 0; i < plan.order.size(); ++i)
        position[plan.order[i]] = i;
    std::vector<std::uint32_t> contents(frame.resources.size(),
                                        k_none);  // version that memory holds as passes run
    for (const std::uint32_t p : plan.order) {
        const Pass& pass = frame.passes[p];
        for (std::uint32_t a = pass.first_access; a < pass.first_access + pass.access_count; ++a) {
            const Access& access = frame.accesses[a];
            if (access.reads == k_none) continue;
            ASSERT_NE(position[frame.versions[access.reads].writer], k_none)
                << "a writer that is needed was culled";
            ASSERT_EQ(contents[frame.versions[access.reads].resource], access.reads)
                << "pass " << p << " would read other contents than it declared";
        }
        for (std::uint32_t a = pass.first_access; a < pass.first_access + pass.access_count; ++a) {
            const Access& access = frame.accesses[a];
            if (access.writes != k_none) contents[frame.versions[access.writes].resource] = access.writes;
        }
    }
    for (std::size_t a = 0; a < plan.lifetimes.size(); ++a) {
        for (std::size_t b = a + 1; b < plan.lifetimes.size(); ++b) {
            const Lifetime& one = plan.lifetimes[a];
            const Lifetime& other = plan.lifetimes[b];
            if (one.slot == k_none || one.slot != other.slot) continue;
            EXPECT_TRUE(one.last < other.first || other.last < one.first) << "tenants of one slot overlap";
            EXPECT_EQ(frame.resources[a].layout, frame.resources[b].layout);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(RenderGraphPlan, RandomFrames, testing::Range(1u, 101u));

}  // namespace
}  // namespace rambla::render::graph
