#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ecs/commands.h"
#include "ecs/component.h"
#include "ecs/entity.h"
#include "ecs/world.h"

namespace rambla::ecs {

class Hierarchy;

namespace detail {

template <class C, class F>
inline constexpr bool k_takes_value = std::is_invocable_v<F&, Entity, const C&>;
template <class C, class F>
inline constexpr bool k_takes_value_and_commands = std::is_invocable_v<F&, Entity, const C&, Commands&>;

class CommandPlan;
class CommandPlayer;
std::span<const Entity> announce(World& world, std::span<const Entity> entities);

}  // namespace detail

/// How to end an observer. Never used twice in one world.
struct ObserverId {
    std::uint32_t number = 0;
    bool operator==(const ObserverId&) const = default;
};

/// Functions that a world calls when components come, go, or get another value by a structural change:
///     world.observers().on_add<Collider>([&](Entity entity, const Collider& collider) { … });
/// They take (Entity, const C&), those of tags (Entity). Both may take a Commands& as well: what is recorded
/// there is played after the change that was observed, and may be observed in turn.
///
/// A change is a call of the World, or a playback as a whole; commands for all entities divide a playback
/// into several, one after the other. What counts is how an entity was before and is after: a component that
/// comes and goes in one playback is not observed, one that goes and comes again is set. Values written
/// through references, queries or set_enabled() are not observed, nor is a shared value replaced by the same
/// one, and the world's end, snapshots and deltas call nobody.
///
/// Removals are told before the change, while all values are still there; then, after the change, additions,
/// then sets. Within each, components come in the order in which they were first observed. Entities of one
/// component come by the age of the archetype that they leave, those that share a fate together and by row,
/// created ones last, in the order of their creation; of sparse components in the order of rows, and those
/// whose entities end first. Observers of one component are called in the order in which they were added.
///
/// An observer may read the world and write values. Structural changes of this world, adding and ending
/// observers throw Misuse meanwhile. When an observer throws, no other is called, what observers have
/// recorded is dropped, the change that was observed is still made as a whole, and then its caller gets the
/// exception.
class Observers {
public:
    /// How many playbacks in a row may be caused by observers; what they record beyond throws Misuse, with
    /// all earlier changes made.
    static constexpr std::uint32_t k_cascade_limit = 32;

    explicit Observers(World& world) : world_{world} {}
    ~Observers();

    /// f is called for entities that had no C before.
    template <Component C, class F>
    ObserverId on_add(F f) {
        return observe<C>(Moment::add, std::move(f));
    }
    /// f is called for entities that have no C afterwards, those that end included, and still sees the value.
    template <Component C, class F>
    ObserverId on_remove(F f) {
        return observe<C>(Moment::remove, std::move(f));
    }
    /// f is called for entities that had another value of C before.
    template <Component C, class F>
    ObserverId on_set(F f) {
        static_assert(!is_tag<C>, "a tag has no value that could be set");
        return observe<C>(Moment::set, std::move(f));
    }
    /// Ends an observer. Throws Misuse if there is none such.
    void end(ObserverId id);

    /// Number of observers that were added and did not end.
    [[nodiscard]] std::size_t size() const;
    /// Memory held, without what the functions own.
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    friend class Hierarchy;
    friend class World;
    friend std::span<const Entity> detail::announce(World& world, std::span<const Entity> entities);
    friend class detail::CommandPlayer;

    enum class Moment : std::uint8_t { remove, add, set };
    static constexpr std::size_t k_moments = 3;

    using Function = std::function<void(Entity, const void*, Commands&)>;
    struct Observer {
        ObserverId id;
        Function call;
    };
    /// A component that is or was observed.
    struct Observed {
        const ComponentInfo* info;
        ComponentId component = k_no_component;  ///< in the world as it is now
        std::array<std::vector<Observer>, k_moments> by_moment{};
        std::array<std::vector<Entity>, k_moments> due{};  ///< who to tell of

        [[nodiscard]] bool at(Moment moment) const { return !observers(moment).empty(); }
        [[nodiscard]] const std::vector<Observer>& observers(Moment moment) const {
            return by_moment[static_cast<std::size_t>(moment)];
        }
        void note(Moment moment, Entity entity) {
            if (at(moment)) due[static_cast<std::size_t>(moment)].push_back(entity);
        }
    };

    template <class C, class F>
    ObserverId observe(Moment moment, F f);
    ObserverId insert(const ComponentInfo& info, Moment moment, Function call);
    /// Whether nobody would be told of anything.
    [[nodiscard]] bool idle() const;
    /// A hierarchy that records what follows each change in which entities ended, whatever they had.
    void add_follower(Hierarchy& hierarchy);
    void remove_follower(const Hierarchy& hierarchy) noexcept;

    /// Whether somebody may have to be told of what the columns of entities that begin in this archetype
    /// hold. Sparse values are not asked about.
    [[nodiscard]] bool watches_begin(Archetype& archetype) const {
        return archetype.watched().begin && find_watched(archetype).begin;
    }
    /// Whether somebody may have to be told of entities that end in this archetype.
    [[nodiscard]] bool watches_end(Archetype& archetype) const {
        return archetype.watched().end && find_watched(archetype).end;
    }
    const Watched& find_watched(Archetype& archetype) const;
    void forget_watched() noexcept;
    [[nodiscard]] bool watches(const ComponentInfo& info) const;
    /// Begins to watch a change; what was noted of one that failed is forgotten.
    void begin();
    /// What a change is going to be: noted before it is made.
    void note(Entity entity, const ComponentInfo& info, Moment moment);
    void note_end(Entity entity);
    void note_new(std::span<const Entity> entities);
    void note_plan(const detail::CommandPlan& plan);
    void note_columns(Observed& observed, const detail::CommandPlan& plan);
    void note_sparse(Observed& observed, const detail::CommandPlan& plan);
    void note_whole(std::span<Archetype* const> archetypes, const ComponentInfo& info, bool adds);
    void note_whole_end(std::span<Archetype* const> archetypes);
    /// Tells of removals, which are about to be made.
    void before_change() noexcept { tell(Moment::remove); }
    /// Tells of the rest. @param created  what placeholders in the notes stand for
    void after_change(std::span<const Entity> created = {}) noexcept;
    /// Tells of new entities, and settles. Returns them where what was recorded cannot have moved them.
    std::span<const Entity> announce(std::span<const Entity> entities);
    /// Plays what observers have recorded, and what they record then, and throws what one of them has thrown.
    void settle();
    [[noreturn]] void throw_without_end() const;
    /// Forgets what was recorded and thrown.
    void forget() noexcept;

    void tell(Moment moment) noexcept;
    void tell_followers();
    void tell(const Observed& observed, Moment moment, Entity entity);
    [[nodiscard]] bool holds(const Observed& observed, Entity entity) const;
    [[nodiscard]] const void* value_of(const Observed& observed, Entity entity) const;

    World& world_;
    std::vector<Observed> observed_;      ///< in the order in which they were first observed
    std::array<Commands, 2> recordings_;  ///< one is recorded while the other is played
    std::size_t recording_ = 0;
    std::vector<Hierarchy*> followers_;
    bool ended_ = false;             ///< some entity, and the followers do not know yet
    std::vector<Entity> announced_;  ///< that announce() returned
    std::exception_ptr error_;
    const ComponentInfo* last_recorder_ = nullptr;  ///< of the playback under way; null: no observer
    Moment last_moment_ = Moment::add;
    std::uint32_t next_number_ = 1;
};

// ----------------------------------------------------------------------------------------------------

template <class C, class F>
ObserverId Observers::observe(Moment moment, F f) {
    static_assert(!detail::k_is_enable_state<C>, "an EnableState comes and goes with its component");
    if constexpr (is_tag<C>) {
        static_assert(std::is_invocable_v<F&, Entity> || std::is_invocable_v<F&, Entity, Commands&>,
                      "an observer of a tag takes (Entity) or (Entity, Commands&)");
        return insert(component_info<C>(), moment,
                      [f = std::move(f)](Entity entity, const void*, Commands& commands) mutable {
                          if constexpr (std::is_invocable_v<F&, Entity, Commands&>) {
                              f(entity, commands);
                          } else {
                              f(entity);
                          }
                      });
    } else {
        static_assert(detail::k_takes_value<C, F> || detail::k_takes_value_and_commands<C, F>,
                      "an observer takes (Entity, const C&) or (Entity, const C&, Commands&)");
        return insert(component_info<C>(), moment,
                      [f = std::move(f)](Entity entity, const void* value, Commands& commands) mutable {
                          if constexpr (detail::k_takes_value_and_commands<C, F>) {
                              f(entity, *static_cast<const C*>(value), commands);
                          } else {
                              f(entity, *static_cast<const C*>(value));
                          }
                      });
    }
}

}  // namespace rambla::ecs
