#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/study/result.h"
#include "render/render_thread.h"

namespace rambla::game::study {

struct StudyOptions {
    glm::uvec2 size_px{0};     ///< of the pictures; 0: as each study suits
    std::uint32_t rounds = 0;  ///< 0: as each study suits
    std::uint64_t seed = 1;    ///< of generated scenes and of samples
    bool quick = false;        ///< small and few pictures: everything runs, and the numbers mean little
    bool quiet = false;        ///< shows no progress
};

/// What a study runs with.
class StudyContext {
public:
    /// @param stopped  whether the user wants no more; once true, always. Called on the thread that asks.
    StudyContext(const StudyOptions& options, std::function<bool()> stopped);
    /// @param stop  set from outside; must outlive this
    StudyContext(const StudyOptions& options, const std::atomic<bool>& stop);

    [[nodiscard]] const StudyOptions& options() const { return options_; }
    /// What draws, without a window; made when first asked for. @throws render::MissingFeature
    [[nodiscard]] render::RenderThread& thread();

    /// A study that hears of this returns with what it has; its caller marks the result.
    [[nodiscard]] bool stopped() const { return stopped_(); }

    /// @param full  rounds of a run that is neither quick nor told otherwise
    [[nodiscard]] std::uint32_t rounds(std::uint32_t full) const;
    /// The sizes of pictures that a study goes through. @param full  of a run as above
    [[nodiscard]] std::vector<glm::uvec2> sizes(std::vector<glm::uvec2> full) const;

private:
    StudyOptions options_;
    std::function<bool()> stopped_;
    std::unique_ptr<render::RenderThread> thread_;
};

/// A technique's grades, measured against each other and against a reference.
struct Study {
    std::string_view name;     ///< as the command line takes it
    std::string_view summary;  ///< half a line for --help
    /// Fills everything of a result but its name, command, mark and duration. What is there when it throws or
    /// returns early counts.
    void (*run)(StudyContext&, StudyResult&);
};

// One line here and one in studies.cpp for each; each in a file of its own name.
extern const Study k_gbuffer_study;
extern const Study k_lighting_study;
extern const Study k_detail_study;
extern const Study k_luminance_study;
extern const Study k_tonemap_study;
extern const Study k_bloom_study;
extern const Study k_antialiasing_study;
extern const Study k_passes_study;
extern const Study k_compression_study;

/// In the order of the report.
[[nodiscard]] std::span<const Study* const> all_studies();

/// The studies of these names, each once, in the order of the report; `all` is every one.
/// @throws std::invalid_argument  naming what is no study, and those that there are
[[nodiscard]] std::vector<const Study*> find_studies(std::span<const std::string> names);

/// Runs a study. What it throws becomes the result's mark, so that what was found before is not lost.
/// @param command  that runs it again
[[nodiscard]] StudyResult run_study(const Study& study, StudyContext& context, const std::string& command);

}  // namespace rambla::game::study
