#include "assets/import/exr.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "assets/error.h"

namespace rambla::assets {

namespace {

constexpr std::uint32_t k_deep = 0x800;
constexpr std::uint32_t k_multi_part = 0x1000;
/// Types whose values are read without a look at the size that stands before them: were that another one,
/// the rest of the head would be read from other places than here.
struct FixedType {
    std::string_view name;
    std::uint32_t bytes;
};
constexpr auto k_fixed_types = std::to_array<FixedType>({{"box2i", 16},
                                                         {"box2f", 16},
                                                         {"chromaticities", 32},
                                                         {"compression", 1},
                                                         {"deepImageState", 1},
                                                         {"double", 8},
                                                         {"envmap", 1},
                                                         {"float", 4},
                                                         {"int", 4},
                                                         {"keycode", 28},
                                                         {"lineOrder", 1},
                                                         {"m33f", 36},
                                                         {"m33d", 72},
                                                         {"m44f", 64},
                                                         {"m44d", 128},
                                                         {"rational", 8},
                                                         {"tiledesc", 9},
                                                         {"timecode", 8},
                                                         {"v2i", 8},
                                                         {"v2f", 8},
                                                         {"v2d", 16},
                                                         {"v3i", 12},
                                                         {"v3f", 12},
                                                         {"v3d", 24}});

constexpr std::size_t k_most_channels = 64;
constexpr std::size_t k_most_parts = 64;

/// "OpenEXR File Layout", sections "Version Field" to "Attribute Layout": little-endian throughout.
class ExrHeads {
public:
    ExrHeads(std::span<const std::byte> bytes, const std::string& name, std::uint32_t max_size_px)
        : bytes_{bytes}, name_{name}, max_size_px_{max_size_px} {}

    void check() {
        at_ = 4;
        const std::uint32_t version = word();
        if ((version & k_deep) != 0) fail("deep pixels", "flat ones");
        const bool is_multi_part = (version & k_multi_part) != 0;
        for (std::size_t part = 0; part == 0 || (is_multi_part && peek() != 0); ++part) {
            if (part == k_most_parts) fail("more than 64 parts", "fewer");
            check_head();
        }
    }

private:
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw Error{name_, "", "an EXR head with " + found, expected};
    }

    std::size_t left() const { return bytes_.size() - at_; }

    std::uint8_t peek() const {
        if (left() == 0) fail("no end", "a whole file");
        return std::to_integer<std::uint8_t>(bytes_[at_]);
    }

    std::uint32_t word() {
        if (left() < 4) fail("no end", "a whole file");
        std::uint32_t out = 0;
        std::memcpy(&out, bytes_.data() + at_, sizeof out);
        at_ += sizeof out;
        return out;
    }

    std::string_view text() {
        constexpr std::size_t k_longest = 255;
        const char* const first = reinterpret_cast<const char*>(bytes_.data()) + at_;
        const std::size_t length = strnlen(first, std::min(left(), k_longest + 1));
        if (length == left() || length > k_longest) fail("a name without end", "at most 255 letters");
        at_ += length + 1;
        return {first, length};
    }

    void check_head() {
        for (; peek() != 0;) {
            const std::string_view attribute = text();
            const std::string_view type = text();
            const std::uint32_t size = word();
            if (size > left())
                fail("an attribute of " + std::to_string(size) + " bytes",
                     "at most the " + std::to_string(left()) + " that follow");
            const std::size_t end = at_ + size;
            check_value(attribute, type, size);
            at_ = end;
        }
        ++at_;
    }

    void check_value(std::string_view attribute, std::string_view type, std::uint32_t size) {
        const std::size_t end = at_ + size;
        for (const FixedType& fixed : k_fixed_types)
            if (fixed.name == type && fixed.bytes != size) fail_size(type, size, fixed.bytes);
        if (type == "box2i") check_box(attribute);
        if (type == "tiledesc") check_tiles();
        if (type == "chlist") check_channels(end);
        if (type == "stringvector") check_strings(end);
        if (type == "floatvector" && size % 4 != 0) fail_size(type, size, size / 4 * 4);
        if (type == "preview") check_preview(size);
        // A manifest names the size that it is to be unpacked to.
        if (type == "idmanifest") fail("an ID manifest", "none");
    }

    [[noreturn]] void fail_size(std::string_view type, std::uint64_t found, std::uint64_t expected) const {
        fail("a " + std::string{type} + " of " + std::to_string(found) + " bytes", std::to_string(expected));
    }

    void check_side(std::int64_t pixels, const char* what) const {
        if (pixels < 1 || pixels > static_cast<std::int64_t>(max_size_px_))
            fail(std::string{what} + " of " + std::to_string(pixels) + " pixels",
                 "1 to " + std::to_string(max_size_px_));
    }

    void check_box(std::string_view attribute) {
        if (attribute != "dataWindow" && attribute != "displayWindow") return;
        std::int32_t corners[4];
        for (std::int32_t& corner : corners)
            corner = static_cast<std::int32_t>(word());
        check_side(std::int64_t{corners[2]} - corners[0] + 1, "a window");
        check_side(std::int64_t{corners[3]} - corners[1] + 1, "a window");
    }

    void check_tiles() {
        check_side(word(), "tiles");
        check_side(word(), "tiles");
    }

    void check_channels(std::size_t end) {
        constexpr std::size_t k_bytes_after_name = 16;
        const std::size_t first = at_;
        for (std::size_t channels = 0; at_ < end && peek() != 0; ++channels) {
            if (channels == k_most_channels) fail("more than 64 channels", "fewer");
            text();
            if (left() < k_bytes_after_name) fail("no end", "a whole file");
            at_ += k_bytes_after_name;
        }
        if (at_ + 1 != end) fail_size("chlist", end - first, at_ + 1 - first);
    }

    void check_strings(std::size_t end) {
        while (at_ < end) {
            const std::uint32_t length = word();
            if (at_ > end || length > end - at_)
                fail("a string of " + std::to_string(length) + " bytes", "one inside of its attribute");
            at_ += length;
        }
    }

    void check_preview(std::uint32_t size) {
        const std::uint64_t width = size < 8 ? 0 : word();
        const std::uint64_t height = size < 8 ? 0 : word();
        if (size < 8 || width > max_size_px_ || height > max_size_px_ || 8 + 4 * width * height != size)
            fail_size("preview", size, 8 + 4 * width * height);
    }

    std::span<const std::byte> bytes_;
    const std::string& name_;
    std::uint32_t max_size_px_;
    std::size_t at_ = 0;
};

}  // namespace

void check_exr(std::span<const std::byte> bytes, const std::string& name, std::uint32_t max_size_px) {
    ExrHeads{bytes, name, max_size_px}.check();
}

}  // namespace rambla::assets
