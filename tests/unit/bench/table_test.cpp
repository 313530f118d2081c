#include "bench/harness/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/assets/targets.h"
#include "bench/ecs/targets.h"

namespace rambla::bench {
namespace {

using testing::HasSubstr;

constexpr Target k_create{.operation = "create", .solid = 0.75, .goal = 0.4, .reason = "because"};
constexpr Target k_sync{.operation = "sync",
                        .measure = Measure::nanoseconds,
                        .solid = 2000,
                        .goal = 1000,
                        .reason = "",
                        .subject = "rambla_2threads"};
constexpr Target k_parallel{.operation = "parallel",
                            .size = 1000,
                            .measure = Measure::speed_up,
                            .solid = 1.6,
                            .goal = 1.8,
                            .reason = "",
                            .subject = "rambla_2threads",
                            .baseline = "rambla"};
constexpr Target k_memory{.operation = "memory",
                          .measure = Measure::counter,
                          .solid = 48,
                          .goal = 42,
                          .reason = "",
                          .counter = "bytes_per_entity"};

Measurement measured(std::string operation, std::string variant, std::uint64_t size, double ns) {
    return {{std::move(operation), std::move(variant), size}, {ns, ns, ns}, {}};
}

TEST(Judging, TellsGoalSolidAndMissedApartAtTheirLimits) {
    EXPECT_EQ(judge(k_create, 0.40), Verdict::goal);
    EXPECT_EQ(judge(k_create, 0.41), Verdict::solid);
    EXPECT_EQ(judge(k_create, 0.75), Verdict::solid);
    EXPECT_EQ(judge(k_create, 0.76), Verdict::missed);
}

TEST(Judging, WantsASpeedUpToBeLarge) {
    EXPECT_EQ(judge(k_parallel, 1.8), Verdict::goal);
    EXPECT_EQ(judge(k_parallel, 1.79), Verdict::solid);
    EXPECT_EQ(judge(k_parallel, 1.59), Verdict::missed);
}

TEST(Rows, CompareWithTheBareVariantOfTheSameSize) {
    const std::vector<Measurement> all{
        measured("create", "bare", 10, 20), measured("create", "rambla", 10, 10),
        measured("create", "bare", 20, 40), measured("create", "rambla", 20, 36)};
    const std::vector<Row> rows = make_rows(all, {&k_create, 1});
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_DOUBLE_EQ(*rows[0].value, 0.5);
    EXPECT_EQ(rows[0].verdict, Verdict::solid);
    EXPECT_DOUBLE_EQ(*rows[1].value, 0.9);
    EXPECT_DOUBLE_EQ(*rows[1].bare_ns, 40.0);
    EXPECT_EQ(rows[1].verdict, Verdict::missed);
}

TEST(Rows, SayWhenATargetWasNotMeasured) {
    const std::vector<Row> nothing = make_rows({}, {&k_create, 1});
    ASSERT_EQ(nothing.size(), 1u);
    EXPECT_EQ(nothing[0].verdict, Verdict::not_measured);
    EXPECT_THAT(to_text(nothing, Machine{}), HasSubstr("not measured"));

    const Measurement alone = measured("create", "rambla", 10, 10);
    EXPECT_EQ(make_rows({&alone, 1}, {&k_create, 1}).at(0).verdict, Verdict::not_measured)
        << "nothing to compare with";

    const Measurement other_size = measured("parallel", "rambla_2threads", 10, 10);
    EXPECT_EQ(make_rows({&other_size, 1}, {&k_parallel, 1}).at(0).verdict, Verdict::not_measured);
}

TEST(Rows, JudgeTimesCountersAndSpeedUps) {
    std::vector<Measurement> all{
        measured("sync", "rambla_2threads", 1, 1500), measured("parallel", "rambla", 1000, 8),
        measured("parallel", "rambla_2threads", 1000, 4), measured("memory", "rambla", 7, 0)};
    all.back().counters["bytes_per_entity"] = 50;
    const Target targets[]{k_sync, k_parallel, k_memory};
    const std::vector<Row> rows = make_rows(all, targets);
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0].verdict, Verdict::solid);
    EXPECT_DOUBLE_EQ(*rows[1].value, 2.0);
    EXPECT_EQ(rows[1].verdict, Verdict::goal);
    EXPECT_DOUBLE_EQ(*rows[2].value, 50.0);
    EXPECT_EQ(rows[2].verdict, Verdict::missed);
    EXPECT_EQ(rows[3].operation, "parallel");
    EXPECT_EQ(rows[3].verdict, Verdict::no_target);
}

TEST(Rows, JudgeTheBaselinesShareOfTheTime) {
    constexpr Target k_import{
        .operation = "import", .measure = Measure::share, .solid = 0.5, .goal = 0.75, .reason = ""};
    const auto share = [&](double bare_ns) {
        const std::vector<Measurement> all{measured("import", "bare", 3, bare_ns),
                                           measured("import", "rambla", 3, 8)};
        return make_rows(all, {&k_import, 1}).at(0);
    };
    EXPECT_DOUBLE_EQ(*share(6).value, 0.75);
    EXPECT_EQ(share(6).verdict, Verdict::goal);
    EXPECT_EQ(share(4).verdict, Verdict::solid);
    EXPECT_EQ(share(3.9).verdict, Verdict::missed);
    const Row row = share(4);
    EXPECT_THAT(to_text({&row, 1}, Machine{}), HasSubstr("0.50 share"));
    EXPECT_THAT(to_text({&row, 1}, Machine{}), HasSubstr(">= 0.75"));
}

TEST(Report, ShowsRatesOfTheSubject) {
    std::vector<Measurement> all{measured("import", "bare", 3, 1), measured("import", "rambla", 3, 2)};
    all[0].counters = {{"MB/s", 700.0}};
    all[1].counters = {{"MB/s", 512.0}, {"bytes", 7.0}};
    const std::string text = to_text(make_rows(all, {}), Machine{});
    EXPECT_THAT(text, HasSubstr("  512 MB/s\n"));
    EXPECT_THAT(text, testing::Not(HasSubstr("700")));
}

TEST(Rows, ShowWhatHasNoTargetAgainstTheBareVariantWithTheSameSuffix) {
    const std::vector<Measurement> all{measured("wave", "bare", 5, 2),
                                       measured("wave", "bare_2threads", 5, 1),
                                       measured("wave", "rambla_2threads", 5, 3)};
    const std::vector<Row> rows = make_rows(all, {});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].operation, "wave_2threads");
    EXPECT_DOUBLE_EQ(*rows[0].value, 3.0);
}

TEST(Report, KeepsEveryRepetitionInItsJson) {
    const std::vector<Measurement> all{{{"create", "bare", 10}, {20, 22}, {}},
                                       {{"create", "rambla", 10}, {10, 11}, {{"bytes", 3.0}}}};
    const auto json =
        nlohmann::json::parse(to_json(make_rows(all, {&k_create, 1}), all, Machine{{"processor", "P"}}));
    EXPECT_EQ(json["machine"]["processor"], "P");
    EXPECT_EQ(json["rows"][0]["verdict"], "solid");
    EXPECT_EQ(json["rows"][0]["reason"], "because");
    EXPECT_EQ(json["measurements"][1]["ns_per_item"], nlohmann::json({10, 11}));
    EXPECT_EQ(json["measurements"][1]["counters"]["bytes"], 3.0);
}

void expect_ordered(std::span<const Target> targets) {
    for (const Target& target : targets) {
        EXPECT_FALSE(target.reason.empty()) << target.operation;
        EXPECT_EQ(judge(target, target.goal), Verdict::goal) << target.operation;
        EXPECT_EQ(judge(target, target.solid), Verdict::solid) << target.operation;
    }
}

TEST(Targets, AreOrderedAndGiveReasons) {
    expect_ordered(k_ecs_targets);
    expect_ordered(k_assets_targets);
}

}  // namespace
}  // namespace rambla::bench
