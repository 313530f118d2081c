#include "ecs/commands.h"

#include "ecs/command_player.h"
#include "ecs/misuse.h"

namespace rambla::ecs {

Playback Commands::apply(World& world) {
    Commands* const recordings[]{this};
    return detail::CommandPlayer::of(world).play(recordings, "Commands::apply");
}

void Commands::clear() noexcept {
    forget_from(0);
}

Entity Commands::created(Entity placeholder) const {
    if (placeholder.generation != 0 || placeholder.index >= created_.size()) {
        detail::throw_not_alive("Commands::created", {}, placeholder);
    }
    return created_[placeholder.index];
}

std::size_t Commands::memory_bytes() const {
    return arena_.memory_bytes() + commands_.capacity() * sizeof(detail::Command) +
           created_.capacity() * sizeof(Entity);
}

void Commands::forget_from(std::size_t first) noexcept {
    for (std::size_t i = first; i < commands_.size(); ++i) {
        const detail::Command& command = commands_[i];
        if (!command.type->values_end) continue;
        for (const detail::CommandPart& part : command.type->parts)
            detail::destroy_rows(*part.info, command.values + part.offset, 1);
    }
    commands_.clear();
    last_type_ = nullptr;
    runs_ = 0;
    arena_.clear();
    placeholders_ = 0;
}

}  // namespace rambla::ecs
