#include "core/numerics/vector_loops.h"

#include <cmath>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(VectorMath, IsWithinItsBoundsOfTheFunctionsItStandsFor) {
  double exp_off = 0, log_off = 0, pow_off = 0, cos_off = 0;
  for (int i = 0; i <= 2000000; ++i) {
    const double part = i / 2e6;
    const auto x = static_cast<float>(-87 + 175 * part);
    exp_off = std::max(exp_off, std::abs(vector_exp(x) / std::exp(double{x}) - 1));
    const auto y = static_cast<float>(std::exp(-80 + 160 * part));
    const double log_y = std::log(double{y});
    log_off = std::max(log_off, std::abs(vector_log(y) - log_y) / std::max(1.0, std::abs(log_y)));
    const auto z = static_cast<float>(2 * part), power = static_cast<float>(0.1 + 9 * part);
    if (z > 1e-4F) {
      const double expected = std::pow(double{z}, double{power});
      pow_off = std::max(pow_off, std::abs(vector_pow(z, power) / expected - 1) /
                                      std::max(1.0, std::abs(power * std::log(double{z}))));
    }
    const auto turns = static_cast<float>(-3 + 6 * part);
    cos_off =
        std::max(cos_off, std::abs(vector_cos_turns(turns) - std::cos(2 * M_PI * double{turns})));
  }
  EXPECT_LT(exp_off, 2e-7);
  EXPECT_LT(log_off, 1e-7);
  EXPECT_LT(pow_off, 2e-7);
  EXPECT_LT(cos_off, 1e-6);
}

TEST(VectorMath, HasNoHoles) {
  EXPECT_EQ(vector_exp(0), 1.0F);
  EXPECT_EQ(vector_log(1), 0.0F);
  EXPECT_EQ(vector_pow(0, 2), 0.0F);
  EXPECT_EQ(vector_pow(-3, 2), 0.0F);
  EXPECT_EQ(vector_pow(1, 77), 1.0F);
  EXPECT_TRUE(std::isfinite(vector_exp(-1e9F)));
  EXPECT_TRUE(std::isfinite(vector_exp(1e9F)));
  EXPECT_GE(vector_exp(-1e9F), 0.0F);
}

}  // namespace
}  // namespace alltact
