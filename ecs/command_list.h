#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ecs/command.h"
#include "ecs/command_arena.h"
#include "ecs/entity.h"

namespace rambla::ecs::detail {

/// Neighbouring commands of one type whose values lie one behind the other.
struct CommandRun {
    const Entity* first_entity;
    std::size_t entity_stride;  ///< bytes from one to the next
    std::byte* first_value;     ///< values are CommandType::stride apart
    std::size_t count;

    [[nodiscard]] const Entity& entity(std::size_t i) const {
        const auto* const first = reinterpret_cast<const std::byte*>(first_entity);
        return *reinterpret_cast<const Entity*>(first + i * entity_stride);
    }
};

/// Commands in the order in which they were recorded, and their values. As long as all are of one type that
/// is_about_one_column(), as most long recordings are, an entity and its value are all that is kept of each.
class CommandList {
public:
    /// Records a command and returns raw memory for its values. If it throws, nothing was recorded.
    /// @param stride     the type's, as the caller's compiler knows it
    /// @param alignment  of the values
    std::byte* push(Entity entity, const CommandType& type, std::size_t stride, std::size_t alignment) {
        if (&type == alike_type_) {
            alike_entities_.push_back(entity);
            if (stride == 0) return nullptr;
            std::byte* const values = arena_.take_behind(stride);
            return values != nullptr ? values : push_values_apart(stride, alignment);
        }
        if (alike_type_ != nullptr || commands_.empty()) return push_first(entity, type, stride, alignment);
        std::byte* const values = stride == 0 ? nullptr : arena_.take(stride, alignment);
        commands_.push_back({entity, &type, values});
        return values;
    }

    [[nodiscard]] std::size_t size() const { return commands_.size() + alike_entities_.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }

    /// Of all commands, if they are kept as being alike; else null.
    [[nodiscard]] const CommandType* alike_type() const { return alike_type_; }
    /// Appends what the commands are if alike_type() is set.
    void append_runs_to(std::vector<CommandRun>& runs) const;
    /// Appends the commands one by one.
    void append_to(std::vector<Command>& commands) const;
    /// The commands one by one. From now on the list keeps them as such.
    std::span<const Command> one_by_one();

    /// Ends the values of the commands from `first` on.
    void end_values_from(std::size_t first) noexcept;
    /// Forgets the commands, whose values are ended or elsewhere. Keeps the memory.
    void clear() noexcept;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Values that lie one behind the other, of the alike commands from `first` on.
    struct Values {
        std::size_t first;
        std::byte* bytes;
    };

    /// The first of all, or the first that is not like those before it.
    std::byte* push_first(Entity entity, const CommandType& type, std::size_t stride, std::size_t alignment);
    /// Memory for the values of the entity pushed last, which is taken back if there is none.
    std::byte* push_values_apart(std::size_t stride, std::size_t alignment);
    /// Calls f(number, values) for each of the alike commands.
    template <class F>
    void each_alike(F f) const;
    void forget_alike() noexcept;

    CommandArena arena_;
    std::vector<Command> commands_;            ///< empty while all are alike
    const CommandType* alike_type_ = nullptr;  ///< null where they are not, or none are there
    std::vector<Entity> alike_entities_;
    std::vector<Values> alike_values_;
};

}  // namespace rambla::ecs::detail
