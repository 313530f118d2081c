#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/error.h"
#include "assets/import/gltf_shape.h"

namespace rambla::assets::gltf {

/// What a message says of an element.
struct Finding {
    std::string element;
    std::string text;
};

/// Compares a document with the shape that glTF gives it, value by value as they are read: tinygltf takes
/// what has another type for absent, and cuts references to 32 bits. Whatever is wrong is refused, but for
/// numbers out of their range, which the importer clamps.
class ShapeCheck {
public:
    /// @param file  for the messages; must live as long as this
    explicit ShapeCheck(const std::string& file) : file_{file} {}

    // To be called in the order of the text.

    void key(std::string_view name) {
        if (!failure_) key_ = name;
    }
    void open_object() { open(JsonKind::object); }
    void open_array() { open(JsonKind::array); }
    void close();
    void null();
    void boolean(bool value);
    void text(std::string_view value);
    void whole(std::int64_t value);
    void whole(std::uint64_t value);
    /// @param is_whole  it is an integer as far as later readers are concerned
    /// @param written   as the file has it
    void number(double value, bool is_whole, std::string_view written);

    /// @throws Error  for the first value that is not what must stand there
    void require() const {
        if (failure_) throw *failure_;
    }
    /// The first few numbers that were out of their range.
    [[nodiscard]] std::vector<Finding> take_warnings();

private:
    struct Level {
        const Shape* shape = nullptr;  ///< null: anything
        std::string_view name;         ///< under which it stands in its parent, if that is an object
        std::uint64_t index = 0;       ///< of the value that comes
        bool is_array = false;
    };

    /// What must come next: its shape, null for anything, and its name if the table has one.
    [[nodiscard]] ShapeMember expected() const;
    void count();
    void open(JsonKind kind);
    template <class Describe>
    void scalar(JsonKind kind, const Describe& describe);
    template <class Describe>
    void check_number(double value, bool is_whole, const Describe& describe);
    [[nodiscard]] std::string element() const;
    /// What follows is looked at no more: other things that a reader finds may be said before.
    void fail(const Shape& shape, std::string_view found);

    const std::string& file_;
    std::vector<Level> levels_;
    std::string key_;
    std::vector<Finding> warnings_;
    std::uint64_t unreported_ = 0;
    std::optional<Error> failure_;
};

}  // namespace rambla::assets::gltf
