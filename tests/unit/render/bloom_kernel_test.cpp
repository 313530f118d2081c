// Filters that spread bright light, and how methods are fitted to one point-spread function.
#include "render/post/bloom_kernel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace rambla::render {
namespace {

using testing::Each;
using testing::Ge;

TEST(BloomKernel, SumsToOneAndHasTheVarianceAskedFor) {
    for (const double variance : {0.5, 3.0, 8.5, 9.0, 11.0}) {
        const BlurKernel kernel = gaussian_kernel(variance);
        EXPECT_NEAR(sum(kernel), 1.0, 1e-12) << variance;
        EXPECT_NEAR(variance_of(kernel), variance, 1e-9) << variance;
    }
}

TEST(BloomKernel, OfThirteenTapsIsTheBinomialOfSixteenWithoutItsEnds) {
    const BlurKernel kernel = thirteen_tap_kernel();
    EXPECT_NEAR(sum(kernel), 1.0, 1e-12);
    const double whole = 65536.0 - 2.0 * (1.0 + 16.0);
    EXPECT_NEAR(kernel.middle, 12870.0 / whole, 1e-9);
    EXPECT_NEAR(kernel.pairs[0].weight, (11440.0 + 8008.0) / whole, 1e-9);
    EXPECT_NEAR(kernel.pairs[1].weight, (4368.0 + 1820.0) / whole, 1e-9);
    EXPECT_NEAR(kernel.pairs[2].weight, (560.0 + 120.0) / whole, 1e-9);
    EXPECT_NEAR(kernel.pairs[0].offset_texels, 1.0 + 8008.0 / (11440.0 + 8008.0), 1e-9);
    const double cut_off = 2.0 * (1.0 * 64.0 + 16.0 * 49.0);
    EXPECT_NEAR(variance_of(kernel), (65536.0 * 4.0 - cut_off) / whole, 1e-6);
}

TEST(BloomKernel, SumsToOneInTheFloatsThatShadersRead) {
    for (const BlurKernel& kernel : {gaussian_kernel(8.6), thirteen_tap_kernel()}) {
        double total = static_cast<float>(kernel.middle);
        for (const BlurKernel::Pair& pair : kernel.pairs)
            total += 2.0 * static_cast<float>(pair.weight);
        EXPECT_NEAR(total, 1.0, 1e-6);
    }
}

TEST(BloomKernel, PairsLieBetweenTheirTexelsAndFallOff) {
    const BlurKernel kernel = gaussian_kernel(8.6);
    double last = 1.0;
    for (std::size_t i = 0; i < kernel.pairs.size(); ++i) {
        const double nearer = static_cast<double>(2 * i + 1);
        EXPECT_GT(kernel.pairs[i].offset_texels, nearer);
        EXPECT_LT(kernel.pairs[i].offset_texels, nearer + 0.5) << "the nearer texel weighs more";
        EXPECT_LT(kernel.pairs[i].weight, last);
        last = kernel.pairs[i].weight;
    }
}

TEST(BloomFit, FindsTheFourGaussiansThemselves) {
    std::vector<double> variances{1.0, 1e6};
    for (const double sigma_px : k_bloom_sigmas_px)
        variances.push_back(sigma_px * sigma_px);
    std::vector<double> shares(variances.size());
    fit_bloom(variances, shares);
    EXPECT_NEAR(shares[0], 0.0, 1e-4);
    EXPECT_NEAR(shares[1], 0.0, 1e-4);
    for (std::size_t i = 2; i < shares.size(); ++i)
        EXPECT_NEAR(shares[i], 0.25, 1e-4) << i;
}

TEST(BloomFit, GivesSharesOfOneWhole) {
    for (const std::size_t count : {1u, 2u, 6u, 32u}) {
        std::vector<double> variances(count), shares(count);
        for (std::size_t i = 0; i < count; ++i)
            variances[i] = 64.0 * std::pow(static_cast<double>(i) + 1.0, 2.0);
        fit_bloom(variances, shares);
        EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-9) << count;
        EXPECT_THAT(shares, Each(Ge(0.0))) << count;
    }
}

}  // namespace
}  // namespace rambla::render
