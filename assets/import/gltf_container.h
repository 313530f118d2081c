#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rambla::assets::gltf {

/// The two parts of a glTF file, in place; a .gltf has no binary one.
struct Container {
    std::string_view json;
    std::span<const unsigned char> binary;
    std::span<const unsigned char>
        plain_glb;  ///< the whole GLB, if it holds these two parts and nothing else
};

/// Finds the parts of a .gltf or .glb by its content and checks every length of the GLB header.
/// @param file  name for errors; a name that ends in .glb must hold a GLB
/// @throws Error
[[nodiscard]] Container split_container(const std::string& file, std::span<const unsigned char> bytes);

/// A GLB of a JSON text and `binary`, padded as the format asks.
[[nodiscard]] std::vector<unsigned char> join_container(std::string_view json,
                                                        std::span<const unsigned char> binary);

}  // namespace rambla::assets::gltf
