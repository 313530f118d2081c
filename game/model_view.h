#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "assets/bounds.h"
#include "assets/daylight.h"
#include "assets/image.h"
#include "game/run_trace.h"
#include "game/stage.h"
#include "render/render_thread.h"
#include "render/settings.h"
#include "systems/feedback.h"
#include "systems/frame.h"

namespace rambla::game {

/// How somebody wants to see a file.
struct ViewWishes {
    std::optional<std::uint32_t> camera;  ///< of the file, from 0; else its first, else a view of everything
    std::optional<std::string> clip;      ///< by name or number
    std::optional<double> clip_time_s;    ///< with a clip: else its beginning; alone: of the first clip
    bool plays = false;                   ///< in a window: the first clip, unless `clip` says which
    glm::uvec2 size_px{960, 540};
    systems::WorldPosition origin;
    render::Settings settings;
    bool own_exposure = false;              ///< settings say it; else as the light wants it
    std::optional<assets::TimeOfDay> time;  ///< whose sun and sky replace the file's
    bool own_shadows = false;  ///< settings say how far shadows reach; else as far as the model does
};

/// A file on stage, and the first look at it.
struct ModelView {
    Stage stage;
    assets::Bounds box;                   ///< of the pose that is shown; of all that a clip shows if it plays
    std::optional<std::uint32_t> camera;  ///< node of the camera that is looked through
    systems::Eye eye;
    render::Settings settings;
};

/// Imports a file, poses it and looks at it.
/// @throws assets::Error          if it cannot be used
/// @throws std::invalid_argument  if it lacks what is wished for
[[nodiscard]] ModelView view_model(const std::filesystem::path& file, const ViewWishes& wishes);

/// What was drawn of a model.
struct ModelPicture {
    assets::Image image;
    systems::FrameCounts counts;
    systems::Feedback feedback;
};

/// Draws one picture of a model, after everything that the thread had to do before.
/// @param linear  linear light for an EXR file, else what a screen shows
/// @param hud     what lies over a picture for the screen; may be null
/// @param trace   gets the look and the frame; may be null
[[nodiscard]] ModelPicture draw_model(render::RenderThread& thread, ModelView& view, bool linear, bool quiet,
                                      std::shared_ptr<const void> hud, RunTrace* trace = nullptr);

/// What was drawn, for results: entities, visible, lights, draws, triangles, textures, and those of
/// clip_facts().
[[nodiscard]] nlohmann::json picture_facts(const ModelView& view, const ModelPicture& picture);

/// What a stage's player plays, for results: clips, clip, clip_time_s.
[[nodiscard]] nlohmann::json clip_facts(const Stage& stage);

}  // namespace rambla::game
