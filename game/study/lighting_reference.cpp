#include "game/study/lighting_reference.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "assets/trace/reflectance.h"
#include "game/statistics.h"
#include "game/study/frame_tracer.h"
#include "game/study/metrics/flip.h"
#include "game/study/metrics/psnr.h"
#include "game/study/metrics/texels.h"
#include "systems/pipeline.h"

namespace rambla::game::study {
namespace {

/// What the reference has none of.
void take_sky_light_out(systems::Frame& frame) {
    frame.environment.sky_zenith_radiance = glm::vec3{0.0f};
    frame.environment.sky_horizon_radiance = glm::vec3{0.0f};
    frame.environment.ground_radiance = glm::vec3{0.0f};
}

/// The looks of a Frame's objects; one that is drawn in parts has that of its last.
class Looks {
public:
    Looks(const systems::Frame& frame, const std::vector<assets::Material>& materials) {
        for (const systems::DrawBatch& batch : frame.opaque) {
            const bool known = batch.material < materials.size();
            for (std::uint32_t i = 0; i < batch.instance_count; ++i)
                of_object_[frame.instances[batch.first_instance + i].object] =
                    known ? materials[batch.material] : assets::Material{};
        }
    }

    [[nodiscard]] assets::ReflectingPoint at(const assets::TraceHit& hit) const {
        const assets::Material& look = of_object_.at(hit.object);
        return {.normal = hit.shading_normal,
                .base_colour = glm::dvec3{look.base_colour},
                .roughness = static_cast<double>(look.roughness),
                .metalness = static_cast<double>(look.metalness)};
    }

private:
    std::map<std::uint32_t, assets::Material> of_object_;
};

glm::dvec3 radiance(const systems::Frame& frame, const assets::ReflectingPoint& point,
                    const glm::dvec3& position_m) {
    const glm::dvec3 to_eye = -glm::normalize(position_m);  // camera-relative: the eye is the origin
    const auto& sun = frame.environment;
    glm::dvec3 sum = glm::dvec3{sun.sun_illuminance} *
                     assets::reflected_ggx(point, to_eye, glm::dvec3{sun.direction_to_sun});
    for (const systems::FrameLight& light : frame.directional_lights)
        sum +=
            glm::dvec3{light.intensity} * assets::reflected_ggx(point, to_eye, -glm::dvec3{light.direction});
    for (const systems::FrameLight& light : frame.lights) {
        const glm::dvec3 offset = glm::dvec3{light.position_m} - position_m;
        const double distance_m = glm::length(offset);
        const double share = assets::lamp_attenuation(distance_m, static_cast<double>(light.radius_m));
        if (share == 0.0) continue;
        const glm::dvec3 to_light = distance_m > 0.0 ? offset / distance_m : point.normal;
        sum += glm::dvec3{light.intensity} * (share * assets::reflected_ggx(point, to_eye, to_light));
    }
    return sum;
}

/// Some texels of a picture, in a row.
Picture exposed(const Picture& picture, const std::vector<std::size_t>& texels, float exposure_ev) {
    Picture row{.width = static_cast<std::uint32_t>(texels.size()), .height = 1};
    for (const std::size_t texel : texels)
        row.texels.push_back(picture.texels[texel] * std::exp2(exposure_ev));
    return row;
}

/// @param texels  one at least
double mean_of(const std::vector<float>& map, const std::vector<std::size_t>& texels) {
    double sum = 0.0;
    for (const std::size_t texel : texels)
        sum += static_cast<double>(map[texel]);
    return sum / static_cast<double>(texels.size());
}

constexpr double k_hundredth_of_white = 0.01;

}  // namespace

LightingReference::LightingReference(Stage& stage, const assets::ProcessedScene& processed,
                                     const systems::Eye& eye)
    : eye_{eye}, picture_{.width = eye.size_px.x, .height = eye.size_px.y} {
    systems::Frame frame;
    systems::build_frame(*stage.world, eye, 1.0f, frame);
    const FrameTracer traced{frame, *stage.scene, processed};
    const assets::HitPicture seen = assets::trace_picture(traced.tracer(), traced.camera());
    const Looks looks{frame, processed.materials};
    objects_ = object_ids(seen);
    picture_.texels.resize(seen.hits.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, seen.hits.size()}, [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const assets::TraceHit& hit = seen.hits[i];
            if (hit.exists()) picture_.texels[i] = glm::vec3{radiance(frame, looks.at(hit), hit.position_m)};
        }
    });
}

std::vector<Metric> LightingReference::error_of(StudyContext& context, Stage& stage,
                                                const PictureGrade& grade) const {
    PictureGrade plain = grade;
    plain.settings.shadows.method = render::ShadowMethod::off;
    plain.settings.anti_aliasing.method = render::AntiAliasing::none;
    plain.change = take_sky_light_out;
    const render::FrameOutput drawn =
        draw(context.thread(), stage, plain, eye_, {.linear = true, .objects = true});
    return lighting_errors(picture_, objects_, to_picture(drawn.linear.value()), drawn.objects->ids,
                           stage.exposure_ev);
}

std::vector<Metric> lighting_errors(const Picture& expected, std::span<const std::uint32_t> expected_objects,
                                    Picture found, std::span<const std::uint32_t> found_objects,
                                    float exposure_ev) {
    std::vector<double> errors;
    std::vector<std::size_t> compared;
    for (std::size_t i = 0; i < expected_objects.size(); ++i) {
        if (expected_objects[i] == assets::k_none || found_objects[i] != expected_objects[i]) {
            // No difference, and still the reference's light: HDR-FLIP's exposures come from its median.
            found.texels[i] = expected.texels[i];
            continue;
        }
        const double away = largest_channel_difference(found.texels[i], expected.texels[i]);
        errors.push_back(away / (luminance(glm::dvec3{expected.texels[i]}) + k_hundredth_of_white));
        compared.push_back(i);
    }
    const Metric share{"compared_pct", percent(compared.size(), expected_objects.size()), "%"};
    if (compared.empty()) return {share};  // the rest would be that of equal pictures
    return {{"flip_mean", mean_of(hdr_flip(expected, found).map, compared), ""},
            {"psnr_db",
             psnr_db(exposed(expected, compared, exposure_ev), exposed(found, compared, exposure_ev)), "dB"},
            {"error_p99_linear", percentile(errors, 0.99), ""},
            share};
}

}  // namespace rambla::game::study
