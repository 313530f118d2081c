#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rambla::game::study {

/// A place in a JSON file from anywhere. Asked for what is not there, it throws assets::Error with the file,
/// the place (`grades[3].metrics[0].value`), what is there and what should be. The JSON outlives it.
class JsonReader {
public:
    /// @param file  named in errors
    JsonReader(const nlohmann::json& value, std::string file) : value_(&value), file_(std::move(file)) {}

    /// A member of an object.
    [[nodiscard]] JsonReader member(const char* name) const;
    /// A member of an object that files of earlier versions lack.
    [[nodiscard]] std::optional<JsonReader> optional_member(const char* name) const;
    /// The items of an array.
    [[nodiscard]] std::vector<JsonReader> items() const;
    /// The items of an array that has this many.
    [[nodiscard]] std::vector<JsonReader> items(std::size_t count) const;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool boolean() const;
    /// A number, or one of the texts "inf", "-inf" and "nan".
    [[nodiscard]] double number() const;
    /// The text must be this one.
    void exactly(const char* expected) const;

private:
    JsonReader(const nlohmann::json& value, std::string file, std::string place)
        : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

    [[noreturn]] void refuse(const std::string& expected) const;

    const nlohmann::json* value_;
    std::string file_;
    std::string place_{};  ///< empty at the top
};

}  // namespace rambla::game::study
