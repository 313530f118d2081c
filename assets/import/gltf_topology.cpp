#include "assets/import/gltf_topology.h"

namespace rambla::assets::gltf {

namespace {

using Indices = std::vector<std::uint32_t>;

Indices unrolled_lines(const Indices& strip, bool closed) {
    Indices list;
    if (strip.size() < 2) return list;
    list.reserve(2 * strip.size());
    for (std::size_t i = 0; i + 1 < strip.size(); ++i)
        list.insert(list.end(), {strip[i], strip[i + 1]});
    if (closed) list.insert(list.end(), {strip.back(), strip.front()});
    return list;
}

Indices unrolled_strip(const Indices& strip) {
    Indices list;
    list.reserve(3 * strip.size());
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
        const std::uint32_t a = strip[i];
        const std::uint32_t b = strip[i + 1 + i % 2];
        const std::uint32_t c = strip[i + 2 - i % 2];
        if (a != b && b != c && c != a) list.insert(list.end(), {a, b, c});
    }
    return list;
}

Indices unrolled_fan(const Indices& fan) {
    Indices list;
    list.reserve(3 * fan.size());
    for (std::size_t i = 0; i + 2 < fan.size(); ++i)
        list.insert(list.end(), {fan[i + 1], fan[i + 2], fan[0]});
    return list;
}

}  // namespace

PrimitiveMode primitive_mode(const Document& document, int mode, std::string_view element) {
    if (mode < 0 || mode > static_cast<int>(PrimitiveMode::triangle_fan))
        document.fail(element, std::to_string(mode), "0 to 6");
    return static_cast<PrimitiveMode>(mode);
}

Topology topology_of(PrimitiveMode mode) {
    switch (mode) {
        case PrimitiveMode::points:
            return Topology::points;
        case PrimitiveMode::lines:
        case PrimitiveMode::line_loop:
        case PrimitiveMode::line_strip:
            return Topology::lines;
        default:
            return Topology::triangles;
    }
}

std::vector<std::uint32_t> to_list(PrimitiveMode mode, std::vector<std::uint32_t> indices) {
    switch (mode) {
        case PrimitiveMode::points:
            return indices;
        case PrimitiveMode::line_loop:
            return unrolled_lines(indices, true);
        case PrimitiveMode::line_strip:
            return unrolled_lines(indices, false);
        case PrimitiveMode::triangle_strip:
            return unrolled_strip(indices);
        case PrimitiveMode::triangle_fan:
            return unrolled_fan(indices);
        case PrimitiveMode::lines:
            indices.resize(indices.size() / 2 * 2);
            return indices;
        case PrimitiveMode::triangles:
            break;
    }
    indices.resize(indices.size() / 3 * 3);
    return indices;
}

bool is_ragged(PrimitiveMode mode, std::size_t count) {
    switch (mode) {
        case PrimitiveMode::points:
            return count == 0;
        case PrimitiveMode::lines:
            return count % 2 != 0;
        case PrimitiveMode::triangles:
            return count % 3 != 0;
        case PrimitiveMode::line_loop:
        case PrimitiveMode::line_strip:
            return count < 2;
        default:
            return count < 3;
    }
}

}  // namespace rambla::assets::gltf
