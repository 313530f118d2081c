#include "assets/import/gltf_texture.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "assets/error.h"
#include "assets/import/gltf_files.h"
#include "assets/import/gltf_picture_budget.h"
#include "assets/import/image.h"

namespace rambla::assets::gltf {

namespace {

struct Use {
    TextureSlot Material::*slot;
    ColourSpace colour_space;
};

constexpr std::array<Use, 10> k_uses{{{&Material::base_colour_texture, ColourSpace::srgb},
                                      {&Material::metalness_roughness_texture, ColourSpace::linear},
                                      {&Material::normal_texture, ColourSpace::linear},
                                      {&Material::occlusion_texture, ColourSpace::linear},
                                      {&Material::emissive_texture, ColourSpace::srgb},
                                      {&Material::specular_texture, ColourSpace::linear},
                                      {&Material::specular_colour_texture, ColourSpace::srgb},
                                      {&Material::transmission_texture, ColourSpace::linear},
                                      {&Material::height_texture, ColourSpace::linear},
                                      {&Material::light_map_texture, ColourSpace::srgb}}};

/// Says what it is that the functions below do not know. tinygltf gives −1 for what is absent.
void warn_of_unknown(const Document& document) {
    const auto say = [&](std::size_t index, const char* member, int found, const char* used) {
        document.warn(element_name("samplers", index, member),
                      std::to_string(found) + " is unknown, " + used + " is used");
    };
    const auto is_wrap = [](int mode) {
        return mode == TINYGLTF_TEXTURE_WRAP_REPEAT || mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ||
               mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
    };
    for (std::size_t i = 0; i < document.model.samplers.size(); ++i) {
        const tinygltf::Sampler& sampler = document.model.samplers[i];
        if (!is_wrap(sampler.wrapS)) say(i, ".wrapS", sampler.wrapS, "10497 (repeat)");
        if (!is_wrap(sampler.wrapT)) say(i, ".wrapT", sampler.wrapT, "10497 (repeat)");
        const bool plain = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                           sampler.magFilter == TINYGLTF_TEXTURE_FILTER_LINEAR || sampler.magFilter == -1;
        if (!plain) say(i, ".magFilter", sampler.magFilter, "9729 (linear)");
        const int minify = sampler.minFilter;
        const bool known = minify == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                           minify == TINYGLTF_TEXTURE_FILTER_LINEAR || minify == -1 ||
                           (minify >= TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST &&
                            minify <= TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR);
        if (!known) say(i, ".minFilter", minify, "9987 (linear between linear levels)");
    }
}

WrapMode wrap_mode(int mode) {
    switch (mode) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return WrapMode::clamp_to_edge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return WrapMode::mirrored_repeat;
        default:
            return WrapMode::repeat;
    }
}

Sampler sampler_of(const tinygltf::Sampler& source) {
    Sampler sampler{.wrap_u = wrap_mode(source.wrapS), .wrap_v = wrap_mode(source.wrapT)};
    if (source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) sampler.magnify = Filter::nearest;
    switch (source.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            sampler.minify = Filter::nearest;
            break;
        default:
            break;
    }
    switch (source.minFilter) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            sampler.mip = MipFilter::none;
            break;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
            sampler.mip = MipFilter::nearest;
            break;
        default:
            break;
    }
    return sampler;
}

/// The encoded bytes of a picture inside a buffer view, checked like an accessor.
std::span<const std::byte> view_bytes(const Document& document, int index, const std::string& element) {
    const tinygltf::Model& model = document.model;
    const tinygltf::BufferView& view =
        model.bufferViews[document.checked(index, model.bufferViews.size(), element, "buffer view")];
    const auto& data =
        model.buffers[document.checked(view.buffer, model.buffers.size(), element, "buffer")].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        document.fail(element, "buffer view " + std::to_string(index), "to end inside its buffer");
    return std::as_bytes(std::span{data}).subspan(view.byteOffset, view.byteLength);
}

/// Decodes `wanted` images of the document; those that fail become placeholders.
std::vector<Image> decode_all(const Document& document, const std::vector<std::uint32_t>& wanted) {
    const std::vector<std::uint64_t> budgets = texel_budgets(document, wanted);
    std::vector<Image> images(wanted.size());
    std::vector<std::string> failures(wanted.size());
    const std::string path = document.path.string() + ": ";
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
        const tinygltf::Image& source = document.model.images[wanted[i]];
        const std::string name = !source.name.empty() ? source.name : source.uri;
        try {
            const EncodedImage encoded = encoded_image(document, wanted[i]);
            images[i] = decode_image(encoded.bytes(), encoded.name(),
                                     {.size_px = document.limits.image_size_px, .texel_bytes = budgets[i]});
            images[i].name = name;
        } catch (const std::exception& error) {
            images[i] = placeholder_image(name);
            failures[i] = error.what();
            // The warning names the document already.
            if (failures[i].starts_with(path)) failures[i].erase(0, path.size());
        }
    });
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (failures[i].empty()) continue;
        const std::string& name = images[i].name;
        document.warn(element_name("images", wanted[i]),
                      in_quotes(name) + " is replaced by a placeholder (" + failures[i] + ")");
    }
    return images;
}

class TextureImport {
public:
    TextureImport(const Document& document, Scene& scene) : document_{document}, scene_{scene} {}

    std::vector<std::uint32_t> run() {
        warn_of_unknown(document_);
        find_uses();
        for (std::size_t i = 0; i < document_.model.textures.size(); ++i)
            for (const ColourSpace space : {ColourSpace::srgb, ColourSpace::linear})
                if (const auto use = textures_.find({i, space}); use != textures_.end())
                    use->second = add(i, space);
        for (Material& material : scene_.materials)
            for (const Use& use : k_uses) {
                TextureSlot& slot = material.*use.slot;
                if (slot.texture != k_none) slot.texture = textures_.at({slot.texture, use.colour_space});
            }
        scene_.images = decode_all(document_, image_sources_);
        for (Texture& texture : scene_.textures)
            if (texture.image == k_placeholder)
                texture.image = static_cast<std::uint32_t>(image_sources_.size());
        if (needs_placeholder_) {
            scene_.images.push_back(placeholder_image("no image"));
            image_sources_.push_back(k_none);
        }
        return std::move(image_sources_);
    }

private:
    static constexpr std::uint32_t k_placeholder = k_none - 1;  ///< index of an image that is appended last

    void find_uses() {
        for (const Material& material : scene_.materials)
            for (const Use& use : k_uses)
                if (const std::uint32_t texture = (material.*use.slot).texture; texture != k_none)
                    textures_[{texture, use.colour_space}] = k_none;
    }

    std::uint32_t add(std::size_t index, ColourSpace space) {
        const tinygltf::Texture& source = document_.model.textures[index];
        const std::string element = element_name("textures", index);
        Texture texture{.name = source.name, .image = k_placeholder, .colour_space = space, .sampler = {}};
        if (source.sampler >= 0)
            texture.sampler = sampler_of(document_.model.samplers[document_.checked(
                source.sampler, document_.model.samplers.size(), element + ".sampler", "sampler")]);
        if (source.source >= 0) {
            texture.image = image(document_.checked(source.source, document_.model.images.size(),
                                                    element + ".source", "image"));
        } else {
            needs_placeholder_ = true;
            if (last_without_image_ != index)
                document_.warn(element, "has no image in a supported format, a placeholder is shown");
            last_without_image_ = index;
        }
        scene_.textures.push_back(std::move(texture));
        return static_cast<std::uint32_t>(scene_.textures.size() - 1);
    }

    std::uint32_t image(std::uint32_t source) {
        const auto [place, is_new] =
            images_.try_emplace(source, static_cast<std::uint32_t>(image_sources_.size()));
        if (is_new) image_sources_.push_back(source);
        return place->second;
    }

    const Document& document_;
    Scene& scene_;
    std::map<std::pair<std::size_t, ColourSpace>, std::uint32_t> textures_;  ///< by the document's index
    std::map<std::uint32_t, std::uint32_t> images_;                          ///< by the document's index
    std::vector<std::uint32_t> image_sources_;
    bool needs_placeholder_ = false;
    std::size_t last_without_image_ = k_none;
};

}  // namespace

EncodedImage encoded_image(const Document& document, std::size_t index) {
    const tinygltf::Image& source = document.model.images[index];
    const std::string element = element_name("images", index);
    const std::string name = document.path.string() + ": " + element;
    if (source.bufferView >= 0)
        return {name, view_bytes(document, source.bufferView, element + ".bufferView")};
    if (!source.image.empty()) return {name, std::as_bytes(std::span{source.image})};
    if (source.uri.starts_with("data:"))
        document.fail(element + ".uri", in_quotes(source.uri.substr(0, 40)), "base64 of a PNG or JPEG");
    const std::filesystem::path file = resolve_uri(document.path, element + ".uri", source.uri);
    return {name + " " + in_quotes(source.uri), read_file(file, document.limits.file_bytes)};
}

std::vector<std::uint32_t> import_textures(const Document& document, Scene& scene) {
    return TextureImport{document, scene}.run();
}

}  // namespace rambla::assets::gltf
