#include "game/size.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <stdexcept>

namespace rambla::game {
namespace {

constexpr unsigned k_smallest_px = 16;
constexpr unsigned k_largest_px = 16384;  // the largest texture that the GL's we know can draw into

bool in_range(unsigned px) {
    return px >= k_smallest_px && px <= k_largest_px;
}

}  // namespace

glm::uvec2 parse_size(const std::string& text) {
    glm::uvec2 size{0};
    const char* const end = text.data() + text.size();
    const auto [cross, width_error] = std::from_chars(text.data(), end, size.x);
    if (width_error == std::errc{} && cross != end && *cross == 'x') {
        const auto [last, height_error] = std::from_chars(cross + 1, end, size.y);
        if (height_error == std::errc{} && last == end && in_range(size.x) && in_range(size.y)) return size;
    }
    throw std::invalid_argument{fmt::format("size is '{}', expected WIDTHxHEIGHT, each from {} to {} pixels",
                                            text, k_smallest_px, k_largest_px)};
}

}  // namespace rambla::game
