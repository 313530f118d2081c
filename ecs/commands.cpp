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
    return list_.memory_bytes() + created_.capacity() * sizeof(Entity);
}

void Commands::forget_from(std::size_t first) noexcept {
    list_.end_values_from(first);
    list_.clear();
    placeholders_ = 0;
}

}  // namespace rambla::ecs
