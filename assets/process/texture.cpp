#include "assets/process/texture.h"

#include <algorithm>
#include <utility>

#include "assets/process/blocks.h"
#include "assets/process/compress.h"
#include "assets/process/mips.h"

namespace rambla::assets {

namespace {

Image all_ones() {
    return {.name = "white", .width = 1, .height = 1, .texels = std::vector(4, std::byte{255})};
}

std::vector<Image> levels_of(const TextureJob& job, const Image& picture, std::span<const Image> images) {
    switch (job.role) {
        case TextureRole::normals:
            if (picture.format == PixelFormat::rgba8) return normal_mips(picture);
            break;
        case TextureRole::roughness:
            return roughness_mips(picture, images[job.normals],
                                  {.roughness = job.roughness, .normal_scale = job.normal_scale});
        default:
            break;
    }
    return colour_mips(picture, {.colour_space = job.colour_space, .alpha = job.alpha, .cutoff = job.cutoff});
}

bool is_opaque(const Image& image) {
    for (std::size_t i = 3; i < image.texels.size(); i += 4)
        if (image.texels[i] != std::byte{255}) return false;
    return true;
}

/// How a texture lies in its blocks.
struct Layout {
    TexelFormat format = TexelFormat::rgba8;
    Swizzle swizzle = k_no_swizzle;
    std::array<std::size_t, 2> stored{0, 1};  ///< channels of the picture that bc4 and bc5 keep
};

/// Graphics cards know blocks of one or two channels in linear light alone.
Layout layout_of(ChannelMask channels, ColourSpace colour_space, bool opaque) {
    std::vector<std::size_t> used;
    for (std::size_t c = 0; c < 4; ++c)
        if ((channels >> c & 1) != 0) used.push_back(c);
    if (used.empty() || used.size() > 2 || colour_space == ColourSpace::srgb)
        return {.format = (channels & k_alpha) != 0 && !opaque ? TexelFormat::bc3 : TexelFormat::bc1};
    Layout layout;
    layout.format = used.size() == 1 ? TexelFormat::bc4 : TexelFormat::bc5;
    layout.swizzle.fill(ChannelSource::one);
    for (std::size_t i = 0; i < used.size(); ++i) {
        layout.stored[i] = used[i];
        layout.swizzle[used[i]] = i == 0 ? ChannelSource::red : ChannelSource::green;
    }
    return layout;
}

/// The picture with the kept channels in front.
Image arranged(const Image& image, const Layout& layout) {
    if (layout.format != TexelFormat::bc4 && layout.format != TexelFormat::bc5) return image;
    Image out = image;
    for (std::size_t i = 0; i < image.texels.size(); i += 4)
        for (std::size_t c = 0; c < 2; ++c)
            out.texels[i + c] = image.texels[i + layout.stored[c]];
    return out;
}

}  // namespace

TextureData process_texture(const TextureJob& job, ChannelMask channels, std::span<const Image> images,
                            const TextureParameters& parameters) {
    const Image ones = job.image == k_none ? all_ones() : Image{};
    const Image& picture = job.image == k_none ? ones : images[job.image];
    std::vector<Image> levels = levels_of(job, picture, images);
    const Image& finest = levels.front();

    Layout layout;
    if (picture.format == PixelFormat::rgba32f) {
        layout.format = TexelFormat::rgba32f;
    } else if (parameters.compression != Compression::off && job.role != TextureRole::light) {
        const Layout blocks =
            layout_of(channels, job.colour_space, std::all_of(levels.begin(), levels.end(), is_opaque));
        if (stored_size(blocks.format, finest.width, finest.height) <
            stored_size(TexelFormat::rgba8, finest.width, finest.height))
            layout = blocks;
    }
    const bool plain = layout.format == TexelFormat::rgba8 || layout.format == TexelFormat::rgba32f;
    const CompressionEffort effort =
        parameters.compression == Compression::good ? CompressionEffort::good : CompressionEffort::fast;

    TextureData texture{.name = picture.name,
                        .format = layout.format,
                        .colour_space = job.colour_space,
                        .swizzle = layout.swizzle,
                        .normal_map = job.role == TextureRole::normals,
                        .levels = {},
                        .bytes = {}};
    std::size_t bytes = 0;
    for (const Image& level : levels)
        bytes += stored_size(layout.format, level.width, level.height);
    texture.bytes.reserve(bytes);
    for (Image& level : levels) {
        CompressedImage stored;
        if (plain)
            stored.bytes = std::move(level.texels);
        else
            stored = compressed(arranged(level, layout), layout.format, effort);
        level.texels = {};
        texture.levels.push_back({.width = level.width,
                                  .height = level.height,
                                  .offset = texture.bytes.size(),
                                  .size = stored.bytes.size(),
                                  .rms_error = static_cast<float>(stored.rms_error)});
        texture.bytes.insert(texture.bytes.end(), stored.bytes.begin(), stored.bytes.end());
    }
    return texture;
}

}  // namespace rambla::assets
