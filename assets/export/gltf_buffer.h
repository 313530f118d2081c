#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace rambla::assets {

/// The binary part of a glTF document under construction, with its buffer views and accessors.
class GltfBuffer {
public:
    /// Numbers of the glTF format, which are those of OpenGL.
    enum class Target { none = 0, vertices = 34962, indices = 34963 };
    enum class Component { u16 = 5123, u32 = 5125, f32 = 5126 };

    struct Form {
        Component component = Component::f32;
        std::string type;  ///< "SCALAR", "VEC3", "MAT4" ...
        Target target = Target::none;
    };

    /// A buffer view of `bytes`, 4-byte aligned. @return its index
    std::size_t add_bytes(std::span<const std::byte> bytes, Target target = Target::none);

    /// An accessor of `count` elements. @return its index
    std::size_t add(std::span<const std::byte> bytes, std::size_t count, const Form& form);
    /// An accessor of vectors, for vertices.
    template <class Vector>
    std::size_t add_vectors(const std::vector<Vector>& values) {
        return add(std::as_bytes(std::span{values}), values.size(),
                   {Component::f32, "VEC" + std::to_string(Vector::length()), Target::vertices});
    }
    /// An accessor that takes no room: all its elements are zero.
    std::size_t add_zeros(std::size_t count, const std::string& type);
    /// States the least and the largest of each component, which glTF asks for in places.
    void set_range(std::size_t accessor, nlohmann::json least, nlohmann::json largest);

    /// Adds accessors, buffer views and the buffer to the document.
    void finish(nlohmann::json& document) const;

    [[nodiscard]] std::span<const unsigned char> bytes() const { return bytes_; }

private:
    std::vector<unsigned char> bytes_;
    nlohmann::json views_ = nlohmann::json::array();
    nlohmann::json accessors_ = nlohmann::json::array();
};

}  // namespace rambla::assets
