#pragma once

#include <string>
#include <utility>

#include "ecs/observers.h"
#include "unit/ecs/parts.h"

namespace rambla::ecs::test {

/// Writes down what observers of Health, Burning and Frozen are told: "+h 3" for an entity that gets 3
/// points.
class Diary {
public:
    explicit Diary(World& world) {
        Observers& observers = world.observers();
        observers.on_add<Health>([this](Entity, const Health& health) { note("+h", health.points); });
        observers.on_set<Health>([this](Entity, const Health& health) { note("=h", health.points); });
        observers.on_remove<Health>([this](Entity, const Health& health) { note("-h", health.points); });
        observers.on_add<Burning>([this](Entity, const Burning& burning) { note("+b", burning.heat); });
        observers.on_set<Burning>([this](Entity, const Burning& burning) { note("=b", burning.heat); });
        observers.on_remove<Burning>([this](Entity, const Burning& burning) { note("-b", burning.heat); });
        observers.on_add<Frozen>([this](Entity entity) { note("+f", static_cast<int>(entity.index)); });
        observers.on_remove<Frozen>([this](Entity entity) { note("-f", static_cast<int>(entity.index)); });
    }

    /// What was noted since the last call, in one line.
    std::string read() { return std::exchange(text_, {}); }

private:
    void note(const char* what, int number) {
        if (!text_.empty()) text_ += ", ";
        text_.append(what).append(" ").append(std::to_string(number));
    }

    std::string text_;
};

}  // namespace rambla::ecs::test
