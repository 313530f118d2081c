#include "ecs/plan.h"

#include <algorithm>
#include <span>

#include "ecs/misuse.h"

namespace rambla::ecs {
namespace detail {
namespace {

/// Which system comes before which: a square of bits, row before column.
class Before {
public:
    explicit Before(std::size_t count) : count_{count}, bits_(count * count) {}

    void set(std::size_t first, std::size_t second) { bits_[first * count_ + second] = true; }
    [[nodiscard]] bool operator()(std::size_t first, std::size_t second) const {
        return bits_[first * count_ + second];
    }
    /// The same, paths of several steps included (Warshall 1962).
    [[nodiscard]] Before closed() const {
        Before paths = *this;
        for (std::size_t via = 0; via < count_; ++via) {
            for (std::size_t from = 0; from < count_; ++from) {
                if (!paths(from, via)) continue;
                for (std::size_t to = 0; to < count_; ++to) {
                    if (paths(via, to)) paths.set(from, to);
                }
            }
        }
        return paths;
    }

private:
    std::size_t count_;
    std::vector<bool> bits_;
};

std::size_t index_of(const std::vector<DeclaredSystem>& systems, const std::string& name,
                     const DeclaredSystem& asking) {
    const auto found =
        std::find_if(systems.begin(), systems.end(), [&](const auto& system) { return system.name == name; });
    if (found == systems.end()) {
        throw Misuse{"ecs: system \"" + asking.name + "\" is ordered against \"" + name +
                     "\", which the schedule does not have"};
    }
    return static_cast<std::size_t>(found - systems.begin());
}

/// What before() and after() say.
Before declared_order(const std::vector<DeclaredSystem>& systems) {
    Before order{systems.size()};
    const auto add = [&](std::size_t first, std::size_t second) {
        if (systems[first].stage > systems[second].stage) {
            throw Misuse{"ecs: system \"" + systems[first].name + "\" cannot run before \"" +
                         systems[second].name + "\", whose stage comes earlier"};
        }
        order.set(first, second);
    };
    for (std::size_t i = 0; i < systems.size(); ++i) {
        for (const std::string& name : systems[i].before)
            add(i, index_of(systems, name, systems[i]));
        for (const std::string& name : systems[i].after)
            add(index_of(systems, name, systems[i]), i);
    }
    return order;
}

/// Names the shortest way from a system back to itself.
void refuse_cycles(const std::vector<DeclaredSystem>& systems, const Before& order, const Before& paths) {
    for (std::size_t start = 0; start < systems.size(); ++start) {
        if (!paths(start, start)) continue;
        std::string text = "ecs: systems wait for each other: \"" + systems[start].name + "\"";
        std::vector<std::size_t> came_from(systems.size(), systems.size());
        std::vector<std::size_t> reached{start};
        for (std::size_t i = 0; i < reached.size() && came_from[start] == systems.size(); ++i) {
            for (std::size_t to = 0; to < systems.size(); ++to) {
                if (!order(reached[i], to) || came_from[to] != systems.size()) continue;
                came_from[to] = reached[i];
                reached.push_back(to);
            }
        }
        std::vector<std::size_t> way{start};
        for (std::size_t at = came_from[start]; at != start; at = came_from[at])
            way.push_back(at);
        for (auto step = way.rbegin(); step != way.rend(); ++step)
            text += " before \"" + systems[*step].name + "\"";
        throw Misuse{text};
    }
}

/// As declared, but what must come before a system is placed right before it. There are no cycles.
class SingleThreadOrder {
public:
    SingleThreadOrder(std::size_t count, const Before& declared) : declared_{declared}, placed_(count) {
        for (std::size_t i = 0; i < count; ++i)
            place(i);
    }

    std::vector<std::size_t> order;

private:
    void place(std::size_t system) {
        if (placed_[system]) return;
        placed_[system] = true;
        for (std::size_t earlier = 0; earlier < placed_.size(); ++earlier) {
            if (declared_(earlier, system)) place(earlier);
        }
        order.push_back(system);
    }

    const Before& declared_;
    std::vector<bool> placed_;
};

std::vector<PlannedSystem> placed(const std::vector<DeclaredSystem>& systems,
                                  std::span<const std::size_t> order) {
    std::vector<PlannedSystem> placed;
    for (const std::size_t i : order)
        placed.push_back({systems[i].name, systems[i].stage, systems[i].access, {}});
    return placed;
}

}  // namespace

MadePlan make_plan(const std::vector<DeclaredSystem>& systems) {
    const Before declared = declared_order(systems);
    const Before paths = declared.closed();
    refuse_cycles(systems, declared, paths);

    MadePlan made;
    made.declared = SingleThreadOrder{systems.size(), declared}.order;
    Plan& plan = made.plan;
    plan.systems = placed(systems, made.declared);
    plan.stage_count = plan.systems.empty() ? 0 : plan.systems.back().stage + 1;

    const std::size_t count = systems.size();
    std::vector<std::vector<PlannedWait>> all(count);
    Before steps{count};
    for (std::size_t second = 0; second < count; ++second) {
        for (std::size_t first = 0; first < second; ++first) {
            if (plan.systems[first].stage != plan.systems[second].stage) continue;
            const std::size_t from = made.declared[first];
            const std::size_t to = made.declared[second];
            Conflict conflict = conflict_between(plan.systems[first].access, plan.systems[second].access);
            if (!conflict.any() && !declared(from, to)) continue;
            if (!paths(from, to)) plan.ambiguities.push_back({first, second, conflict});
            all[second].push_back({first, declared(from, to), std::move(conflict)});
            steps.set(first, second);
        }
    }
    const Before reach = steps.closed();
    for (std::size_t second = 0; second < count; ++second) {
        for (PlannedWait& wait : all[second]) {
            const bool implied =
                std::any_of(all[second].begin(), all[second].end(),
                            [&](const PlannedWait& other) { return reach(wait.system, other.system); });
            if (!implied) plan.systems[second].waits.push_back(std::move(wait));
        }
    }
    return made;
}

}  // namespace detail

namespace {

std::string list(std::span<const AccessPart> parts, bool writes) {
    std::string text;
    for (const AccessPart& part : parts) {
        if (part.writes != writes) continue;
        text += text.empty() ? "" : ", ";
        text += short_name(part.name);
        if (part.kind != AccessKind::component) text.append(" (").append(to_string(part.kind)).append(")");
    }
    return text;
}

std::string reason(const Conflict& conflict, bool declared) {
    std::string text;
    if (conflict.exclusive) text = "one has the world for itself";
    for (const AccessPart& part : conflict.parts) {
        text += text.empty() ? "" : ", ";
        text.append(short_name(part.name)).append(part.writes ? " written" : " read").append(" before");
    }
    if (declared) text += text.empty() ? "declared" : ", declared";
    return text;
}

std::string access_text(const AccessSet& access) {
    std::string text;
    const auto add = [&](std::string_view verb, const std::string& things) {
        if (!things.empty()) text.append("    ").append(verb).append(" ").append(things).append("\n");
    };
    if (access.everything()) add("has", "the world for itself");
    add("reads ", list(access.parts(), false));
    add("writes", list(access.parts(), true));
    if (access.commands()) add("records", "structural changes");
    return text;
}

}  // namespace

std::string short_name(std::string_view type_name) {
    constexpr std::string_view k_nameless = "(anonymous namespace)";  // as Clang writes it
    std::string text;
    std::size_t begin = 0;  // of the name that is being read, in text
    for (std::size_t i = 0; i < type_name.size(); ++i) {
        if (type_name.substr(i).starts_with(k_nameless)) {
            i += k_nameless.size() - 1;
        } else if (type_name.substr(i).starts_with("::")) {
            text.resize(begin);
            ++i;
        } else {
            text += type_name[i];
            if (std::string_view{"<>, *&()"}.find(type_name[i]) != std::string_view::npos)
                begin = text.size();
        }
    }
    return text;
}

std::string to_text(const Plan& plan) {
    std::string text;
    for (std::size_t i = 0; i < plan.systems.size(); ++i) {
        const PlannedSystem& system = plan.systems[i];
        if (i == 0 || plan.systems[i - 1].stage != system.stage) {
            text += "stage " + std::to_string(system.stage + 1) + " of " + std::to_string(plan.stage_count) +
                    "\n";
        }
        text += "  " + system.name + "\n" + access_text(system.access);
        for (const PlannedWait& wait : system.waits) {
            text += "    waits for " + plan.systems[wait.system].name + ": " +
                    reason(wait.conflict, wait.declared) + "\n";
        }
    }
    text += plan.ambiguities.empty() ? "no ambiguities\n" : "ordered by declaration only\n";
    for (const Ambiguity& ambiguity : plan.ambiguities) {
        text += "  " + plan.systems[ambiguity.first].name + " before " + plan.systems[ambiguity.second].name +
                ": " + reason(ambiguity.conflict, false) + "\n";
    }
    return text;
}

}  // namespace rambla::ecs
