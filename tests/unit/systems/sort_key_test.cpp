#include "systems/pack/sort_key.h"

#include <gtest/gtest.h>

#include "systems/frame.h"

namespace rambla::systems {
namespace {

constexpr auto k_surfaces = DrawPass::surfaces;

TEST(SortKey, FieldsOrderFromTheMostSignificantDown) {
    const SortKey base = opaque_key(k_surfaces, 3, 5, 7, 11, 13.0f);
    EXPECT_LT(base, opaque_key(k_surfaces, 3, 5, 7, 11, 27.0f));
    EXPECT_LT(opaque_key(k_surfaces, 3, 5, 7, 11, 1e30f), opaque_key(k_surfaces, 3, 5, 7, 12, 1e-30f));
    EXPECT_LT(opaque_key(k_surfaces, 3, 5, 7, 65535, 1e30f), opaque_key(k_surfaces, 3, 5, 8, 0, 0.0f));
    EXPECT_LT(opaque_key(k_surfaces, 3, 5, 65535, 65535, 1e30f), opaque_key(k_surfaces, 3, 6, 0, 0, 0.0f));
    EXPECT_LT(opaque_key(k_surfaces, 3, 511, 65535, 65535, 1e30f), blended_key(k_surfaces, 3, 1e30f, 0, 0));
    EXPECT_LT(blended_key(k_surfaces, 3, 0.0f, 511, 65535), opaque_key(k_surfaces, 4, 0, 0, 0, 0.0f));
    EXPECT_LT(blended_key(k_surfaces, 31, 0.0f, 511, 65535),
              opaque_key(DrawPass::shadow_casters, 0, 0, 0, 0, 0.0f));
}

TEST(SortKey, BlendedThingsGoBackToFrontWhateverTheyAreMadeOf) {
    EXPECT_LT(blended_key(k_surfaces, 0, 10.0f, 511, 9), blended_key(k_surfaces, 0, 9.999999f, 0, 0));
    EXPECT_LT(blended_key(k_surfaces, 0, 10.0f, 1, 9), blended_key(k_surfaces, 0, 10.0f, 2, 0));
    EXPECT_LT(blended_key(k_surfaces, 0, 10.0f, 1, 0), blended_key(k_surfaces, 0, 10.0f, 1, 1));
}

TEST(SortKey, EveryPipelineFitsItsField) {
    const Pipeline widest{.double_sided = true,
                          .mirrored = true,
                          .alpha = 3,
                          .topology = 3,
                          .unlit = true,
                          .skinned = true,
                          .morphed = true};
    EXPECT_EQ(pack(widest), 0x1ffu);
    EXPECT_EQ(unpack_pipeline(pack(widest)), widest);
}

TEST(SortKey, HeadFieldsCanBeReadBack) {
    const SortKey blended = blended_key(DrawPass::shadow_casters, 31, 5.0f, 511, 65535);
    EXPECT_EQ(pass_of(blended), DrawPass::shadow_casters);
    EXPECT_EQ(blend_class_of(blended), BlendClass::blended);
    EXPECT_EQ(blend_class_of(opaque_key(k_surfaces, 31, 511, 65535, 65535, 1e38f)), BlendClass::opaque);
}

}  // namespace
}  // namespace rambla::systems
