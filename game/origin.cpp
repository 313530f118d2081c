#include "game/origin.h"

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "systems/position.h"

namespace rambla::game {
namespace {

/// Cells are 32-bit integers; this leaves room for a whole world around every place.
constexpr double k_farthest_m = 1.0e11;

}  // namespace

systems::WorldPosition parse_origin(const std::string& text) {
    glm::dvec3 metres{0.0};
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (int axis = 0; axis < 3; ++axis) {
        const auto [next, error] = std::from_chars(at, end, metres[axis]);
        const bool ends_well = axis == 2 ? next == end : next != end && *next == ',';
        if (error != std::errc{} || !ends_well || !(std::abs(metres[axis]) <= k_farthest_m)) {
            throw std::invalid_argument{
                fmt::format("origin is '{}', expected X,Y,Z in metres, each from {:g} to {:g}", text,
                            -k_farthest_m, k_farthest_m)};
        }
        at = next + 1;
    }
    return systems::moved({}, metres);
}

}  // namespace rambla::game
