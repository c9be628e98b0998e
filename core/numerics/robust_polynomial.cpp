#include "core/numerics/robust_polynomial.h"

#include "core/numerics/chebyshev.h"
#include "core/numerics/least_squares.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace alltact {
namespace {

constexpr double kTukey = 4.685;
constexpr double kMadToSd = 1.4826;
constexpr int kCauchyRounds = 5;
constexpr int kTukeyRounds = 4;
constexpr double kSettled = 1e-4;  // change of a weight that no longer matters

double spread(const Eigen::VectorXd& residuals) {
  std::vector<double> sizes(static_cast<std::size_t>(residuals.size()));
  for (Eigen::Index i = 0; i < residuals.size(); ++i)
    sizes[static_cast<std::size_t>(i)] = std::abs(residuals[i]);
  return std::max(kMadToSd * upper_median(sizes), 1e-9);
}

double cauchy_weight(double r) {
  return 1.0 / (1.0 + r * r);
}

double tukey_weight(double r) {
  const double z = r / kTukey;
  return std::abs(z) < 1.0 ? (1.0 - z * z) * (1.0 - z * z) : 0.0;
}

}  // namespace

double RobustPolynomial::value(double x) const {
  return chebyshev_value(coefficients, (x - middle) / half);
}

std::vector<double> RobustPolynomial::values(int n) const {
  std::vector<double> result(static_cast<std::size_t>(n));
  chebyshev_values(coefficients, -middle / half, 1.0 / half, n, result.data());
  return result;
}

double RobustPolynomial::sd(double x) const {
  const Eigen::RowVectorXd row = chebyshev_row((x - middle) / half, coefficients.size());
  return std::sqrt(std::max(0.0, (row * covariance * row.transpose()).value()));
}

std::optional<RobustPolynomial> fit_robust_polynomial(const std::vector<double>& x,
                                                      const std::vector<double>& y,
                                                      const std::vector<double>& sd,
                                                      const std::vector<char>& valid,
                                                      int degree) {
  const Eigen::Index n = degree + 1;
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (valid[i]) points.push_back(i);
  const auto count = static_cast<Eigen::Index>(points.size());
  if (count < 2 * n) return std::nullopt;

  RobustPolynomial fit;
  fit.middle = 0.5 * (x[points.front()] + x[points.back()]);
  fit.half = std::max(0.5 * (x[points.back()] - x[points.front()]), 1e-9);
  Eigen::MatrixXd design(count, n);  // rows divided by their sd
  Eigen::VectorXd target(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t k = points[static_cast<std::size_t>(i)];
    design.row(i) = chebyshev_row((x[k] - fit.middle) / fit.half, n) / sd[k];
    target[i] = y[k] / sd[k];
  }

  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
  Eigen::VectorXd residuals;
  for (int round = 0; round < kCauchyRounds + kTukeyRounds; ++round) {
    const Eigen::VectorXd root = weights.cwiseSqrt();
    fit.coefficients = least_squares(root.asDiagonal() * design, root.cwiseProduct(target));
    residuals = target - design * fit.coefficients;
    fit.scale = spread(residuals);
    const Eigen::VectorXd before = weights;
    const bool cauchy = round < kCauchyRounds;
    for (Eigen::Index i = 0; i < count; ++i)
      weights[i] =
          cauchy ? cauchy_weight(residuals[i] / fit.scale) : tukey_weight(residuals[i] / fit.scale);
    if ((weights - before).cwiseAbs().maxCoeff() > kSettled) continue;
    if (!cauchy) break;
    round = kCauchyRounds - 1;  // on to Tukey's
  }

  fit.first = x[points.back()], fit.last = x[points.front()];
  for (Eigen::Index i = 0; i < count; ++i) {
    if (weights[i] <= 0.0) continue;
    ++fit.believed;
    fit.first = std::min(fit.first, x[points[static_cast<std::size_t>(i)]]);
    fit.last = std::max(fit.last, x[points[static_cast<std::size_t>(i)]]);
  }
  if (fit.believed < 2 * n || !fit.coefficients.allFinite()) return std::nullopt;
  const Eigen::MatrixXd information = design.transpose() * weights.asDiagonal() * design;
  const Eigen::LLT<Eigen::MatrixXd> factor(information);
  if (factor.info() != Eigen::Success) return std::nullopt;
  // What the points' own sd did not foresee shows in the residuals; never promise less.
  const double inflation = std::max(1.0, fit.scale * fit.scale);
  fit.covariance = inflation * factor.solve(Eigen::MatrixXd::Identity(n, n));
  return fit;
}

}  // namespace alltact
