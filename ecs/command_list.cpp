#include "ecs/command_list.h"

#include <algorithm>

#include "ecs/relocate.h"

namespace rambla::ecs::detail {

std::byte* CommandList::push_first(Entity entity, const CommandType& type, std::size_t stride,
                                   std::size_t alignment) {
    if (empty() && type.is_about_one_column()) {
        alike_entities_.push_back(entity);
        std::byte* const values = push_values_apart(stride, alignment);
        alike_type_ = &type;
        return values;
    }
    one_by_one();
    std::byte* const values = stride == 0 ? nullptr : arena_.take(stride, alignment);
    commands_.push_back({entity, &type, values});
    return values;
}

std::byte* CommandList::push_values_apart(std::size_t stride, std::size_t alignment) {
    const std::size_t before = alike_values_.size();
    try {
        alike_values_.push_back({alike_entities_.size() - 1, nullptr});
        if (stride != 0) alike_values_.back().bytes = arena_.take(stride, alignment);
    } catch (...) {
        alike_values_.resize(before);
        alike_entities_.pop_back();
        throw;
    }
    return alike_values_.back().bytes;
}

void CommandList::append_runs_to(std::vector<CommandRun>& runs) const {
    for (std::size_t i = 0; i < alike_values_.size(); ++i) {
        const auto [first, bytes] = alike_values_[i];
        const bool is_last = i + 1 == alike_values_.size();
        const std::size_t end = is_last ? alike_entities_.size() : alike_values_[i + 1].first;
        runs.push_back({&alike_entities_[first], sizeof(Entity), bytes, end - first});
    }
}

template <class F>
void CommandList::each_alike(F f) const {
    for (std::size_t i = 0, apart = 0; apart < alike_values_.size(); ++apart) {
        const bool is_last = apart + 1 == alike_values_.size();
        const std::size_t end = is_last ? alike_entities_.size() : alike_values_[apart + 1].first;
        for (std::byte* values = alike_values_[apart].bytes; i < end; ++i, values += alike_type_->stride)
            f(i, values);
    }
}

void CommandList::append_to(std::vector<Command>& commands) const {
    if (alike_type_ == nullptr) {
        commands.insert(commands.end(), commands_.begin(), commands_.end());
        return;
    }
    if (commands.capacity() - commands.size() < alike_entities_.size())
        commands.reserve(std::max(commands.size() + alike_entities_.size(), 2 * commands.capacity()));
    each_alike([&](std::size_t i, std::byte* values) {
        commands.push_back({alike_entities_[i], alike_type_, values});
    });
}

std::span<const Command> CommandList::one_by_one() {
    if (alike_type_ != nullptr) {
        append_to(commands_);
        forget_alike();
    }
    return commands_;
}

void CommandList::end_values_from(std::size_t first) noexcept {
    const auto end_values = [](const CommandType& type, std::byte* values) {
        for (const CommandPart& part : type.parts)
            destroy_rows(*part.info, values + part.offset, 1);
    };
    for (std::size_t i = first; i < commands_.size(); ++i) {
        if (commands_[i].type->values_end) end_values(*commands_[i].type, commands_[i].values);
    }
    if (alike_type_ == nullptr || !alike_type_->values_end || first >= size()) return;
    each_alike([&](std::size_t i, std::byte* values) {
        if (i >= first) end_values(*alike_type_, values);
    });
}

void CommandList::clear() noexcept {
    commands_.clear();
    forget_alike();
    arena_.clear();
}

void CommandList::forget_alike() noexcept {
    alike_type_ = nullptr;
    alike_entities_.clear();
    alike_values_.clear();
}

std::size_t CommandList::memory_bytes() const {
    return arena_.memory_bytes() + commands_.capacity() * sizeof(Command) +
           alike_entities_.capacity() * sizeof(Entity) + alike_values_.capacity() * sizeof(Values);
}

}  // namespace rambla::ecs::detail
