#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "assets/import/gltf_document.h"
#include "assets/scene.h"

namespace rambla::assets::gltf {

/// Fills `scene.textures` and `scene.images` with what the materials use and points their slots there. A
/// texture that serves as colour and as data appears twice. Pictures are decoded on all threads; one that
/// cannot be becomes the placeholder, with one warning.
/// @return  for each of `scene.images` the document's image, k_none for textures that have none
/// @throws Error  for references to samplers or images that do not exist
std::vector<std::uint32_t> import_textures(const Document& document, Scene& scene);

/// The bytes of a picture as they are stored: in the document, or read from a file of their own.
class EncodedImage {
public:
    EncodedImage(std::string name, std::span<const std::byte> in_document)
        : name_{std::move(name)}, in_document_{in_document} {}
    EncodedImage(std::string name, std::vector<unsigned char> file)
        : name_{std::move(name)}, file_{std::move(file)} {}

    [[nodiscard]] std::span<const std::byte> bytes() const {
        return file_.empty() ? in_document_ : std::as_bytes(std::span{file_});
    }
    [[nodiscard]] const std::string& name() const { return name_; }  ///< for errors

private:
    std::string name_;
    std::span<const std::byte> in_document_;
    std::vector<unsigned char> file_;
};

/// @throws Error  when there are none to be read
[[nodiscard]] EncodedImage encoded_image(const Document& document, std::size_t index);

}  // namespace rambla::assets::gltf
