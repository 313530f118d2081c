#pragma once

#include <gtest/gtest.h>

#include "assets/mesh.h"

namespace rambla::assets::test {

inline void expect_equal(const Bounds& a, const Bounds& b) {
    EXPECT_EQ(a.min, b.min);
    EXPECT_EQ(a.max, b.max);
}

inline void expect_equal(const MorphTarget& a, const MorphTarget& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.tangents, b.tangents);
}

/// Expects equality to the bit of all but names, joints and weights.
inline void expect_equal_geometry(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.topology, b.topology);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.tangents, b.tangents);
    EXPECT_EQ(a.uv0, b.uv0);
    EXPECT_EQ(a.uv1, b.uv1);
    EXPECT_EQ(a.colours, b.colours);
    EXPECT_EQ(a.indices, b.indices);
    expect_equal(a.bounds, b.bounds);
    ASSERT_EQ(a.morphs.size(), b.morphs.size());
    for (std::size_t i = 0; i < a.morphs.size(); ++i)
        expect_equal(a.morphs[i], b.morphs[i]);
}

}  // namespace rambla::assets::test
