#include "assets/import/gltf_shape_check.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "assets/import/gltf_files.h"
#include "assets/import/gltf_value.h"

namespace rambla::assets::gltf {

namespace {

/// A file may have millions of numbers that are out of range.
constexpr std::size_t k_most_warnings = 8;

std::string range_text(const Shape& shape) {
    return number_text(shape.least) + " to " + number_text(shape.most);
}

/// Numbers may have any number of digits.
std::string shortened(std::string_view number) {
    constexpr std::size_t k_longest = 32;
    if (number.size() <= k_longest) return std::string{number};
    return std::string{number.substr(0, k_longest)}.append("...");
}

std::string expectation(const Shape& shape) {
    switch (shape.kind) {
        case JsonKind::object:
            return "an object";
        case JsonKind::array:
            return "an array" + (shape.size > 0 ? " of " + std::to_string(shape.size) : std::string{});
        case JsonKind::whole: {
            char range[80];
            std::snprintf(range, sizeof range, "a whole number from %.0f to %.0f", shape.least, shape.most);
            return range;
        }
        case JsonKind::number:
            return "a number";
        case JsonKind::boolean:
            return "true or false";
        case JsonKind::text:
            return "a string";
        case JsonKind::anything:
            break;
    }
    return "anything";
}

}  // namespace

ShapeMember ShapeCheck::expected() const {
    if (levels_.empty()) return {{}, &document_shape()};
    const Level& level = levels_.back();
    if (level.shape == nullptr) return {{}, nullptr};
    if (level.shape->each != nullptr) return {{}, level.shape->each};
    const auto members = level.shape->members;
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const ShapeMember& member) { return member.name == key_; });
    return found == members.end() ? ShapeMember{{}, nullptr} : *found;
}

void ShapeCheck::count() {
    if (!levels_.empty()) ++levels_.back().index;
}

void ShapeCheck::open(JsonKind kind) {
    if (failure_) return;
    const auto [name, shape] = expected();
    const bool fits = shape == nullptr || shape->kind == kind || shape->kind == JsonKind::anything;
    if (!fits) return fail(*shape, kind == JsonKind::array ? "an array" : "an object");
    levels_.push_back({.shape = shape, .name = name, .index = 0, .is_array = kind == JsonKind::array});
}

void ShapeCheck::close() {
    if (failure_) return;
    const Level closed = levels_.back();
    levels_.pop_back();
    if (closed.is_array && closed.shape != nullptr && closed.shape->size > 0 &&
        closed.index != closed.shape->size) {
        key_ = closed.name;
        return fail(*closed.shape, "an array of " + std::to_string(closed.index));
    }
    count();
}

template <class Describe>
void ShapeCheck::scalar(JsonKind kind, const Describe& describe) {
    if (failure_) return;
    const Shape* const shape = expected().shape;
    if (shape != nullptr && shape->kind != kind && shape->kind != JsonKind::anything)
        return fail(*shape, describe());
    count();
}

void ShapeCheck::null() {
    scalar(JsonKind::anything, [] { return std::string{"null"}; });
}

void ShapeCheck::boolean(bool value) {
    scalar(JsonKind::boolean, [&] { return std::string{value ? "true" : "false"}; });
}

void ShapeCheck::text(std::string_view value) {
    scalar(JsonKind::text, [&] { return "the string " + in_quotes(value); });
}

template <class Describe>
void ShapeCheck::check_number(double value, bool is_whole, const Describe& describe) {
    if (failure_) return;
    const Shape* const shape = expected().shape;
    if (shape != nullptr && shape->kind != JsonKind::anything) {
        const bool inside = value >= shape->least && value <= shape->most;
        const bool fits =
            shape->kind == JsonKind::number || (shape->kind == JsonKind::whole && is_whole && inside);
        if (!fits) return fail(*shape, describe());
        if (!inside && warnings_.size() < k_most_warnings)
            warnings_.push_back(
                {element(), describe() + " is not in " + range_text(*shape) + " and is clamped"});
        else if (!inside)
            ++unreported_;
    }
    count();
}

void ShapeCheck::whole(std::int64_t value) {
    check_number(static_cast<double>(value), true, [&] { return std::to_string(value); });
}

void ShapeCheck::whole(std::uint64_t value) {
    check_number(static_cast<double>(value), true, [&] { return std::to_string(value); });
}

void ShapeCheck::number(double value, bool is_whole, std::string_view written) {
    check_number(value, is_whole, [&] { return shortened(written); });
}

std::vector<Finding> ShapeCheck::take_warnings() {
    if (unreported_ > 0)
        warnings_.push_back(
            {"JSON", std::to_string(unreported_) + " more numbers are not in their range and are clamped"});
    return std::move(warnings_);
}

std::string ShapeCheck::element() const {
    std::string out;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const Level& level = levels_[i];
        if (level.is_array) {
            out.append("[").append(std::to_string(level.index)).append("]");
            continue;
        }
        if (!out.empty()) out.append(".");
        out.append(i + 1 < levels_.size() ? levels_[i + 1].name : std::string_view{key_});
    }
    return out.empty() ? "JSON" : out;
}

void ShapeCheck::fail(const Shape& shape, std::string_view found) {
    failure_.emplace(file_, element(), found, expectation(shape));
}

}  // namespace rambla::assets::gltf
