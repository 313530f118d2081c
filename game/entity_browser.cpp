#include "game/entity_browser.h"

#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "systems/reflection.h"

namespace rambla::game {
namespace {

constexpr float k_rows = 6.0f;  // of each list; more are scrolled to

/// Calls row(index) for those that are seen.
template <class Row>
void list(const char* label, std::size_t count, const Row& row) {
    const float rows = std::clamp(static_cast<float>(count), 1.0f, k_rows);
    if (!ImGui::BeginListBox(label, {-1.0f, (rows + 0.5f) * ImGui::GetTextLineHeightWithSpacing()})) return;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            row(static_cast<std::size_t>(i));
            ImGui::PopID();
        }
    }
    ImGui::EndListBox();
}

/// Names as C++ has them, without their namespaces.
std::string short_name(std::string_view type) {
    const std::size_t end = type.find('<');
    const std::size_t colon = type.rfind("::", end == std::string_view::npos ? type.size() : end);
    return std::string{colon == std::string_view::npos ? type : type.substr(colon + 2)};
}

std::string name_of(const ecs::ArchetypeStats& archetype) {
    std::string name = fmt::format("{}:", archetype.rows);
    for (const std::string_view component : archetype.components)
        name.append(" ").append(short_name(component));
    return archetype.components.empty() ? name + " nothing" : name;
}

std::string name_of(ecs::Entity entity) {
    return fmt::format("entity {}, generation {}", entity.index, entity.generation);
}

std::string text_of(const ecs::FieldDescription& field, const ecs::FieldValue& value) {
    const auto named = [&](auto number) {
        const std::string_view name = ecs::name_of(field, static_cast<std::int64_t>(number));
        return name.empty() ? fmt::format("{}", number) : std::string{name};
    };
    struct Text {
        decltype(named)& number;
        std::string operator()(bool on) const { return on ? "true" : "false"; }
        std::string operator()(std::int64_t v) const { return number(v); }
        std::string operator()(std::uint64_t v) const { return number(v); }
        std::string operator()(double v) const { return fmt::format("{:.6g}", v); }
        std::string operator()(ecs::Entity entity) const { return name_of(entity); }
        std::string operator()(const std::string& text) const { return text; }
    };
    return std::visit(Text{named}, value);
}

/// The largest number of either sign that a field of that kind holds.
double most_of(ecs::FieldKind kind) {
    return kind == ecs::FieldKind::float32 ? static_cast<double>(std::numeric_limits<float>::max())
                                           : std::numeric_limits<double>::max();
}

/// Kept inside the field's range, which the field would refuse to leave, and finite.
double in_range(const ecs::FieldDescription& field, double value) {
    const double most = most_of(field.kind);
    return std::clamp(std::clamp(value, -most, most), field.options.min, field.options.max);
}

}  // namespace

EntityBrowser::EntityBrowser(ecs::World& world) : world_{world}, registry_{systems::component_registry()} {}

void EntityBrowser::draw() {
    if (!ImGui::CollapsingHeader("entities")) return;
    if (!world_.alive(chosen_)) chosen_ = {};
    list_archetypes();
    list_entities();
    if (chosen_ != ecs::Entity{}) show_components();
}

void EntityBrowser::list_archetypes() {
    const std::vector<ecs::ArchetypeStats> archetypes = world_.archetype_stats();
    archetype_ = std::min(archetype_, archetypes.size() - 1);
    list("##archetypes", archetypes.size(), [&](std::size_t i) {
        if (ImGui::Selectable("##archetype", i == archetype_)) archetype_ = i;
        ImGui::SameLine();
        ImGui::TextUnformatted(name_of(archetypes[i]).c_str());
    });
}

void EntityBrowser::list_entities() {
    const std::span<const ecs::Entity> entities = ecs::entities_of_archetype(world_, archetype_);
    list("##entities", entities.size(), [&](std::size_t i) {
        if (ImGui::Selectable("##entity", entities[i] == chosen_)) chosen_ = entities[i];
        ImGui::SameLine();
        ImGui::TextUnformatted(name_of(entities[i]).c_str());
    });
}

void EntityBrowser::show_components() {
    ImGui::TextUnformatted(name_of(chosen_).c_str());
    shown_ = chosen_;  // another one may be chosen on the way
    for (const ecs::InspectedComponent& component : ecs::components_of(world_, registry_, shown_))
        show_component(component);
}

void EntityBrowser::show_component(const ecs::InspectedComponent& component) {
    const std::string name{component.type->name};
    const ecs::StructDescription* const description = component.type->description;
    if (description == nullptr || component.value == nullptr) {
        ImGui::BulletText("%s", name.c_str());
        return;
    }
    if (!ImGui::TreeNodeEx(name.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
    show_struct(component, *description, 0);
    ImGui::TreePop();
}

/// @param offset  of the struct, from the beginning of the component
void EntityBrowser::show_struct(const ecs::InspectedComponent& component,
                                const ecs::StructDescription& description, std::size_t offset) {
    for (const ecs::FieldDescription& field : description.fields)
        for (std::uint32_t element = 0; element < field.count; ++element)
            show_element(component, field, element, offset);
}

void EntityBrowser::show_element(const ecs::InspectedComponent& component, const ecs::FieldDescription& field,
                                 std::uint32_t element, std::size_t offset) {
    std::string label{field.name};
    if (field.count > 1) label += fmt::format("[{}]", element);
    if (field.kind == ecs::FieldKind::structure) {
        if (!ImGui::TreeNodeEx(label.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
        show_struct(component, *field.structure, offset + field.offset + std::size_t{element} * field.stride);
        ImGui::TreePop();
        return;
    }
    if (!field.options.unit.empty()) label += fmt::format(" ({})", field.options.unit);
    const void* const object = static_cast<const std::byte*>(component.value) + offset;
    const ecs::FieldValue value = ecs::get_field(field, object, element);
    const auto change = [&](const ecs::FieldValue& to) {
        set(component, field, element, offset, to);
    };
    if (const auto* const entity = std::get_if<ecs::Entity>(&value)) {
        // Who points where is not for numbers to change: hierarchies keep lists of their own.
        ImGui::Text("%s: %s", label.c_str(), text_of(field, value).c_str());
        ImGui::SameLine();
        ImGui::PushID(label.c_str());
        if (world_.alive(*entity) && ImGui::SmallButton("go to")) chosen_ = *entity;
        ImGui::PopID();
        return;
    }
    // Whole numbers mostly are indices, which whoever follows them believes.
    const bool is_free = std::holds_alternative<double>(value) || std::holds_alternative<bool>(value);
    if (!component.writable || !is_free) {
        ImGui::Text("%s: %s", label.c_str(), text_of(field, value).c_str());
        return;
    }
    ImGui::SetNextItemWidth(0.5f * ImGui::GetContentRegionAvail().x);
    if (const auto* const on = std::get_if<bool>(&value)) {
        bool now = *on;
        if (ImGui::Checkbox(label.c_str(), &now)) change(now);
    } else if (const auto* const real = std::get_if<double>(&value)) {
        double now = *real;
        const auto speed = static_cast<float>(0.01 * std::max(std::abs(now), 0.1));
        if (ImGui::DragScalar(label.c_str(), ImGuiDataType_Double, &now, speed, nullptr, nullptr, "%.6g"))
            if (!std::isnan(now)) change(in_range(field, now));
    }
}

void EntityBrowser::set(const ecs::InspectedComponent& component, const ecs::FieldDescription& field,
                        std::uint32_t element, std::size_t offset, const ecs::FieldValue& value) {
    void* const object = ecs::component_for_writing(world_, *component.type, shown_);
    if (object != nullptr) ecs::set_field(field, static_cast<std::byte*>(object) + offset, value, element);
}

}  // namespace rambla::game
