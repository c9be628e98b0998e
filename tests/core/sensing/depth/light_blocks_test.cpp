#include "core/sensing/depth/light_gain.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// Blocks of a tilted light, a few of which something presses.
LightBlocks random_blocks(std::mt19937& engine, int count) {
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  LightBlocks blocks;
  for (int i = 0; i < count; ++i) {
    const double s = even(engine), t = even(engine);
    const double pressed = even(engine) > 0.6 ? 0.2 : 0.0;
    const double noise = 0.004 + 0.002 * even(engine);
    const double ratio = (1.0 - pressed) * (1.02 + 0.01 * s - 0.02 * t) + noise * even(engine);
    blocks.add({s, t, ratio, noise, std::hypot(noise, 0.002)});
  }
  return blocks;
}

// Written down block by block; numbers that fill vectors and such that do not.
TEST(LightBlocks, EquationsAreThePlainSums) {
  constexpr double kTukey = 4.0;
  std::mt19937 engine(1);
  for (const int count : {0, 1, 7, 8, 9, 64, 515}) {
    const LightBlocks blocks = random_blocks(engine, count);
    ASSERT_EQ(blocks.size(), static_cast<std::size_t>(count));
    for (const double widening : {0.0, 0.05, 2.0}) {
      LightTerms terms;
      terms << -0.015, -0.01, 0.02, 0.003, -0.002, 0.001;
      Eigen::Matrix<double, kLightTerms, kLightTerms> normal;
      normal.setZero();
      LightTerms pull = LightTerms::Zero();
      double inlier_sum = 0;
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        const LightBlock block = blocks[i];
        const LightTerms basis = light_basis(block.s, block.t);
        const double sd = std::hypot(block.sd, widening);
        const double z = (1.0 - block.ratio * (1.0 + basis.dot(terms))) / (kTukey * sd);
        if (std::abs(z) >= 1.0) continue;
        const double share = std::pow(1.0 - z * z, 2);
        const LightTerms row = block.ratio * basis;
        normal += share / (sd * sd) * row * row.transpose();
        pull += share / (sd * sd) * (1.0 - block.ratio) * row;
        inlier_sum += share;
      }
      const LightEquations told = blocks.equations(terms, kTukey, widening);
      EXPECT_LE((told.normal - normal).norm(), 1e-12 * normal.norm()) << count;
      EXPECT_LE((told.pull - pull).norm(), 1e-12 * (1.0 + normal.norm())) << count;
      EXPECT_NEAR(told.inlier_sum, inlier_sum, 1e-12 * (1.0 + inlier_sum)) << count;
    }
  }
}

}  // namespace
}  // namespace alltact
