#pragma once

#include <functional>
#include <string>
#include <vector>

#include "game/parameters.h"
#include "render/settings.h"
#include "systems/feedback.h"
#include "systems/frame.h"

namespace rambla::game {

/// Counts that the overlay shows.
struct OverlayState {
    systems::FrameCounts counts;
    std::size_t entities = 0;
    std::size_t archetypes = 0;
    std::uint64_t steps = 0;
    systems::Feedback feedback;
};

/// The developer's panel: every parameter table as widgets, and what world and renderer hold.
class Overlay {
public:
    /// @param settings  changed by the widgets; must outlive this and stay where it is
    /// @param own_part  builds more widgets between the counts and the parameters; may be empty
    explicit Overlay(render::Settings& settings, std::function<void()> own_part = {});

    /// Builds the panel in the current Dear ImGui frame.
    void draw(const OverlayState& state);

private:
    struct Group {
        std::string name;
        std::vector<BoundParameter> parameters;
        std::vector<std::string> labels;  ///< one per parameter, null-terminated as Dear ImGui wants them
    };
    void add_group(std::string name, std::vector<BoundParameter> parameters);

    std::function<void()> own_part_;
    std::vector<Group> groups_;
};

}  // namespace rambla::game
