#include "calibration/joint/ceres_solver.h"

#include <array>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// r = r0 + A p + B q, with columns that differ in size by a million: the scale of an ill-posed
/// problem.
class Linear final : public ceres::CostFunction {
 public:
  Linear(int rows, unsigned seed) : a_(rows, 3), b_(rows, 2), r0_(rows) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (double* value = a_.data(); value < a_.data() + a_.size(); ++value) *value = normal(random);
    for (double* value = b_.data(); value < b_.data() + b_.size(); ++value)
      *value = 1e6 * normal(random);
    for (double& value : r0_) value = normal(random);
    set_num_residuals(rows);
    *mutable_parameter_block_sizes() = {3, 2};
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) =
        r0_ + a_ * Eigen::Map<const Eigen::Vector3d>(parameters[0]) +
        b_ * Eigen::Map<const Eigen::Vector2d>(parameters[1]);
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) Eigen::Map<RowMajor>(jacobians[0], num_residuals(), 3) = a_;
    if (jacobians[1] != nullptr) Eigen::Map<RowMajor>(jacobians[1], num_residuals(), 2) = b_;
    return true;
  }

 private:
  RowMajor a_, b_;
  Eigen::VectorXd r0_;
};

struct Evaluated {
  Eigen::VectorXd residuals;
  RowMajor by_p, by_q;

  Evaluated(const ceres::CostFunction& cost, bool with_q) {
    const std::array<double, 3> p{0.3, -1.2, 2.5};
    const std::array<double, 2> q{0.7e-6, -0.4e-6};
    const int rows = cost.num_residuals();
    residuals.resize(rows);
    by_p.setZero(rows, 3);
    by_q.setZero(rows, 2);
    const std::array<const double*, 2> parameters{p.data(), q.data()};
    std::array<double*, 2> jacobians{by_p.data(), with_q ? by_q.data() : nullptr};
    EXPECT_TRUE(cost.Evaluate(parameters.data(), residuals.data(), jacobians.data()));
    Eigen::VectorXd alone(rows);
    EXPECT_TRUE(cost.Evaluate(parameters.data(), alone.data(), nullptr));
    EXPECT_NEAR(alone.squaredNorm() / residuals.squaredNorm(), 1.0, 1e-14);
  }
};

void expect_same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  EXPECT_LT((a - b).norm(), 1e-13 * b.norm());
}

class Compressed : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rows, Compressed, testing::Values(3, 6, 7, 400));

TEST_P(Compressed, CostGradientAndGaussNewtonMatrixAreThoseOfAllSamples) {
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const bool with_q : {true, false}) {
      const Linear whole(GetParam(), seed);
      const CompressedCost compressed(std::make_unique<Linear>(GetParam(), seed));
      ASSERT_EQ(compressed.num_residuals(), 6);
      const Evaluated many(whole, with_q), few(compressed, with_q);
      EXPECT_NEAR(few.residuals.squaredNorm() / many.residuals.squaredNorm(), 1.0, 1e-14);
      expect_same(few.by_p.transpose() * few.residuals, many.by_p.transpose() * many.residuals);
      expect_same(few.by_p.transpose() * few.by_p, many.by_p.transpose() * many.by_p);
      if (!with_q) continue;
      expect_same(few.by_q.transpose() * few.residuals, many.by_q.transpose() * many.residuals);
      expect_same(few.by_q.transpose() * few.by_q, many.by_q.transpose() * many.by_q);
      expect_same(few.by_p.transpose() * few.by_q, many.by_p.transpose() * many.by_q);
    }
}

}  // namespace
}  // namespace alltact
