#include "render/motion_history.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "assets/scene.h"

namespace rambla::render {
namespace {

/// Rows of what rests are not the same from frame to frame: they are rounded relative to the eye, and joints
/// within a cell of 256 m, of which a float knows 1.5e-5 m. A metre before the eye 5e-5 m are a thirtieth of
/// a pixel of 540 rows.
constexpr double k_rest_m = 5e-5;
/// The same of what lies far off, per metre of distance; and of the axes, which interpolation between two
/// equal steps rounds.
constexpr double k_rest_share = 1e-6;

bool row_moved(const glm::vec4& was, const glm::vec4& is, double shift_m, double scale) {
    const double turned = std::abs(static_cast<double>(was.x) - is.x) +
                          std::abs(static_cast<double>(was.y) - is.y) +
                          std::abs(static_cast<double>(was.z) - is.z);
    const double distance = static_cast<double>(is.w) + shift_m - was.w;
    const double rest_m = k_rest_m + k_rest_share * std::max(std::abs(static_cast<double>(is.w)),
                                                             std::abs(static_cast<double>(was.w)));
    // So that what is no number counts as moved: nothing is known of it.
    return !(turned <= k_rest_share * scale) || !(std::abs(distance) <= rest_m);
}

/// Of an Instance or a JointMatrix.
template <class Rows>
bool rows_moved(const Rows& was, const Rows& is, glm::dvec3 shift_m) {
    const auto size = [](const glm::vec4& row) {
        return std::abs(row.x) + std::abs(row.y) + std::abs(row.z);
    };
    const double scale = std::max({size(is.row0), size(is.row1), size(is.row2)});
    return row_moved(was.row0, is.row0, shift_m.x, scale) || row_moved(was.row1, is.row1, shift_m.y, scale) ||
           row_moved(was.row2, is.row2, shift_m.z, scale);
}

/// Lists of terms end with weight 0.
bool terms_differ(std::span<const systems::MorphTerm> was, std::span<const systems::MorphTerm> is) {
    for (std::size_t i = 0; i < was.size() && i < is.size(); ++i) {
        if (was[i].weight != is[i].weight) return true;
        if (is[i].weight == 0.0f) return false;
        if (was[i].target != is[i].target) return true;
    }
    return was.size() != is.size();
}

bool is_skinned(std::uint32_t pipeline) {
    return systems::unpack_pipeline(pipeline).skinned;
}
bool is_morphed(std::uint32_t pipeline) {
    return systems::unpack_pipeline(pipeline).morphed;
}

/// The joints of a skin end where those of the next one begin.
std::span<const systems::JointMatrix> joints_from(std::uint32_t first, std::span<const std::uint32_t> skins,
                                                  std::span<const systems::JointMatrix> joints) {
    const auto next = std::upper_bound(skins.begin(), skins.end(), first);
    const std::size_t end = next == skins.end() ? joints.size() : *next;
    return first <= end ? joints.subspan(first, end - first) : std::span<const systems::JointMatrix>{};
}

}  // namespace

void MotionHistory::forget() {
    for (Moment& moment : moments_)
        moment.things.clear();
}

const MovedThings& MotionHistory::follow(const systems::Frame& frame, glm::dvec3 eye_shift_m) {
    const Moment& then = moments_[latest_];
    latest_ = 1 - latest_;
    Moment& now = moments_[latest_];
    remember(frame, now);
    past_row_.assign(frame.instances.size(), assets::k_none);
    match(then, now, eye_shift_m);
    collect(frame, then);
    return moved_;
}

void MotionHistory::remember(const systems::Frame& frame, Moment& moment) {
    moment.instances = frame.instances;
    moment.joints = frame.joints;
    moment.morphs = frame.morphs;
    moment.things.clear();
    moment.skins.clear();
    const auto add = [&](const systems::DrawBatch& batch) {
        for (std::uint32_t i = batch.first_instance; i < batch.first_instance + batch.instance_count; ++i) {
            const systems::Instance& instance = frame.instances[i];
            moment.things.push_back({instance.object, batch.mesh, batch.material, i, batch.pipeline});
            if (is_skinned(batch.pipeline)) moment.skins.push_back(instance.joints);
        }
    };
    for (const systems::DrawBatch& batch : frame.opaque)
        add(batch);
    for (const systems::DrawBatch& batch : frame.blended)  // what fades may be whole in the next frame
        if (systems::unpack_pipeline(batch.pipeline).fading) add(batch);
    for (std::size_t row = 0; row < frame.casters.size(); ++row)
        if (is_skinned(frame.casters.pipeline[row]))
            moment.skins.push_back(frame.instances[frame.casters.instance[row]].joints);
    std::sort(moment.skins.begin(), moment.skins.end());
    std::sort(moment.things.begin(), moment.things.end(), [](const Thing& a, const Thing& b) {
        return std::tie(a.object, a.mesh, a.material, a.instance) <
               std::tie(b.object, b.mesh, b.material, b.instance);
    });
}

void MotionHistory::match(const Moment& then, const Moment& now, glm::dvec3 eye_shift_m) {
    const auto key = [](const Thing& thing) {
        return std::tie(thing.object, thing.mesh, thing.material);
    };
    auto was = then.things.begin();
    for (const Thing& is : now.things) {
        while (was != then.things.end() && key(*was) < key(is))
            ++was;
        if (was == then.things.end()) return;
        if (key(*was) != key(is)) continue;
        if (has_moved(then, *was, now, is, eye_shift_m)) past_row_[is.instance] = was->instance;
        ++was;
    }
}

bool MotionHistory::has_moved(const Moment& then, const Thing& was, const Moment& now, const Thing& is,
                              glm::dvec3 eye_shift_m) {
    const systems::Instance& before = then.instances[was.instance];
    const systems::Instance& after = now.instances[is.instance];
    const bool skinned = is_skinned(is.pipeline);
    const bool morphed = is_morphed(is.pipeline);
    if (skinned != is_skinned(was.pipeline) || morphed != is_morphed(was.pipeline)) return false;
    if (skinned) {
        const auto joints_then = joints_from(before.joints, then.skins, then.joints);
        const auto joints_now = joints_from(after.joints, now.skins, now.joints);
        if (joints_then.size() != joints_now.size()) return false;
        for (std::size_t i = 0; i < joints_now.size(); ++i)
            if (rows_moved(joints_then[i], joints_now[i], eye_shift_m)) return true;
    } else if (rows_moved(before, after, eye_shift_m)) {
        return true;
    }
    return morphed && terms_differ(std::span{then.morphs}.subspan(before.morphs),
                                   std::span{now.morphs}.subspan(after.morphs));
}

void MotionHistory::collect(const systems::Frame& frame, const Moment& then) {
    moved_.batches.clear();
    moved_.instances.clear();
    moved_.joints = {};
    moved_.morphs = {};
    const auto rows = static_cast<std::uint32_t>(frame.instances.size());
    for (const systems::DrawBatch& batch : frame.opaque) {
        systems::DrawBatch moved = batch;
        moved.first_instance = rows + static_cast<std::uint32_t>(moved_.instances.size());
        moved.instance_count = 0;
        for (std::uint32_t i = batch.first_instance; i < batch.first_instance + batch.instance_count; ++i) {
            if (past_row_[i] == assets::k_none) continue;
            moved_.instances.push_back(frame.instances[i]);
            ++moved.instance_count;
        }
        if (moved.instance_count == 0) continue;
        moved_.batches.push_back(moved);
        if (is_skinned(batch.pipeline)) moved_.joints = then.joints;
        if (is_morphed(batch.pipeline)) moved_.morphs = then.morphs;
    }
    for (const systems::DrawBatch& batch : frame.opaque) {
        for (std::uint32_t i = batch.first_instance; i < batch.first_instance + batch.instance_count; ++i) {
            if (past_row_[i] == assets::k_none) continue;
            systems::Instance& was = moved_.instances.emplace_back(then.instances[past_row_[i]]);
            was.joints += static_cast<std::uint32_t>(frame.joints.size());
            was.morphs += static_cast<std::uint32_t>(frame.morphs.size());
            was.material = frame.instances[i].material;
        }
    }
}

}  // namespace rambla::render
