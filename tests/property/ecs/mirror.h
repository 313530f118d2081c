#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ecs/entity_table.h"
#include "ecs/observers.h"
#include "ecs/query.h"
#include "ecs/world.h"
#include "property/ecs/model.h"

namespace rambla::ecs::property {

/// Which entities have which values, kept by observers alone, who also check what they are told and when.
/// Some parts are not observed. Two observers record changes that follow, for the model to repeat.
class Mirror {
public:
    /// Where no sparse part is observed, changes of archetypes without observed parts need not be looked at.
    enum class Watches { columns, sparse_too };

    /// A change that an observer has recorded: Frozen goes, or Byte comes.
    struct Echo {
        Entity entity;
        std::optional<std::uint32_t> byte;
    };

    Mirror(World& world, Watches watches);

    /// Begins to observe a part, or ends that.
    template <class C>
    void toggle(const Model& model);

    /// Values written through references are not told: this says so.
    void overwrite(std::size_t part, Entity entity, std::uint64_t value);
    /// What follows is one playback, or several, if it is divided. Until settle().
    void watch_order(const World& world, bool whole);
    /// Ends an operation: compares, checks the order of calls if asked to, returns what observers recorded.
    /// Throws Disagreement.
    [[nodiscard]] std::vector<Echo> settle(const World& world);
    void compare(const PartSums& sums) const;
    /// Of all calls, in their order.
    [[nodiscard]] std::uint64_t digest() const { return digest_; }

private:
    enum Moment : std::uint32_t { removed, added, was_set };
    struct Call {
        Moment moment;
        std::size_t rank;  ///< of the part, in the order of first observation
        std::size_t part;
        Entity entity;
    };
    struct Place {
        std::uint32_t archetype = k_no_archetype;
        std::uint32_t row = 0;
        auto operator<=>(const Place&) const = default;
    };

    template <class C>
    void observe();
    template <class C>
    void told(Moment moment, Entity entity, const C* value);
    void check_order(const World& world) const;
    [[nodiscard]] Place place_before(Entity entity) const;

    World* world_;
    std::array<bool, k_part_count> observed_{};
    std::array<std::vector<ObserverId>, k_part_count> observers_;
    std::array<std::optional<std::size_t>, k_part_count> rank_;  ///< kept when observing ends
    std::size_t ranks_ = 0;
    std::array<std::unordered_map<std::uint64_t, std::uint64_t>, k_part_count> values_;
    PartSums sums_;
    std::vector<Call> calls_;
    std::vector<Echo> echoes_;
    std::unordered_map<std::uint64_t, Place> before_;
    bool checks_order_ = false;
    std::uint64_t digest_ = 0xcbf29ce484222325u;
};

}  // namespace rambla::ecs::property
