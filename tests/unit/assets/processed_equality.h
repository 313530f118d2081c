#pragma once

#include <gtest/gtest.h>

#include "assets/processed.h"
#include "mesh_equality.h"

namespace rambla::assets::test {

// Each expects equality to the bit of all that the type has.

inline void expect_equal(IndexRange a, IndexRange b) {
    EXPECT_EQ(a.first, b.first);
    EXPECT_EQ(a.count, b.count);
}

inline void expect_equal(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.name, b.name);
    expect_equal_geometry(a, b);
    EXPECT_EQ(a.joints, b.joints);
    EXPECT_EQ(a.weights, b.weights);
}

inline void expect_equal(const LodChain& a, const LodChain& b) {
    EXPECT_EQ(a.indices, b.indices);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t i = 0; i < a.levels.size(); ++i) {
        expect_equal(a.levels[i].range, b.levels[i].range);
        EXPECT_EQ(a.levels[i].error_m, b.levels[i].error_m);
        EXPECT_EQ(a.levels[i].normal_error_deg, b.levels[i].normal_error_deg);
        EXPECT_EQ(a.levels[i].uv_error, b.levels[i].uv_error);
        EXPECT_EQ(a.levels[i].sloppy, b.levels[i].sloppy);
    }
}

inline void expect_equal(const ShadowMesh& a, const ShadowMesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.joints, b.joints);
    EXPECT_EQ(a.weights, b.weights);
    EXPECT_EQ(a.morph_positions, b.morph_positions);
    EXPECT_EQ(a.indices, b.indices);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t i = 0; i < a.levels.size(); ++i)
        expect_equal(a.levels[i], b.levels[i]);
}

inline void expect_equal(const ProcessedMesh& a, const ProcessedMesh& b) {
    SCOPED_TRACE(a.mesh.name);
    expect_equal(a.mesh, b.mesh);
    expect_equal(a.lods, b.lods);
    expect_equal(a.shadow, b.shadow);
    EXPECT_EQ(a.sphere.centre, b.sphere.centre);
    EXPECT_EQ(a.sphere.radius, b.sphere.radius);
    ASSERT_EQ(a.occluder.boxes.size(), b.occluder.boxes.size());
    for (std::size_t i = 0; i < a.occluder.boxes.size(); ++i)
        expect_equal(a.occluder.boxes[i], b.occluder.boxes[i]);
    EXPECT_EQ(a.occluder.volume_share, b.occluder.volume_share);
    EXPECT_EQ(a.occluder.gap_m, b.occluder.gap_m);
}

inline void expect_equal(const TextureData& a, const TextureData& b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.colour_space, b.colour_space);
    EXPECT_EQ(a.swizzle, b.swizzle);
    EXPECT_EQ(a.normal_map, b.normal_map);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t i = 0; i < a.levels.size(); ++i) {
        EXPECT_EQ(a.levels[i].width, b.levels[i].width);
        EXPECT_EQ(a.levels[i].height, b.levels[i].height);
        EXPECT_EQ(a.levels[i].offset, b.levels[i].offset);
        EXPECT_EQ(a.levels[i].size, b.levels[i].size);
        EXPECT_EQ(a.levels[i].rms_error, b.levels[i].rms_error);
    }
    EXPECT_EQ(a.bytes, b.bytes);
}

/// Of materials what processing may change.
inline void expect_equal(const ProcessedScene& a, const ProcessedScene& b) {
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i)
        expect_equal(a.meshes[i], b.meshes[i]);
    ASSERT_EQ(a.images.size(), b.images.size());
    for (std::size_t i = 0; i < a.images.size(); ++i)
        expect_equal(a.images[i], b.images[i]);
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t i = 0; i < a.textures.size(); ++i) {
        EXPECT_EQ(a.textures[i].image, b.textures[i].image);
        EXPECT_EQ(a.textures[i].sampler, b.textures[i].sampler);
    }
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
        EXPECT_EQ(a.materials[i].roughness, b.materials[i].roughness);
        EXPECT_EQ(a.materials[i].metalness_roughness_texture.texture,
                  b.materials[i].metalness_roughness_texture.texture);
    }
}

}  // namespace rambla::assets::test
