#include "assets/import/jpeg.h"

#include <algorithm>

#include "assets/error.h"

namespace rambla::assets {

namespace {

constexpr int k_most_scans = 100;

// Second bytes of markers, ITU-T T.81, table B.1.
constexpr std::uint32_t k_start_of_scan = 0xda;
constexpr std::uint32_t k_end_of_image = 0xd9;
constexpr std::uint32_t k_first_frame = 0xc0;
constexpr std::uint32_t k_last_frame = 0xcf;

/// DHT, JPG and DAC lie among the frames.
bool is_frame(std::uint32_t marker) {
    return marker >= k_first_frame && marker <= k_last_frame && marker != 0xc4 && marker != 0xc8 &&
           marker != 0xcc;
}

/// Not the stuffing of a scan's data, TEM, RST0 to RST7 and SOI.
bool has_length(std::uint32_t marker) {
    return marker > 0x01 && !(marker >= 0xd0 && marker <= 0xd8);
}

/// APP0 (JFIF) and APP14 (Adobe) say which colours the components are.
bool is_remark(std::uint32_t marker) {
    constexpr std::uint32_t k_comment = 0xfe;
    return marker == k_comment || (marker > 0xe0 && marker <= 0xef && marker != 0xee);
}

}  // namespace

std::vector<std::byte> essential_jpeg(std::span<const std::byte> bytes, const std::string& name,
                                      std::uint32_t max_size_px) {
    std::vector<std::byte> kept;
    kept.reserve(bytes.size());
    std::size_t kept_to = 0;
    const auto keep_to = [&](std::size_t end) {
        const auto part = bytes.subspan(kept_to, end - kept_to);
        kept.insert(kept.end(), part.begin(), part.end());
    };
    const auto byte = [&](std::size_t at) {
        return at < bytes.size() ? std::to_integer<std::uint32_t>(bytes[at]) : 0u;
    };
    const auto pair = [&](std::size_t at) {
        return byte(at) << 8 | byte(at + 1);
    };
    int scans = 0;
    for (std::size_t at = 2; at < bytes.size();) {
        // Between segments and in the data of scans, whatever is no marker is skipped.
        if (byte(at++) != 0xff) continue;
        const std::uint32_t marker = byte(at);
        if (marker == 0xff || !has_length(marker)) continue;
        if (marker == k_end_of_image) break;
        if (marker == k_start_of_scan && ++scans > k_most_scans)
            throw Error{name, "", "a JPEG of more than " + std::to_string(k_most_scans) + " scans", "fewer"};
        if (is_frame(marker)) {
            const std::uint32_t height = pair(at + 4);
            const std::uint32_t width = pair(at + 6);
            if (width > max_size_px || height > max_size_px)
                throw Error{name, "", std::to_string(width) + " x " + std::to_string(height) + " pixels",
                            "1 to " + std::to_string(max_size_px) + " each way"};
        }
        const std::size_t length = pair(at + 1);
        if (is_remark(marker)) {
            keep_to(at - 1);
            // The two bytes of the length itself are always read.
            kept_to = std::min(at + 1 + std::max<std::size_t>(length, 2), bytes.size());
            at = kept_to;
            continue;
        }
        at += 1 + length;
    }
    keep_to(bytes.size());
    return kept;
}

}  // namespace rambla::assets
