#include "property/ecs/random_systems.h"

#include <utility>

#include "ecs/hierarchy.h"
#include "ecs/query.h"
#include "property/ecs/parts.h"

namespace rambla::ecs::property {
namespace {

/// Some number that follows from others, after little or much work: so that some loops are worth sharing
/// among threads and others are not.
std::uint32_t mix(std::uint32_t k, std::uint32_t a, std::uint32_t b) {
    std::uint32_t hash = a * 0x9e3779b9u + b + k;
    for (std::uint32_t rounds = k % 4 == 0 ? 100 : 1; rounds > 0; --rounds)
        hash = (hash ^ (hash >> 15u)) * 0x2c1b3c6du + k;
    return hash ^ (hash >> 13u);
}
std::uint32_t bits(const Health& health) {
    return static_cast<std::uint32_t>(health.points);
}
std::uint32_t bits(const Score& score) {
    return static_cast<std::uint32_t>(score.points);
}
std::uint32_t bits(const Position& position) {
    return static_cast<std::uint32_t>(position.x);
}

// What systems do to a row.

struct Hurt {
    static void row(std::uint32_t k, Health& health, const Score& score) {
        health.points = static_cast<int>(mix(k, bits(health), bits(score)) >> 1u);
    }
};
struct Walk {
    static void row(std::uint32_t k, Position& position, const Health& health) {
        position.x = static_cast<float>(mix(k, bits(position), bits(health)) >> 9u);
    }
};
struct Rate {
    static void row(std::uint32_t k, Entity entity, Score& score, const Health& health) {
        score.points = static_cast<int>(mix(k, entity.index, bits(health) + bits(score)) >> 1u);
    }
};
struct Glow {
    static void row(std::uint32_t k, Light& light, const Position& position) {
        light.lux = static_cast<float>(mix(k, static_cast<std::uint32_t>(light.lux), bits(position)) >> 9u);
    }
};
struct Heat {
    static void row(std::uint32_t k, Burning& burning, const Score* score) {
        const std::uint32_t other = score != nullptr ? bits(*score) : k;
        burning.heat = static_cast<int>(mix(k, static_cast<std::uint32_t>(burning.heat), other) >> 1u);
    }
};
struct Fill {
    static void row(std::uint32_t k, Byte& byte, Entity entity) {
        byte.value = static_cast<std::uint8_t>(mix(k, byte.value, entity.generation));
    }
};
struct Follow {
    static void row(std::uint32_t k, Position& position) {
        position.x = static_cast<float>((bits(position) + k) % 1000);
    }
};
struct Paint {
    static void row(std::uint32_t k, const Material& material, Score& score) {
        score.points = static_cast<int>(mix(k, material.number, bits(score)) >> 1u);
    }
};

// What they record.

struct Breed {
    static void row(std::uint32_t k, Commands& commands, Entity entity, const Health& health) {
        const std::uint32_t n = mix(k, bits(health), entity.index);
        if (n % 97 != 0) return;
        const Entity child = commands.create(Score{static_cast<int>(n >> 1u)}, Parent{entity});
        if (n % 2 == 0) commands.add(child, Health{1});
        commands.create(Byte{}, Parent{child}, Light{});
    }
};
struct Cull {
    static void row(std::uint32_t k, Commands& commands, Entity entity, const Score& score) {
        if (mix(k, bits(score), entity.index) % 61 == 0) commands.destroy(entity);
    }
};
struct Freeze {
    static void row(std::uint32_t k, Commands& commands, Entity entity, const Health& health) {
        const std::uint32_t n = mix(k, bits(health), entity.index);
        if (n % 5 == 0) commands.add(entity, Frozen{});
        if (n % 7 == 0) commands.add(entity, Burning{static_cast<int>(n >> 1u)});
        if (n % 11 == 0) commands.add(entity, Material{n >> 30u});
    }
};
struct Thaw {
    static void row(std::uint32_t k, Commands& commands, Entity entity) {
        if (mix(k, entity.index, 0) % 3 == 0) commands.remove<Frozen>(entity);
    }
};
struct Quench {
    static void row(std::uint32_t k, Commands& commands, Entity entity, const Burning& burning) {
        const std::uint32_t n = mix(k, entity.index, static_cast<std::uint32_t>(burning.heat));
        if (n % 3 == 0) commands.remove<Burning>(entity);
        if (n % 4 == 0) commands.add(entity, Selected{});
        if (n % 9 == 0) commands.add(entity, Position{});
    }
};

/// Jobs and the system itself give the same entities different bytes: those of the jobs stay.
void claim(std::uint32_t k, Commands& commands, Entity entity, std::uint8_t byte) {
    if (mix(k, entity.index, 2) % 13 == 0) commands.add(entity, Byte{byte});
}

/// Whole archetypes, from one place in the recording.
void sweep(std::uint32_t k, Commands& commands) {
    switch (k % 5) {
        case 0:
            return commands.add_to_all<Hidden, With<Frozen>>();
        case 1:
            return commands.remove_from_all<Hidden>();
        case 2:
            return commands.add_to_all<Light, With<Hidden>>({static_cast<float>(k % 100)});
        case 3:
            return commands.remove_from_all<Light, With<Byte>>();
        default:
            return commands.destroy_all<With<Hidden>, With<Byte>>();
    }
}

/// With the world for itself.
void meddle(std::uint32_t k, World& world) {
    std::vector<Entity> met;
    Query<Entity, const Health> all;
    all.each(world, [&](Entity entity, const Health& health) {
        if (mix(k, bits(health), entity.index) % 37 == 0) met.push_back(entity);
    });
    for (const Entity entity : met) {
        if (world.has<Light>(entity)) world.set_enabled<Light>(entity, k % 2 == 0);
        if (entity.index % 3 == 0) world.destroy(entity);
        if (entity.index % 3 == 1) world.add(entity, Byte{static_cast<std::uint8_t>(k)});
        if (entity.index % 4 == 1) world.create(Health{static_cast<int>(entity.index)}, Score{});
    }
    if (k % 8 == 0) world.compact();
}

template <class Row, class... Terms>
constexpr SystemKind rows(std::string_view name) {
    return {name,
            [](Schedule& schedule, std::string as, std::uint32_t k) {
                return schedule.add(std::move(as), [k](View<Terms...> view) {
                    const auto one = [k](auto&&... parts) {
                        Row::row(k, parts...);
                    };
                    if (k % 3 == 0) return view.each(one);
                    view.for_each_chunk([&](const auto& chunk) { chunk.each(one); });
                });
            },
            [](NaiveRun& run, NaiveState&, std::uint32_t k) {
                Query<Terms...>{}.each(run.world, [k](auto&&... parts) { Row::row(k, parts...); });
            }};
}

/// By the system itself or by its jobs.
template <class Row, class... Terms>
constexpr SystemKind recording(std::string_view name) {
    return {name,
            [](Schedule& schedule, std::string as, std::uint32_t k) {
                if (k % 3 == 0) {
                    return schedule.add(std::move(as), [k](View<Terms...> view, Commands& commands) {
                        view.each([&](auto&&... parts) { Row::row(k, commands, parts...); });
                    });
                }
                return schedule.add(std::move(as), [k](View<Terms...> view, JobCommands& commands) {
                    view.for_each_chunk([&](const auto& chunk, Job job) {
                        chunk.each([&](auto&&... parts) { Row::row(k, commands.of(job), parts...); });
                    });
                });
            },
            [](NaiveRun& run, NaiveState&, std::uint32_t k) {
                Query<Terms...>{}.each(run.world,
                                       [&](auto&&... parts) { Row::row(k, run.commands, parts...); });
            }};
}

constexpr std::uint64_t k_tally_factor = 0x9e3779b97f4a7c15u;

constexpr SystemKind k_follow_changes{
    "follow changes",
    [](Schedule& schedule, std::string as, std::uint32_t k) {
        return schedule.add(std::move(as), [k](View<Position, Changed<Score>> view) {
            view.for_each_chunk([&](const auto& chunk) {
                chunk.each([k](Position& position) { Follow::row(k, position); });
            });
        });
    },
    [](NaiveRun& run, NaiveState& state, std::uint32_t k) {
        const std::uint32_t first = run.world.version() - (1u << 29u);
        const Since since{state.until == 0 ? first : state.until};
        state.until = run.world.version() - 1;
        Query<Position, Changed<Score>>{}.each(run.world, since,
                                               [k](Position& position) { Follow::row(k, position); });
    }};

constexpr SystemKind k_tally{
    "tally",
    [](Schedule& schedule, std::string as, std::uint32_t) {
        return schedule.add(std::move(as), [](View<const Health> view, ResMut<Tally> tally) {
            view.each([&](const Health& h) { tally->value = tally->value * k_tally_factor + bits(h); });
        });
    },
    [](NaiveRun& run, NaiveState&, std::uint32_t) {
        Tally& tally = run.world.resource<Tally>();
        Query<const Health>{}.each(std::as_const(run.world), [&](const Health& h) {
            tally.value = tally.value * k_tally_factor + bits(h);
        });
    }};

constexpr SystemKind k_judge{
    "judge",
    [](Schedule& schedule, std::string as, std::uint32_t k) {
        return schedule.add(std::move(as), [k](View<Score, Without<Frozen>> view, Res<Tally> tally) {
            const auto sum = static_cast<std::uint32_t>(tally->value >> 32u);
            view.for_each_chunk([&](const auto& chunk) {
                chunk.each([&](Score& s) { s.points = static_cast<int>(mix(k, bits(s), sum) >> 1u); });
            });
        });
    },
    [](NaiveRun& run, NaiveState&, std::uint32_t k) {
        const auto sum = static_cast<std::uint32_t>(run.world.resource<Tally>().value >> 32u);
        Query<Score, Without<Frozen>>{}.each(
            run.world, [&](Score& s) { s.points = static_cast<int>(mix(k, bits(s), sum) >> 1u); });
    }};

constexpr SystemKind k_shout{
    "shout",
    [](Schedule& schedule, std::string as, std::uint32_t k) {
        return schedule.add(std::move(as), [k](View<const Health> view, EventWriter<Shout>& shouts) {
            shouts.emit({k});
            view.for_each_chunk([&](const auto& chunk, Job job) {
                chunk.each([&](const Health& health) {
                    const std::uint32_t n = mix(k, bits(health), 1);
                    if (n % 50 == 0) shouts.emit(job, {n});
                });
            });
        });
    },
    [](NaiveRun& run, NaiveState&, std::uint32_t k) {
        run.shouts.push_back({k});
        Query<const Health>{}.each(std::as_const(run.world), [&](const Health& health) {
            const std::uint32_t n = mix(k, bits(health), 1);
            if (n % 50 == 0) run.shouts.push_back({n});
        });
    }};

constexpr SystemKind k_hear{
    "hear",
    [](Schedule& schedule, std::string as, std::uint32_t k) {
        return schedule.add(std::move(as), [k](EventReader<Shout> shouts, ResMut<Heard> heard) {
            shouts.each([&](const Shout& s) { heard->value = heard->value * k_tally_factor + s.number + k; });
        });
    },
    [](NaiveRun& run, NaiveState& state, std::uint32_t k) {
        Heard& heard = run.world.resource<Heard>();
        for (; state.unread < run.shouts.size(); ++state.unread)
            heard.value = heard.value * k_tally_factor + run.shouts[state.unread].number + k;
    }};

constexpr SystemKind k_claim{
    "claim",
    [](Schedule& schedule, std::string as, std::uint32_t k) {
        return schedule.add(std::move(as),
                            [k](View<Entity, With<Score>> view, Commands& commands, JobCommands& by_jobs) {
                                view.for_each_chunk([&](const auto& chunk, Job job) {
                                    chunk.each([&](Entity entity) { claim(k, by_jobs.of(job), entity, 1); });
                                });
                                view.each([&](Entity entity) { claim(k, commands, entity, 2); });
                            });
    },
    [](NaiveRun& run, NaiveState&, std::uint32_t k) {
        for (const std::uint8_t byte : {2, 1}) {
            Query<Entity, With<Score>>{}.each(run.world,
                                              [&](Entity entity) { claim(k, run.commands, entity, byte); });
        }
    }};

constexpr SystemKind k_sweep{"sweep",
                             [](Schedule& schedule, std::string as, std::uint32_t k) {
                                 return schedule.add(std::move(as),
                                                     [k](Commands& commands) { sweep(k, commands); });
                             },
                             [](NaiveRun& run, NaiveState&, std::uint32_t k) {
                                 sweep(k, run.commands);
                             }};

constexpr SystemKind k_meddle{"meddle",
                              [](Schedule& schedule, std::string as, std::uint32_t k) {
                                  return schedule.add(std::move(as), [k](World& world) { meddle(k, world); });
                              },
                              [](NaiveRun& run, NaiveState&, std::uint32_t k) {
                                  meddle(k, run.world);
                              }};

/// Asks other entities, with a world as far as it declares.
constexpr SystemKind k_inherit{
    "inherit",
    [](Schedule& schedule, std::string as, std::uint32_t k) {
        return schedule.add(std::move(as),
                            [k](View<const Parent, Score> children, Lookup<const Health> healths) {
                                children.for_each_chunk([&](const auto& chunk) {
                                    chunk.each([&](const Parent& parent, Score& score) {
                                        if (!healths.alive(parent.entity)) return;
                                        const Health* of = healths.try_get<Health>(parent.entity);
                                        if (of != nullptr)
                                            score.points = static_cast<int>(mix(k, bits(*of), 0) >> 1u);
                                    });
                                });
                            });
    },
    [](NaiveRun& run, NaiveState&, std::uint32_t k) {
        Query<const Parent, Score>{}.each(run.world, [&](const Parent& parent, Score& score) {
            if (!run.world.alive(parent.entity)) return;
            const Health* of = std::as_const(run.world).try_get<Health>(parent.entity);
            if (of != nullptr) score.points = static_cast<int>(mix(k, bits(*of), 0) >> 1u);
        });
    }};

constexpr SystemKind k_kinds[]{
    rows<Hurt, Health, const Score>("hurt"),
    rows<Walk, Position, const Health>("walk"),
    rows<Rate, Entity, Score, const Health, With<Material>>("rate"),
    rows<Glow, Enabled<Light>, Light, const Position>("glow"),
    rows<Heat, Burning, Optional<const Score>>("heat"),
    rows<Fill, Byte, Entity, Without<Frozen>>("fill"),
    rows<Paint, Shared<Material>, Score>("paint"),
    recording<Breed, Entity, const Health>("breed"),
    recording<Cull, Entity, const Score>("cull"),
    recording<Freeze, Entity, const Health, Without<Frozen>>("freeze"),
    recording<Thaw, Entity, With<Frozen>>("thaw"),
    recording<Quench, Entity, const Burning>("quench"),
    k_follow_changes,
    k_tally,
    k_judge,
    k_shout,
    k_hear,
    k_claim,
    k_sweep,
    k_meddle,
    k_inherit,
};

}  // namespace

std::span<const SystemKind> system_kinds() {
    return k_kinds;
}

}  // namespace rambla::ecs::property
