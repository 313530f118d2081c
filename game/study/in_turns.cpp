#include "game/study/in_turns.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "game/camera_path.h"
#include "game/progress.h"
#include "game/scene_cache.h"
#include "game/supersampling.h"
#include "systems/pipeline.h"

namespace rambla::game::study {

std::shared_ptr<const assets::ProcessedScene> show(StudyContext& context, Stage& stage) {
    render::RenderThread& thread = context.thread();
    PreparedScene prepared = prepare_scene(*stage.scene, thread.device(), true);
    std::shared_ptr<const assets::ProcessedScene> scene = prepared.scene;
    hand_over(std::move(prepared), stage, thread);
    thread.finish();
    return scene;
}

namespace {

render::FrameOutput draw_one(render::RenderThread& thread, Stage& stage, const PictureGrade& grade,
                             const systems::Eye& eye, bool cut, systems::CaptureRequest capture) {
    render::FrameInput& input = thread.begin();
    systems::build_frame(*stage.world, sampled(eye, grade.settings.anti_aliasing, thread.device()), 1.0f,
                         input.frame);
    if (grade.change) grade.change(input.frame);
    input.frame.capture = capture;
    input.settings = grade.settings;
    input.settings.exposure.ev = stage.exposure_ev;
    input.timers = render::PassTimers::alone;
    input.cut = cut;
    input.complete_textures = true;
    thread.submit();
    thread.finish();
    return std::move(thread.collect().back());
}

}  // namespace

render::FrameOutput draw(render::RenderThread& thread, Stage& stage, const PictureGrade& grade,
                         const systems::Eye& eye, systems::CaptureRequest capture) {
    bool cut = !grade.follows;
    for (std::uint32_t i = 0; i < grade.frames_before; ++i) {
        static_cast<void>(draw_one(thread, stage, grade, eye, cut, {}));
        cut = false;
    }
    return draw_one(thread, stage, grade, eye, cut, capture);
}

std::vector<PictureCost> draw_in_turns(StudyContext& context, Stage& stage,
                                       std::span<const PictureGrade> grades, const EyeOfRound& eye,
                                       std::uint32_t rounds, const std::string& what) {
    Progress progress{what, rounds + 1, !context.options().quiet};
    for (const PictureGrade& grade : grades) {
        if (context.stopped()) return {};
        static_cast<void>(draw(context.thread(), stage, grade, eye(0)));
    }
    progress.update(1);
    std::vector<PictureCost> costs(grades.size());
    for (std::uint32_t round = 0; round < rounds; ++round) {
        const systems::Eye at = eye(round);
        std::vector<systems::Feedback> told(grades.size());
        for (std::size_t turn = 0; turn < grades.size(); ++turn) {
            if (context.stopped()) return round > 0 ? costs : std::vector<PictureCost>{};
            const std::size_t grade = (turn + round) % grades.size();
            told[grade] = draw(context.thread(), stage, grades[grade], at).feedback;
        }
        for (std::size_t grade = 0; grade < grades.size(); ++grade)
            costs[grade].rounds.push_back(std::move(told[grade]));
        progress.update(round + 2);
    }
    return costs;
}

EyeOfRound along_the_walk(const Stage& stage, glm::uvec2 size_px, std::uint32_t rounds) {
    return [&stage, size_px, rounds](std::uint32_t round) {
        const float begin_s = stage.walk.front().time_s;
        const float share = static_cast<float>(round) / static_cast<float>(rounds);
        systems::Eye eye = walk_eye(stage, begin_s + share * (stage.walk.back().time_s - begin_s));
        eye.size_px = size_px;
        return eye;
    };
}

double sum_ms(const systems::Feedback& feedback, std::span<const std::string_view> passes) {
    double sum = 0.0;
    for (const systems::PassTiming& pass : feedback.passes)
        if (std::find(passes.begin(), passes.end(), pass.name) != passes.end()) sum += pass.gpu_ms;
    return sum;
}

std::vector<double> sums_ms(const PictureCost& cost, std::span<const std::string_view> passes) {
    std::vector<double> sums;
    for (const systems::Feedback& feedback : cost.rounds)
        sums.push_back(sum_ms(feedback, passes));
    return sums;
}

std::vector<double> frames_ms(const PictureCost& cost) {
    std::vector<double> ms;
    for (const systems::Feedback& feedback : cost.rounds)
        ms.push_back(feedback.gpu_frame_ms);
    return ms;
}

double transient_bytes(const PictureCost& cost) {
    std::uint64_t most = 0;
    for (const systems::Feedback& feedback : cost.rounds)
        for (const systems::PassTiming& pass : feedback.passes)
            most = std::max(most, pass.memory_bytes);
    return static_cast<double>(most);
}

std::string size_text(glm::uvec2 size_px) {
    return fmt::format("{}x{}", size_px.x, size_px.y);
}

}  // namespace rambla::game::study
