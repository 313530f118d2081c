// Block-compressed textures: what they cost to sample and to make, what they save, and what they lose.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>

#include "assets/process/texture.h"
#include "game/progress.h"
#include "game/scene_cache.h"
#include "game/statistics.h"
#include "game/study/grades.h"
#include "game/study/in_turns.h"
#include "game/study/picture_error.h"

namespace rambla::game::study {
namespace {

using assets::Compression;

constexpr std::uint32_t k_rounds = 7;
constexpr std::uint32_t k_encoding_rounds = 3;
constexpr std::size_t k_quick_pictures = 2;
constexpr glm::uvec2 k_size_px{1280, 720};
constexpr std::array<std::string_view, 1> k_sampled{"gbuffer"};
constexpr std::array<std::string_view, 6> k_formats{"rgba8", "rgba32f", "bc1", "bc3", "bc4", "bc5"};

std::string grade_name(Compression compression) {
    return fmt::format("compression={}", assets::k_compressions[static_cast<std::size_t>(compression)]);
}

/// The street with textures in one way, and a renderer of its own: uploads are no part of a round.
struct Shown {
    std::string grade;
    Stage stage;
    std::unique_ptr<render::RenderThread> thread;
    std::shared_ptr<const assets::ProcessedScene> scene;
    std::vector<double> ms{};
    double texture_bytes = 0.0;
    std::vector<std::vector<Metric>> errors{};
};

Shown make_shown(StudyContext& context, Compression compression) {
    Shown shown{
        .grade = grade_name(compression),
        .stage = make_stage("street", context.options().seed, {}, {}),
        .thread = std::make_unique<render::RenderThread>(render::RenderThreadOptions{.window = {},
                                                                                     .shaders = {},
                                                                                     .gl_errors_throw = false,
                                                                                     .compile_ahead = false,
                                                                                     .compile_for = {}}),
        .scene = {}};
    assets::ProcessParameters parameters;
    parameters.textures.compression = compression;
    PreparedScene prepared = prepare_scene(*shown.stage.scene, parameters, context.options().quiet);
    shown.scene = prepared.scene;
    hand_over(std::move(prepared), shown.stage, *shown.thread);
    shown.thread->finish();
    return shown;
}

/// Time of the pass that samples textures, and how far pictures are from those with textures as they are,
/// which is the first.
void draw_all(StudyContext& context, std::vector<Shown>& all, glm::uvec2 size_px, std::uint32_t rounds,
              const std::string& scene) {
    PictureGrade usual{.name = {}, .settings = plain_settings()};
    usual.settings.shadows.method =
        render::ShadowMethod::off;  // shadow maps sample no textures, and take time
    Progress progress{"compression: " + scene, rounds + 1, !context.options().quiet};
    const EyeOfRound eye = along_the_walk(all.front().stage, size_px, rounds);
    for (std::uint32_t round = 0; round < rounds && !context.stopped(); ++round) {
        std::vector<assets::Image> pictures;
        for (Shown& shown : all) {  // does not count: it brings the levels of textures that the eye needs
            render::FrameOutput output =
                draw(*shown.thread, shown.stage, usual, eye(round), {.display = true});
            pictures.push_back(std::move(output.display.value()));
            shown.texture_bytes =
                std::max(shown.texture_bytes, static_cast<double>(output.feedback.textures.resident_bytes));
        }
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i].errors.push_back(display_metrics(pictures.front(), pictures[i]));
        for (std::size_t turn = 0; turn < all.size(); ++turn) {
            Shown& shown = all[(turn + round) % all.size()];
            const render::FrameOutput output = draw(*shown.thread, shown.stage, usual, eye(round));
            shown.ms.push_back(sum_ms(output.feedback, k_sampled));
        }
        progress.update(round + 1);
    }
}

/// What became of a scene's textures: how many are in which format, what they take, and how far off they are.
Table format_table(const Shown& shown) {
    struct Row {
        std::uint32_t textures = 0;
        std::uint64_t bytes = 0;
        std::vector<double> rms{};
    };
    std::map<assets::TexelFormat, Row> rows;
    for (const assets::TextureData& image : shown.scene->images) {
        Row& row = rows[image.format];
        ++row.textures;
        for (const assets::TextureLevel& level : image.levels)
            row.bytes += level.size;
        row.rms.push_back(image.levels.empty() ? 0.0 : static_cast<double>(image.levels.front().rms_error));
    }
    Table table{.title = "Textures of the street, " + shown.grade,
                .head = {"format", "textures", "KiB with all levels", "RMS error, median", "RMS error, most"},
                .rows = {}};
    for (const auto& [format, row] : rows) {
        table.rows.push_back({std::string{k_formats[static_cast<std::size_t>(format)]},
                              std::to_string(row.textures), std::to_string(row.bytes / 1024),
                              fmt::format("{:.4f}", median(row.rms)),
                              fmt::format("{:.4f}", percentile(row.rms, 1.0))});
    }
    return table;
}

void measure_pictures(StudyContext& context, StudyResult& result) {
    std::vector<Shown> all;
    for (const Compression compression : {Compression::off, Compression::fast, Compression::good}) {
        if (context.stopped()) return;
        all.push_back(make_shown(context, compression));
    }
    const std::uint32_t rounds = context.rounds(k_rounds);
    for (const glm::uvec2 size_px : context.sizes({k_size_px})) {
        const std::string scene = fmt::format("street, {}", size_text(size_px));
        draw_all(context, all, size_px, rounds, scene);
        for (Shown& shown : all) {
            if (shown.ms.empty()) return;
            result.grades.push_back({.scene = scene,
                                     .grade = shown.grade,
                                     .ms = std::move(shown.ms),
                                     .bytes = shown.texture_bytes,
                                     .metrics = mean_metrics(shown.errors)});
        }
    }
    for (const Shown& shown : all)
        result.tables.push_back(format_table(shown));
}

struct Made {
    double ms = 0.0;
    double bytes = 0.0;
    std::vector<double> rms{};  ///< of the finest level of each texture
};

/// Makes the first `jobs` textures of a plan, one after the other; fewer when the context is stopped.
Made make_textures(const StudyContext& context, const Stage& stage, const assets::TexturePlan& plan,
                   std::size_t jobs, Compression compression) {
    using Clock = std::chrono::steady_clock;
    Made made;
    const Clock::time_point start = Clock::now();
    for (std::size_t job = 0; job < jobs && !context.stopped(); ++job) {
        const assets::TextureData texture = assets::process_texture(
            plan.jobs[job], plan.channels[job], stage.scene->images, {.compression = compression});
        made.bytes += static_cast<double>(texture.bytes.size());
        if (!texture.levels.empty())
            made.rms.push_back(static_cast<double>(texture.levels.front().rms_error));
    }
    made.ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return made;
}

/// What making a scene's textures takes, mip levels included, by one thread at a time.
void measure_encoding(StudyContext& context, StudyResult& result) {
    const Stage stage = make_stage("street", context.options().seed, {}, {});
    const assets::TexturePlan plan = assets::plan_textures(*stage.scene);
    const std::size_t jobs =
        context.options().quick ? std::min(plan.jobs.size(), k_quick_pictures) : plan.jobs.size();
    const std::uint32_t rounds = context.rounds(k_encoding_rounds);
    const std::string scene = fmt::format("making {} textures of the street", jobs);
    std::vector<GradeResult> grades;
    for (std::size_t i = 0; i < assets::k_compressions.size(); ++i)
        grades.push_back({.scene = scene, .grade = grade_name(static_cast<Compression>(i))});
    const auto steps = static_cast<std::uint32_t>(rounds * grades.size());
    Progress progress{"compression: " + scene, steps, !context.options().quiet};
    for (std::uint32_t round = 0; round < rounds; ++round) {
        std::vector<Made> made;
        for (std::size_t grade = 0; grade < grades.size() && !context.stopped(); ++grade) {
            made.push_back(make_textures(context, stage, plan, jobs, static_cast<Compression>(grade)));
            progress.update(static_cast<std::uint32_t>(round * grades.size() + grade + 1));
        }
        if (context.stopped()) break;
        for (std::size_t grade = 0; grade < grades.size(); ++grade) {
            grades[grade].ms.push_back(made[grade].ms);
            grades[grade].bytes = made[grade].bytes;
            grades[grade].metrics = {{"texel_rms_median", median(made[grade].rms), ""},
                                     {"texel_rms_max", percentile(made[grade].rms, 1.0), ""}};
        }
    }
    if (!grades.front().ms.empty()) result.grades.insert(result.grades.end(), grades.begin(), grades.end());
}

void run(StudyContext& context, StudyResult& result) {
    result.title = "Texture compression";
    result.question =
        "What do block-compressed textures (BC1, BC3, BC4 and BC5 by what a texture holds) cost to sample "
        "and to make, what memory do they save, and what do they lose? Milliseconds are those of the "
        "G-buffer pass, which samples them.";
    result.reference =
        "The same pictures with textures as they are. texel_rms compares texels with what was compressed, in "
        "the picture's own encoding with white as 1.";
    result.plotted_metric = "flip_mean";
    measure_pictures(context, result);
    if (!context.stopped()) measure_encoding(context, result);
}

}  // namespace

const Study k_compression_study{
    .name = "compression", .summary = "textures in blocks or as they are: time, memory and loss", .run = run};

}  // namespace rambla::game::study
