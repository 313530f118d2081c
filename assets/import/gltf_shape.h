#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace rambla::assets::gltf {

enum class JsonKind : std::uint8_t { anything, object, array, whole, number, boolean, text };

struct Shape;

struct ShapeMember {
    std::string_view name;
    const Shape* shape;
};

/// What may stand at a place of a document: the part of glTF's schema that the importer relies on. Members
/// without a shape may be anything.
struct Shape {
    JsonKind kind = JsonKind::anything;
    std::span<const ShapeMember> members{};  ///< of an object, by name
    const Shape* each = nullptr;             ///< of the elements of an array, or of all members of an object
    std::uint64_t size = 0;                  ///< of an array; 0: any
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
};

/// The shape of a whole document (glTF 2.0, chapter 5, and the extensions that are supported).
[[nodiscard]] const Shape& document_shape();

}  // namespace rambla::assets::gltf
