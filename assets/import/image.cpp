#include "assets/import/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include "assets/error.h"
#include "assets/import/exr.h"
#include "assets/import/gltf_files.h"
#include "assets/import/jpeg.h"
#include "assets/import/png.h"

namespace rambla::assets {

namespace {

constexpr std::uint64_t k_largest_file = 4ull << 30;
constexpr int k_channels = 4;

struct Signature {
    std::string_view bytes;
    const char* format;  ///< OpenImageIO's name
};

using namespace std::string_view_literals;

constexpr std::array<Signature, 9> k_signatures{{{"\x89PNG\r\n\x1a\n"sv, "png"},
                                                 {"\xff\xd8\xff"sv, "jpeg"},
                                                 {"#?RADIANCE"sv, "hdr"},
                                                 {"#?RGBE"sv, "hdr"},
                                                 {"\x76\x2f\x31\x01"sv, "openexr"},
                                                 {"II*\0"sv, "tiff"},
                                                 {"MM\0*"sv, "tiff"},
                                                 {"DDS "sv, "dds"},
                                                 {"RIFF"sv, "webp"}}};

/// By content, because names lie; only Targa has no signature and is known by its name.
std::optional<std::string> format_of(std::span<const std::byte> bytes, const std::string& name) {
    const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    for (const Signature& signature : k_signatures)
        if (text.starts_with(signature.bytes))
            return signature.format == "webp"sv ? std::nullopt : std::optional<std::string>{signature.format};
    if (name.ends_with(".tga") || name.ends_with(".TGA")) return "targa";
    return std::nullopt;
}

void replace_all(std::string& text, std::string_view part, std::string_view replacement) {
    for (std::size_t at = text.find(part); at != std::string::npos;
         at = text.find(part, at + replacement.size()))
        text.replace(at, part.size(), replacement);
}

/// The reason of a failure, taken so that OpenImageIO does not print it at exit.
/// @param name  of the picture, which need not be repeated
std::string reason(const OIIO::ImageInput* input, const std::string& name) {
    std::string text = input != nullptr ? input->geterror() : std::string{};
    const std::string global = OIIO::geterror();
    if (text.empty()) text = global;
    const std::string quoted = '"' + name + '"';
    replace_all(text, " (" + quoted + ")", "");
    replace_all(text, " for " + quoted, "");
    replace_all(text, "\n", "; ");
    return text.empty() ? "broken picture" : gltf::in_quotes(text);
}

/// Spreads `channels` values of each texel to RGBA, in place from the back: grey goes to all colours.
template <class T>
void spread_channels(std::vector<std::byte>& texels, std::size_t count, int channels, T opaque) {
    if (channels == k_channels) return;
    T* const values = reinterpret_cast<T*>(texels.data());
    for (std::size_t i = count; i-- > 0;) {
        const T* const in = values + i * static_cast<std::size_t>(channels);
        const std::array<T, k_channels> out = channels == 1   ? std::array{in[0], in[0], in[0], opaque}
                                              : channels == 2 ? std::array{in[0], in[0], in[0], in[1]}
                                                              : std::array{in[0], in[1], in[2], opaque};
        std::copy(out.begin(), out.end(), values + i * k_channels);
    }
}

PixelFormat format_of(const OIIO::ImageSpec& spec) {
    return spec.format.is_floating_point() ? PixelFormat::rgba32f : PixelFormat::rgba8;
}

/// What a library has read off the head, before it makes room for the rest.
void check_size(const OIIO::ImageSpec& spec, const std::string& name, const PictureLimits& limits) {
    const auto most_px = static_cast<std::int64_t>(limits.size_px);
    const auto beyond = [&](int width, int height) {
        return width > most_px || height > most_px;
    };
    if (spec.width < 1 || spec.height < 1 || beyond(spec.width, spec.height) || spec.depth > 1)
        throw Error{name, "", std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
                    "1 to " + std::to_string(most_px) + " each way"};
    if (beyond(spec.tile_width, spec.tile_height) || spec.tile_depth > 1)
        throw Error{name, "",
                    "tiles of " + std::to_string(spec.tile_width) + " x " + std::to_string(spec.tile_height),
                    "at most " + std::to_string(most_px) + " each way"};
    constexpr int k_most_channels = 64;
    if (spec.nchannels < 1 || spec.nchannels > k_most_channels)
        throw Error{name, "", std::to_string(spec.nchannels) + " channels", "1 to 64"};
    const auto texels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    const std::uint64_t bytes = texels * bytes_per_texel(format_of(spec));
    if (bytes > limits.texel_bytes)
        throw Error{name, "", std::to_string(bytes) + " bytes of texels",
                    "at most " + std::to_string(limits.texel_bytes) + " for a file of this size"};
}

/// A file in memory that has an end: OpenImageIO's own reader (2.4) takes offsets of the picture's tables as
/// they are and reads behind it.
class MemoryFile final : public OIIO::Filesystem::IOMemReader {
public:
    using IOMemReader::IOMemReader;

    std::size_t pread(void* out, std::size_t size, std::int64_t offset) override {
        const std::span<const unsigned char> file{m_buf.data(), static_cast<std::size_t>(m_buf.size())};
        if (offset < 0 || static_cast<std::uint64_t>(offset) >= file.size()) return 0;
        const auto rest = file.subspan(static_cast<std::size_t>(offset));
        const std::size_t count = std::min(size, rest.size());
        std::memcpy(out, rest.data(), count);
        return count;
    }

    std::size_t read(void* out, std::size_t size) override {
        const std::size_t count = pread(out, size, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
};

/// A picture in memory, opened for reading; its head keeps to the limits.
class OpenPicture {
public:
    /// @param bytes  must outlive the object  @throws Error
    OpenPicture(std::span<const std::byte> bytes, const std::string& name, PictureLimits limits) {
        limits.texel_bytes = std::min(limits.texel_bytes, most_texel_bytes(bytes.size()));
        const std::optional<std::string> format = format_of(bytes, name);
        if (!format)
            throw Error{name, "", bytes.empty() ? "an empty picture" : "an unknown picture format",
                        "PNG, JPEG, HDR, EXR, TIFF, TGA or DDS"};
        format_ = *format;
        input_ = OIIO::ImageInput::create(format_);
        if (!input_) throw Error{name, "", reason(nullptr, name), ""};
        if (format_ == "png") {
            essential_ = essential_png(bytes, name);
            bytes = essential_;
        }
        if (format_ == "jpeg") {
            essential_ = essential_jpeg(bytes, name, limits.size_px);
            bytes = essential_;
        }
        if (format_ == "openexr") check_exr(bytes, name, limits.size_px);
        memory_.emplace(bytes.data(), bytes.size());
        OIIO::ImageSpec request;
        request.attribute("oiio:UnassociatedAlpha",
                          1);  // colours stay as stored: glTF's alpha is not premultiplied
        input_->threads(1);    // callers decode many pictures in parallel
        if (!input_->set_ioproxy(&*memory_) || !input_->open(name, spec_, request))
            throw Error{name, "", reason(input_.get(), name), ""};
        check_size(spec_, name, limits);
    }

    [[nodiscard]] const std::string& format() const { return format_; }
    [[nodiscard]] const OIIO::ImageSpec& spec() const { return spec_; }
    [[nodiscard]] OIIO::ImageInput& input() { return *input_; }

private:
    std::string format_;
    std::vector<std::byte> essential_;
    std::optional<MemoryFile> memory_;
    OIIO::ImageSpec spec_;
    std::unique_ptr<OIIO::ImageInput> input_;  ///< goes before the memory that it reads
};

Image read_texels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const std::string& name) {
    const int channels = std::min(spec.nchannels, k_channels);
    Image image;
    image.width = static_cast<std::uint32_t>(spec.width);
    image.height = static_cast<std::uint32_t>(spec.height);
    image.format = format_of(spec);
    const bool is_float = image.format == PixelFormat::rgba32f;
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
    image.texels.resize(count * bytes_per_texel(image.format));
    const OIIO::TypeDesc type = is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    if (!input.read_image(0, 0, 0, channels, type, image.texels.data()))
        throw Error{name, "", reason(&input, name), ""};
    if (is_float)
        spread_channels<float>(image.texels, count, channels, 1.0f);
    else
        spread_channels<unsigned char>(image.texels, count, channels, 255);
    return image;
}

Image texels_of(OpenPicture& picture, const std::string& name) {
    Image image = read_texels(picture.input(), picture.spec(), name);
    picture.input().close();
    image.name = name;
    return image;
}

}  // namespace

Image read_image(const std::filesystem::path& file, const PictureLimits& limits) {
    const std::vector<unsigned char> bytes = gltf::read_file(file, k_largest_file);
    Image image = decode_image(std::as_bytes(std::span{bytes}), file.string(), limits);
    image.name = file.filename().string();
    return image;
}

Image decode_image(std::span<const std::byte> bytes, const std::string& name, const PictureLimits& limits) {
    OpenPicture picture{bytes, name, limits};
    return texels_of(picture, name);
}

std::string picture_format(std::span<const std::byte> bytes, const std::string& name) {
    return format_of(bytes, name).value_or("unknown");
}

ImageWithFacts read_image_with_facts(const std::filesystem::path& file, const PictureLimits& limits) {
    const std::vector<unsigned char> bytes = gltf::read_file(file, k_largest_file);
    OpenPicture picture{std::as_bytes(std::span{bytes}), file.string(), limits};
    const OIIO::ImageSpec& spec = picture.spec();
    PictureFacts facts{.format = picture.format(),
                       .width = static_cast<std::uint32_t>(spec.width),
                       .height = static_cast<std::uint32_t>(spec.height),
                       .channels = spec.channelnames,
                       .sample = spec.format.c_str(),
                       .file_bytes = bytes.size()};
    Image image = texels_of(picture, file.string());
    image.name = file.filename().string();
    return {std::move(image), std::move(facts)};
}

Image placeholder_image(const std::string& name) {
    constexpr std::uint32_t k_size = 64;
    constexpr std::uint32_t k_square = 8;
    Image image{.name = name, .width = k_size, .height = k_size, .format = PixelFormat::rgba8, .texels = {}};
    image.texels.reserve(std::size_t{k_size} * k_size * k_channels);
    for (std::uint32_t y = 0; y < k_size; ++y)
        for (std::uint32_t x = 0; x < k_size; ++x) {
            const std::byte shade{(x / k_square + y / k_square) % 2 == 0 ? std::uint8_t{255}
                                                                         : std::uint8_t{0}};
            image.texels.insert(image.texels.end(), {shade, std::byte{0}, shade, std::byte{255}});
        }
    return image;
}

}  // namespace rambla::assets
