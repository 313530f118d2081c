#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ecs/plan.h"

namespace rambla::game {

/// A schedule of the engine, by name.
struct NamedPlan {
    std::string name;
    ecs::Plan plan;
};

/// What runs in a simulation step, and what looks and packs for a picture. Needs no world and no GPU.
[[nodiscard]] std::vector<NamedPlan> engine_plans();

/// For people: each plan under its name.
[[nodiscard]] std::string plans_text(const std::vector<NamedPlan>& plans);

/// For programs: what plans_text says, systems by name.
[[nodiscard]] nlohmann::json plans_json(const std::vector<NamedPlan>& plans);

}  // namespace rambla::game
