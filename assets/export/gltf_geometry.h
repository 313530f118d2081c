#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "assets/mesh.h"

namespace rambla::assets {

/// The binary part of a glTF document under construction, with its buffer views and accessors.
class GltfGeometry {
public:
    /// A buffer view of `bytes`, 4-byte aligned. @return its index
    std::size_t add_bytes(std::span<const std::byte> bytes);

    /// The primitive of a mesh, without its material; a mesh asked for again gets the same accessors.
    /// @param key  what identifies the mesh
    [[nodiscard]] nlohmann::json primitive(const Mesh& mesh, std::uint32_t key);

    /// Adds accessors, buffer views and the buffer to the document.
    void finish(nlohmann::json& document) const;

    [[nodiscard]] std::span<const unsigned char> bytes() const { return bytes_; }

private:
    std::size_t add_view(std::span<const std::byte> bytes, int target);
    template <class Vector>
    std::size_t add_vectors(const std::vector<Vector>& values);
    std::size_t add_indices(const Mesh& mesh);

    std::vector<unsigned char> bytes_;
    nlohmann::json views_ = nlohmann::json::array();
    nlohmann::json accessors_ = nlohmann::json::array();
    std::map<std::uint32_t, nlohmann::json> primitives_;
};

}  // namespace rambla::assets
