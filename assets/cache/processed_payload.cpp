#include "assets/cache/processed_payload.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "assets/assert.h"
#include "assets/cache/payload_stream.h"
#include "assets/mesh_columns.h"
#include "assets/process/blocks.h"
#include "assets/process/raster.h"

namespace rambla::assets {

namespace {

/// Beyond what graphics cards take, and far from where a number of bytes would not fit 64 bits.
constexpr std::uint32_t k_largest_side = 1u << 20;

template <class T>
void add_numbers(PayloadWriter& out, std::initializer_list<T> numbers) {
    for (const T number : numbers)
        out.add(number);
}

void add(PayloadWriter& out, glm::vec3 v) {
    add_numbers(out, {v.x, v.y, v.z});
}

glm::vec3 read_vector(PayloadReader& in) {
    const auto x = in.value<float>();
    const auto y = in.value<float>();
    const auto z = in.value<float>();
    return {x, y, z};
}

IndexRange read_range(PayloadReader& in) {
    const auto first = in.value<std::uint32_t>();
    const auto count = in.value<std::uint32_t>();
    return {first, count};
}

// The columns of a mesh, each with its own count, in the order of for_each_column.

void add(PayloadWriter& out, const Mesh& mesh) {
    out.add(mesh.name);
    out.add(mesh.topology);
    out.add_count(mesh.morphs.size());
    for (const MorphTarget& morph : mesh.morphs)
        out.add(morph.name);
    for_each_column(mesh, [&](const auto& column) { out.add(column); });
    out.add(mesh.indices);
    add(out, mesh.bounds.min);
    add(out, mesh.bounds.max);
}

template <class T>
void read_column(PayloadReader& in, std::vector<T>& column) {
    column = in.column<T>();
}

Mesh read_mesh(PayloadReader& in) {
    Mesh mesh;
    mesh.name = in.text();
    mesh.topology = in.one_of(Topology::points);
    // A name and three columns, of which at least the counts are there.
    mesh.morphs.resize(in.count(4 * sizeof(std::uint64_t)));
    for (MorphTarget& morph : mesh.morphs)
        morph.name = in.text();
    for_each_column(mesh, [&](auto& column) { read_column(in, column); });
    mesh.indices = in.column<std::uint32_t>();
    mesh.bounds.min = read_vector(in);
    mesh.bounds.max = read_vector(in);
    return mesh;
}

void add(PayloadWriter& out, const LodChain& lods) {
    out.add_count(lods.levels.size());
    for (const LodLevel& level : lods.levels) {
        add_numbers(out, {level.range.first, level.range.count});
        add_numbers(out, {level.error_m, level.normal_error_deg, level.uv_error});
        out.add(level.sloppy);
    }
    out.add(lods.indices);
}

LodChain read_lods(PayloadReader& in) {
    LodChain lods;
    lods.levels.resize(in.count(5 * sizeof(float) + 1));
    for (LodLevel& level : lods.levels) {
        level.range = read_range(in);
        level.error_m = in.value<float>();
        level.normal_error_deg = in.value<float>();
        level.uv_error = in.value<float>();
        level.sloppy = in.flag();
    }
    lods.indices = in.column<std::uint32_t>();
    return lods;
}

void add(PayloadWriter& out, const ShadowMesh& shadow) {
    out.add(shadow.positions);
    out.add(shadow.joints);
    out.add(shadow.weights);
    out.add_count(shadow.morph_positions.size());
    for (const std::vector<glm::vec3>& column : shadow.morph_positions)
        out.add(column);
    out.add(shadow.levels);
    out.add(shadow.indices);
}

ShadowMesh read_shadow(PayloadReader& in) {
    ShadowMesh shadow;
    shadow.positions = in.column<glm::vec3>();
    shadow.joints = in.column<glm::u16vec4>();
    shadow.weights = in.column<glm::vec4>();
    shadow.morph_positions.resize(in.count(sizeof(std::uint64_t)));
    for (std::vector<glm::vec3>& column : shadow.morph_positions)
        column = in.column<glm::vec3>();
    shadow.levels = in.column<IndexRange>();
    shadow.indices = in.column<std::uint32_t>();
    return shadow;
}

// What must hold of meshes, whoever made them.

bool is_finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool are_finite(std::span<const glm::vec3> points) {
    return std::all_of(points.begin(), points.end(), is_finite);
}

/// Finite, and the right way round.
bool is_box(const Bounds& box) {
    return is_finite(box.min) && is_finite(box.max) && !box.empty();
}

bool is_error(float value) {
    return std::isfinite(value) && value >= 0.0f;
}

bool all_below(std::span<const std::uint32_t> indices, std::size_t limit) {
    return std::all_of(indices.begin(), indices.end(),
                       [limit](std::uint32_t index) { return index < limit; });
}

std::size_t corners(Topology topology) {
    switch (topology) {
        case Topology::triangles:
            return 3;
        case Topology::lines:
            return 2;
        case Topology::points:
            return 1;
    }
    return 1;
}

bool is_triangle_range(IndexRange range, std::size_t index_count) {
    return std::uint64_t{range.first} + range.count <= index_count && range.count % 3 == 0;
}

bool is_sound(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    bool columns_fit = true;
    for_each_column(mesh, [&](const auto& column) {
        columns_fit = columns_fit && (column.empty() || column.size() == vertices);
    });
    // Of nothing there is the empty box.
    const bool bounds_fit = vertices == 0 ? mesh.bounds.min == Bounds{}.min && mesh.bounds.max == Bounds{}.max
                                          : is_box(mesh.bounds);
    return columns_fit && mesh.joints.size() == mesh.weights.size() && bounds_fit &&
           are_finite(mesh.positions) && mesh.indices.size() % corners(mesh.topology) == 0 &&
           all_below(mesh.indices, vertices);
}

bool is_sound(const LodChain& lods, std::size_t vertices) {
    float error_m = 0.0f;
    for (const LodLevel& level : lods.levels) {
        const bool good = is_triangle_range(level.range, lods.indices.size()) && is_error(level.error_m) &&
                          level.error_m >= error_m && is_error(level.normal_error_deg) &&
                          is_error(level.uv_error);
        if (!good) return false;
        error_m = level.error_m;
    }
    return all_below(lods.indices, vertices);
}

/// @param processed  with a mesh and levels of detail that are sound
bool shadow_fits(const ProcessedMesh& processed) {
    const ShadowMesh& shadow = processed.shadow;
    const bool triangles = processed.mesh.topology == Topology::triangles;
    if (shadow.levels.size() != (triangles ? processed.lods.levels.size() + 1 : 0)) return false;
    if (shadow.morph_positions.size() != (triangles ? processed.mesh.morphs.size() : 0)) return false;
    const std::size_t vertices = shadow.positions.size();
    const auto fits = [vertices](const auto& column) {
        return column.empty() || column.size() == vertices;
    };
    const bool skin_fits = fits(shadow.joints) && shadow.joints.size() == shadow.weights.size();
    return skin_fits && std::all_of(shadow.morph_positions.begin(), shadow.morph_positions.end(), fits) &&
           std::all_of(shadow.levels.begin(), shadow.levels.end(),
                       [&](IndexRange range) { return is_triangle_range(range, shadow.indices.size()); }) &&
           are_finite(shadow.positions) && all_below(shadow.indices, vertices);
}

bool is_sound(const ProcessedMesh& processed) {
    const OccluderProxy& occluder = processed.occluder;
    const BoundingSphere& sphere = processed.sphere;
    return is_sound(processed.mesh) && is_sound(processed.lods, processed.mesh.positions.size()) &&
           shadow_fits(processed) && is_finite(sphere.centre) && std::isfinite(sphere.radius) &&
           std::all_of(occluder.boxes.begin(), occluder.boxes.end(), is_box) &&
           is_error(occluder.volume_share) && is_error(occluder.gap_m);
}

/// What follows of a texture's levels from the size of the finest.
void lay_out_levels(TextureData& texture, std::uint32_t width, std::uint32_t height) {
    std::size_t offset = 0;
    for (TextureLevel& level : texture.levels) {
        level.width = width;
        level.height = height;
        level.offset = offset;
        level.size = stored_size(texture.format, width, height);
        offset += level.size;
        width = halved(width);
        height = halved(height);
    }
}

std::size_t end_of(const TextureData& texture) {
    return texture.levels.back().offset + texture.levels.back().size;
}

[[maybe_unused]] bool levels_follow(const TextureData& texture) {
    if (texture.levels.empty() || texture.first_stored > 0) return false;
    TextureData expected;
    expected.format = texture.format;
    expected.levels.resize(texture.levels.size());
    lay_out_levels(expected, texture.levels[0].width, texture.levels[0].height);
    return texture.bytes.size() == end_of(expected) &&
           std::equal(texture.levels.begin(), texture.levels.end(), expected.levels.begin(),
                      [](const TextureLevel& a, const TextureLevel& b) {
                          return a.width == b.width && a.height == b.height && a.offset == b.offset &&
                                 a.size == b.size;
                      });
}

}  // namespace

std::vector<std::byte> to_payload(const ProcessedMesh& processed) {
    PayloadWriter out;
    add(out, processed.mesh);
    add(out, processed.lods);
    add(out, processed.shadow);
    add(out, processed.sphere.centre);
    out.add(processed.sphere.radius);
    out.add(processed.occluder.boxes);
    out.add(processed.occluder.volume_share);
    out.add(processed.occluder.gap_m);
    return out.take();
}

std::optional<ProcessedMesh> mesh_from_payload(std::span<const std::byte> payload) {
    PayloadReader in{payload};
    ProcessedMesh processed;
    processed.mesh = read_mesh(in);
    processed.lods = read_lods(in);
    processed.shadow = read_shadow(in);
    processed.sphere.centre = read_vector(in);
    processed.sphere.radius = in.value<float>();
    processed.occluder.boxes = in.column<Bounds>();
    processed.occluder.volume_share = in.value<float>();
    processed.occluder.gap_m = in.value<float>();
    if (!in.good() || !is_sound(processed)) return std::nullopt;
    return processed;
}

std::vector<std::byte> to_payload(const TextureData& texture) {
    RAMBLA_ASSERT(levels_follow(texture), "processing halves each level and packs them tightly");
    PayloadWriter out;
    out.add(texture.name);
    out.add(texture.format);
    out.add(texture.colour_space);
    for (const ChannelSource source : texture.swizzle)
        out.add(source);
    out.add(texture.normal_map);
    add_numbers(out, {texture.levels[0].width, texture.levels[0].height});
    for (const TextureLevel& level : texture.levels)
        out.add(level.rms_error);
    out.add(texture.bytes);
    return out.take();
}

std::optional<TextureData> texture_from_payload(std::span<const std::byte> payload) {
    PayloadReader in{payload};
    TextureData texture;
    texture.name = in.text();
    texture.format = in.one_of(TexelFormat::bc5);
    texture.colour_space = in.one_of(ColourSpace::srgb);
    for (ChannelSource& source : texture.swizzle)
        source = in.one_of(ChannelSource::one);
    texture.normal_map = in.flag();
    const auto width = in.value<std::uint32_t>();
    const auto height = in.value<std::uint32_t>();
    const auto is_side = [](std::uint32_t texels) {
        return texels > 0 && texels <= k_largest_side;
    };
    if (!in.expect(is_side(width) && is_side(height))) return std::nullopt;
    texture.levels.resize(mip_count(width, height));
    lay_out_levels(texture, width, height);
    for (TextureLevel& level : texture.levels) {
        level.rms_error = in.value<float>();
        in.expect(is_error(level.rms_error));
    }
    texture.bytes = in.column<std::byte>();
    if (!in.good() || texture.bytes.size() != end_of(texture)) return std::nullopt;
    return texture;
}

}  // namespace rambla::assets
