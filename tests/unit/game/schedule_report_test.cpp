#include "game/schedule_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ecs/schedule.h"

namespace rambla::game {
namespace {

using testing::HasSubstr;

struct Speed {
    float m_s = 0.0f;
};
struct Wind {
    float m_s = 0.0f;
};

NamedPlan small_plan() {
    ecs::Schedule schedule;
    schedule.add("blow", [](ecs::View<Speed>, ecs::Res<Wind>) {});
    schedule.add("look", [](ecs::View<const Speed>, ecs::Commands&) {});
    return {"small", schedule.plan()};
}

TEST(ScheduleReport, JsonTellsSystemsAccessWaitsAndAmbiguities) {
    const nlohmann::json result = plans_json({small_plan()});
    EXPECT_EQ(result["schema"], "rambla.schedule/1");
    const nlohmann::json& schedule = result["schedules"][0];
    EXPECT_EQ(schedule["name"], "small");
    EXPECT_EQ(schedule["stages"], 1);
    const nlohmann::json speed{{"kind", "component"}, {"name", "Speed"}, {"writes", true}};
    EXPECT_EQ(schedule["systems"][0]["access"],
              (nlohmann::json{speed, {{"kind", "resource"}, {"name", "Wind"}, {"writes", false}}}));
    EXPECT_EQ(schedule["systems"][0]["records_changes"], false);
    EXPECT_EQ(schedule["systems"][1]["records_changes"], true);
    const nlohmann::json& wait = schedule["systems"][1]["waits"][0];
    EXPECT_EQ(wait["for"], "blow");
    EXPECT_EQ(wait["declared"], false);
    EXPECT_EQ(wait["because_of"], nlohmann::json::array({speed}));
    EXPECT_EQ(schedule["ambiguities"].size(), 1u);
    EXPECT_EQ(schedule["ambiguities"][0]["second"], "look");
}

TEST(ScheduleReport, TextNamesEachSchedule) {
    EXPECT_THAT(plans_text({small_plan()}), HasSubstr("small\nstage 1 of 1\n  blow\n"));
}

TEST(ScheduleReport, TheEnginesOrderIsDeclared) {
    for (const NamedPlan& named : engine_plans()) {
        EXPECT_FALSE(named.plan.systems.empty());
        EXPECT_TRUE(named.plan.ambiguities.empty()) << plans_text({named});
    }
}

}  // namespace
}  // namespace rambla::game
