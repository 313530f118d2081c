#include "game/overlay.h"

#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rambla::game {
namespace {

void choose(const BoundParameter& parameter, const char* label) {
    const auto chosen = static_cast<std::size_t>(parameter.get());
    const std::string now{parameter.choices[chosen]};
    if (!ImGui::BeginCombo(label, now.c_str())) return;
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        const std::string name{parameter.choices[i]};
        if (ImGui::Selectable(name.c_str(), i == chosen)) parameter.set(static_cast<double>(i));
    }
    ImGui::EndCombo();
}

void slide(const BoundParameter& parameter, const char* label) {
    double value = parameter.get();
    // Ranges over several powers of ten are felt by ratio, not by difference.
    const bool wide = parameter.minimum > 0.0 && parameter.maximum / parameter.minimum > 30.0;
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
    const char* const format = parameter.kind == ParameterKind::integer ? "%.0f" : "%.3g";
    if (!ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &parameter.minimum, &parameter.maximum,
                             format, flags)) {
        return;
    }
    parameter.set(parameter.kind == ParameterKind::integer ? std::round(value) : value);
}

void edit(const BoundParameter& parameter, const char* label) {
    switch (parameter.kind) {
        case ParameterKind::boolean: {
            bool on = parameter.get() != 0.0;
            if (ImGui::Checkbox(label, &on)) parameter.set(on ? 1.0 : 0.0);
            break;
        }
        case ParameterKind::choice:
            choose(parameter, label);
            break;
        case ParameterKind::integer:
        case ParameterKind::real:
            slide(parameter, label);
            break;
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%.*s", static_cast<int>(parameter.help.size()), parameter.help.data());
    }
}

void show(const OverlayState& state) {
    ImGui::Text("step %llu, %zu entities in %zu archetypes", static_cast<unsigned long long>(state.steps),
                state.entities, state.archetypes);
    ImGui::Text("%u of %u renderables visible, %u casters", state.counts.visible, state.counts.renderables,
                state.counts.casters);
    ImGui::Text("%u of %u lights reach the picture", state.counts.visible_lights, state.counts.lights);
    ImGui::Text("%u draws, %llu triangles", state.feedback.draws,
                static_cast<unsigned long long>(state.feedback.triangles));
    ImGui::Text("%u GL objects, %.1f MiB", state.feedback.gl_objects,
                static_cast<double>(state.feedback.gpu_memory_bytes) / 1048576.0);
    const systems::TextureFeedback& textures = state.feedback.textures;
    ImGui::Text("textures %.1f of %.1f MiB, %u loads pending, %u images too coarse",
                static_cast<double>(textures.resident_bytes) / 1048576.0,
                static_cast<double>(textures.budget_bytes) / 1048576.0, textures.pending_loads,
                textures.below_demand);
    const systems::ExposureFeedback& exposure = state.feedback.exposure;
    if (exposure.known)
        ImGui::Text("exposure %+.2f EV for a mean luminance of %.3f, %u pixels are no numbers",
                    exposure.departure_ev, exposure.average_luminance, exposure.bad_pixels);
}

}  // namespace

Overlay::Overlay(render::Settings& settings, std::function<void()> own_part)
    : own_part_{std::move(own_part)} {
    add_group("lighting", bind(render::k_lighting_parameters, settings.lighting));
    add_group("G-buffer", bind(render::k_gbuffer_parameters, settings.gbuffer));
    add_group("surface detail", bind(render::k_detail_parameters, settings.detail));
    add_group("reflection model", bind(render::k_brdf_parameters, settings.brdf));
    add_group("shadows", bind(render::k_shadow_parameters, settings.shadows));
    add_group("exposure", bind(render::k_exposure_parameters, settings.exposure));
    add_group("tone mapping", bind(render::k_tone_parameters, settings.tone));
    add_group("bloom", bind(render::k_bloom_parameters, settings.bloom));
    add_group("anti-aliasing", bind(render::k_anti_aliasing_parameters, settings.anti_aliasing));
    add_group("textures", bind(render::k_texture_budget_parameters, settings.textures));
    add_group("debugging", bind(render::k_debug_parameters, settings.debug));
}

void Overlay::add_group(std::string name, std::vector<BoundParameter> parameters) {
    Group group{.name = std::move(name), .parameters = std::move(parameters), .labels = {}};
    for (const BoundParameter& p : group.parameters) {
        // What follows ## makes the label unique without being shown: two groups may share a parameter's
        // name.
        group.labels.push_back(fmt::format("{}{}{}{}##{}", p.name, p.unit.empty() ? "" : " (", p.unit,
                                           p.unit.empty() ? "" : ")", group.name));
    }
    groups_.push_back(std::move(group));
}

void Overlay::draw(const OverlayState& state) {
    ImGui::SetNextWindowPos({12.0f, 12.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({420.0f, 0.0f}, ImGuiCond_FirstUseEver);
    ImGui::Begin("Rambla");
    show(state);
    if (own_part_) own_part_();
    for (const Group& group : groups_) {
        if (!ImGui::CollapsingHeader(group.name.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) continue;
        for (std::size_t i = 0; i < group.parameters.size(); ++i)
            edit(group.parameters[i], group.labels[i].c_str());
    }
    ImGui::End();
}

}  // namespace rambla::game
