#include "calibration/twin/twin_solver.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kClusters = 30, kEach = 20;

/// A line through data whose errors are alike within clusters.
struct Line {
  Eigen::VectorXd t = Eigen::VectorXd(kClusters * kEach), y = t;
  std::vector<int> clusters;
  explicit Line(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int c = 0; c < kClusters; ++c) {
      const double common = normal(random);
      for (int i = 0; i < kEach; ++i) {
        const int k = c * kEach + i;
        t[k] = static_cast<double>(k) / (kClusters * kEach);
        y[k] = 2 + 3 * t[k] + common + 0.1 * normal(random);
        clusters.push_back(c);
      }
    }
  }
  [[nodiscard]] TwinSolution solve(double high = 50) const {
    const TwinModel model = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r,
                                Eigen::MatrixXd* slopes) {
      r = (x[0] + x[1] * t.array()).matrix() - y;
      if (slopes) {
        slopes->resize(t.size(), 2);
        slopes->col(0).setOnes();
        slopes->col(1) = t;
      }
      return true;
    };
    return solve_twin(model,
                      {Eigen::Vector2d(0, 0), Eigen::Vector2d(-50, -50), Eigen::Vector2d(50, high)},
                      t.size(), {}, Job())
        .value();
  }
};

TEST(TwinSolver, StandardDeviationsHoldWhereErrorsAreAlike) {
  double squares = 0;
  constexpr int kRuns = 300;
  for (unsigned seed = 1; seed <= kRuns; ++seed) {
    const Line line(seed);
    const TwinSolution solution = line.solve();
    const auto sd = clustered_sd(solution, line.clusters);
    ASSERT_TRUE(sd[0] && sd[1]);
    squares += std::pow((solution.x[1] - 3) / *sd[1], 2) / kRuns;
  }
  // Independent errors would promise twenty times less variance.
  EXPECT_GT(squares, 0.8);
  EXPECT_LT(squares, 1.4);
}

TEST(TwinSolver, WhatLiesAtABoundHasNoStandardDeviation) {
  const Line line(7);
  const TwinSolution solution = line.solve(1.0);
  EXPECT_EQ(solution.x[1], 1.0);
  const auto sd = clustered_sd(solution, line.clusters);
  EXPECT_TRUE(sd[0].has_value());
  EXPECT_FALSE(sd[1].has_value());
}

TEST(TwinSolver, WhatAnotherNumberDoesAsWellIsNotTold) {
  const Line line(8);
  TwinSolution solution = line.solve();
  Eigen::MatrixXd slopes(line.t.size(), 3);
  slopes << solution.jacobian, 2 * solution.jacobian.col(1);
  solution.jacobian = slopes;
  solution.x.conservativeResize(3);
  solution.at_bound.push_back(0);
  const auto sd = clustered_sd(solution, line.clusters);
  EXPECT_TRUE(sd[0].has_value());
  EXPECT_FALSE(sd[1].has_value());
  EXPECT_FALSE(sd[2].has_value());
}

}  // namespace
}  // namespace alltact
