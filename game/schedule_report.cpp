#include "game/schedule_report.h"

#include <nlohmann/json.hpp>
#include <span>

#include "systems/looking.h"
#include "systems/simulation.h"

namespace rambla::game {
namespace {

nlohmann::json to_json(std::span<const ecs::AccessPart> parts) {
    nlohmann::json list = nlohmann::json::array();
    for (const ecs::AccessPart& part : parts) {
        list.push_back({{"kind", ecs::to_string(part.kind)},
                        {"name", ecs::short_name(part.name)},
                        {"writes", part.writes}});
    }
    return list;
}

nlohmann::json to_json(const ecs::Plan& plan, const ecs::PlannedSystem& system) {
    nlohmann::json waits = nlohmann::json::array();
    for (const ecs::PlannedWait& wait : system.waits) {
        waits.push_back({{"for", plan.systems[wait.system].name},
                         {"declared", wait.declared},
                         {"exclusive", wait.conflict.exclusive},
                         {"because_of", to_json(wait.conflict.parts)}});
    }
    return {{"name", system.name},
            {"stage", system.stage},
            {"exclusive", system.access.everything()},
            {"records_changes", system.access.commands()},
            {"access", to_json(system.access.parts())},
            {"waits", waits}};
}

nlohmann::json to_json(const NamedPlan& named) {
    const ecs::Plan& plan = named.plan;
    nlohmann::json systems = nlohmann::json::array();
    for (const ecs::PlannedSystem& system : plan.systems)
        systems.push_back(to_json(plan, system));
    nlohmann::json ambiguities = nlohmann::json::array();
    for (const ecs::Ambiguity& ambiguity : plan.ambiguities) {
        ambiguities.push_back({{"first", plan.systems[ambiguity.first].name},
                               {"second", plan.systems[ambiguity.second].name},
                               {"because_of", to_json(ambiguity.conflict.parts)}});
    }
    return {{"name", named.name},
            {"stages", plan.stage_count},
            {"systems", systems},
            {"ambiguities", ambiguities}};
}

}  // namespace

std::vector<NamedPlan> engine_plans() {
    return {{"simulation", systems::make_simulation().schedule->plan()},
            {"looking", systems::make_looking().schedule->plan()}};
}

std::string plans_text(const std::vector<NamedPlan>& plans) {
    std::string text;
    for (const NamedPlan& named : plans) {
        if (!text.empty()) text += "\n";
        text += named.name + "\n" + ecs::to_text(named.plan);
    }
    return text;
}

nlohmann::json plans_json(const std::vector<NamedPlan>& plans) {
    nlohmann::json schedules = nlohmann::json::array();
    for (const NamedPlan& named : plans)
        schedules.push_back(to_json(named));
    return {{"schema", "rambla.schedule/1"}, {"schedules", schedules}};
}

}  // namespace rambla::game
