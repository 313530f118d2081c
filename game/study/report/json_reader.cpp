#include "game/study/report/json_reader.h"

#include <spdlog/fmt/fmt.h>

#include <limits>

#include "assets/error.h"

namespace rambla::game::study {
namespace {

using Json = nlohmann::json;

/// What stands there, short enough for one line.
std::string shown(const Json& value) {
    if (value.is_object() || value.is_array())
        return fmt::format("an {} of {}", value.is_object() ? "object" : "array", value.size());
    constexpr std::size_t k_longest = 60;
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() <= k_longest ? text : text.substr(0, k_longest).append("...");
}

}  // namespace

JsonReader JsonReader::member(const char* name) const {
    if (!value_->is_object()) refuse("an object");
    std::string place = place_.empty() ? std::string{name} : fmt::format("{}.{}", place_, name);
    const auto found = value_->find(name);
    if (found == value_->end()) throw assets::Error{file_, place, "nothing", "a value"};
    return {*found, file_, std::move(place)};
}

std::optional<JsonReader> JsonReader::optional_member(const char* name) const {
    if (value_->is_object() && !value_->contains(name)) return std::nullopt;
    return member(name);
}

std::vector<JsonReader> JsonReader::items() const {
    if (!value_->is_array()) refuse("an array");
    std::vector<JsonReader> readers;
    readers.reserve(value_->size());
    for (const Json& item : *value_)
        readers.push_back(JsonReader{item, file_, fmt::format("{}[{}]", place_, readers.size())});
    return readers;
}

std::vector<JsonReader> JsonReader::items(std::size_t count) const {
    if (!value_->is_array() || value_->size() != count) refuse(fmt::format("an array of {}", count));
    return items();
}

std::string JsonReader::text() const {
    if (!value_->is_string()) refuse("a text");
    return value_->get<std::string>();
}

bool JsonReader::boolean() const {
    if (!value_->is_boolean()) refuse("true or false");
    return value_->get<bool>();
}

double JsonReader::number() const {
    if (value_->is_number()) return value_->get<double>();
    constexpr double k_infinity = std::numeric_limits<double>::infinity();
    if (*value_ == "inf") return k_infinity;
    if (*value_ == "-inf") return -k_infinity;
    if (*value_ == "nan") return std::numeric_limits<double>::quiet_NaN();
    refuse("a number");
}

void JsonReader::exactly(const char* expected) const {
    if (*value_ != expected) refuse(fmt::format("\"{}\"", expected));
}

void JsonReader::refuse(const std::string& expected) const {
    throw assets::Error{file_, place_.empty() ? "top" : place_, shown(*value_), expected};
}

}  // namespace rambla::game::study
