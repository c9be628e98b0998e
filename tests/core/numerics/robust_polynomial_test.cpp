#include "core/numerics/chebyshev.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

struct Points {
  std::vector<double> x, y, sd;
  std::vector<char> valid;
};

double curve(double x) { return 40.0 + 0.3 * x - 4e-4 * x * x + 2e-7 * x * x * x; }

Points sampled(double noise_sd, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise;
  Points points;
  for (double x = 3.5; x < 960.0; x += 8.0) {
    points.x.push_back(x);
    points.y.push_back(curve(x) + noise_sd * noise(engine));
    points.sd.push_back(noise_sd > 0.0 ? noise_sd : 1.0);
    points.valid.push_back(1);
  }
  return points;
}

TEST(RobustPolynomial, IsExactWithoutNoise) {
  const Points p = sampled(0.0, 1);
  const auto fit = fit_robust_polynomial(p.x, p.y, p.sd, p.valid, 7);
  ASSERT_TRUE(fit);
  for (const double x : p.x) EXPECT_NEAR(fit->value(x), curve(x), 1e-10);
}

TEST(RobustPolynomial, GrossErrorsDoNotMoveIt) {
  Points p = sampled(0.1, 2);
  for (std::size_t i = 5; i < p.y.size(); i += 7) p.y[i] += i % 2 == 0 ? 15.0 : 9.0;  // one-sided
  const auto fit = fit_robust_polynomial(p.x, p.y, p.sd, p.valid, 5);
  ASSERT_TRUE(fit);
  for (const double x : p.x) EXPECT_NEAR(fit->value(x), curve(x), 0.15);
  EXPECT_LT(fit->inliers, static_cast<int>(p.x.size()) - 10);
}

TEST(RobustPolynomial, PredictsItsOwnSpread) {
  constexpr int kRuns = 400;
  const double where = 700.0;
  double sum = 0;
  for (unsigned run = 0; run < kRuns; ++run) {
    const Points p = sampled(0.2, 100 + run);
    const auto fit = fit_robust_polynomial(p.x, p.y, p.sd, p.valid, 5);
    ASSERT_TRUE(fit);
    const double e = (fit->value(where) - curve(where)) / fit->sd(where);
    sum += e * e;
  }
  // normalised error squared; 0.15 is twice its own standard deviation over 400 runs
  EXPECT_NEAR(sum / kRuns, 1.0, 0.15);
}

TEST(RobustPolynomial, TooFewPointsAreNoFit) {
  Points p = sampled(0.1, 3);
  std::fill(p.valid.begin() + 15, p.valid.end(), 0);
  EXPECT_FALSE(fit_robust_polynomial(p.x, p.y, p.sd, p.valid, 7));
  EXPECT_TRUE(fit_robust_polynomial(p.x, p.y, p.sd, p.valid, 4));
  EXPECT_FALSE(fit_robust_polynomial({}, {}, {}, {}, 1));
}

}  // namespace
}  // namespace alltact
