#include "core/numerics/chebyshev.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

namespace alltact {
namespace {

constexpr int kBlock = 64;  // values that stay in the cache through the recurrence

/// Clenshaw's recurrence for a block of positions, one coefficient at a time.
ALLTACT_WIDE void clenshaw_block(const double* c, int count, double first, double step, int offset,
                                 double* values) {
  std::array<double, kBlock> t, next, after;
  for (int i = 0; i < kBlock; ++i) {
    t[static_cast<std::size_t>(i)] = first + static_cast<double>(offset + i) * step;
    next[static_cast<std::size_t>(i)] = after[static_cast<std::size_t>(i)] = 0.0;
  }
  for (int k = count - 1; k >= 1; --k) {
    for (std::size_t i = 0; i < kBlock; ++i) {
      const double value = 2.0 * t[i] * next[i] - after[i] + c[k];
      after[i] = next[i];
      next[i] = value;
    }
  }
  for (std::size_t i = 0; i < kBlock; ++i) values[i] = t[i] * next[i] - after[i] + c[0];
}

}  // namespace

void chebyshev_values(const Eigen::VectorXd& c, double first, double step, int n, double* values) {
  const auto count = static_cast<int>(c.size());
  if (count == 0) return std::fill_n(values, n, 0.0), void();
  std::array<double, kBlock> block;
  for (int offset = 0; offset < n; offset += kBlock) {
    const int used = std::min(kBlock, n - offset);
    clenshaw_block(c.data(), count, first, step, offset,
                   used == kBlock ? values + offset : block.data());
    if (used < kBlock) std::copy_n(block.begin(), used, values + offset);
  }
}

namespace {

constexpr double kTukey = 4.685;
constexpr double kMadToSd = 1.4826;
constexpr int kCauchyRounds = 5;
constexpr int kTukeyRounds = 4;
constexpr double kSettled = 1e-4;  // change of a weight that counts as converged

double spread(const Eigen::VectorXd& residuals, std::vector<double>& sizes) {
  sizes.resize(static_cast<std::size_t>(residuals.size()));
  for (Eigen::Index i = 0; i < residuals.size(); ++i)
    sizes[static_cast<std::size_t>(i)] = std::abs(residuals[i]);
  return std::max(kMadToSd * upper_median(sizes), 1e-9);
}

/// sums += weight * values, for each point in turn: `values` holds `count` of them for each.
ALLTACT_WIDE void add_weighted(const double* __restrict weights, std::ptrdiff_t points,
                               const double* __restrict values, std::ptrdiff_t stride,
                               std::ptrdiff_t count, double* __restrict sums) {
  for (std::ptrdiff_t i = 0; i < points; ++i)
    for (std::ptrdiff_t k = 0; k < count; ++k) sums[k] += weights[i] * values[i * stride + k];
}

/// T_0 .. T_{2n - 2} at each point. Products of two of the first n are means of two of these, so 2n
/// - 1 weighted sums give all normal equations: T_i T_j = (T_{i + j} + T_{|i - j|}) / 2.
class ChebyshevTable {
 public:
  ChebyshevTable(Eigen::Index n, Eigen::Index points) : n_(n), values_(2 * n - 1, points) {}

  void set(Eigen::Index point, double t) {
    double* row = values_.col(point).data();
    row[0] = 1.0;
    for (Eigen::Index k = 1; k < values_.rows(); ++k)
      row[k] = k == 1 ? t : 2.0 * t * row[k - 1] - row[k - 2];
  }
  /// sum of c_k T_k at a point.
  [[nodiscard]] double value(const Eigen::VectorXd& c, Eigen::Index point) const {
    const double* row = values_.col(point).data();
    double sum = 0;
    for (Eigen::Index k = n_; k-- > 0;) sum += c[k] * row[k];  // the large ones last
    return sum;
  }
  /// sums over the points of weight T_i T_j.
  [[nodiscard]] Eigen::MatrixXd information(const Eigen::VectorXd& weights) const {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(values_.rows());
    add_weighted(weights.data(), weights.size(), values_.data(), values_.rows(), values_.rows(),
                 sums.data());
    Eigen::MatrixXd all(n_, n_);
    for (Eigen::Index i = 0; i < n_; ++i)
      for (Eigen::Index j = 0; j < n_; ++j) all(i, j) = 0.5 * (sums[i + j] + sums[std::abs(i - j)]);
    return all;
  }
  /// sums over the points of values T_k.
  [[nodiscard]] Eigen::VectorXd projected(const Eigen::VectorXd& values) const {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(n_);
    add_weighted(values.data(), values.size(), values_.data(), values_.rows(), n_, sums.data());
    return sums;
  }

 private:
  Eigen::Index n_;
  Eigen::MatrixXd values_;  // a column for each point
};

double cauchy_weight(double r) { return 1.0 / (1.0 + r * r); }

double tukey_weight(double r) {
  const double z = r / kTukey;
  return std::abs(z) < 1.0 ? (1.0 - z * z) * (1.0 - z * z) : 0.0;
}

}  // namespace

double RobustPolynomial::value(double x) const {
  return chebyshev_value(coefficients, (x - middle) / half);
}

std::vector<double> RobustPolynomial::values(double first_x, double step, int n) const {
  std::vector<double> result(static_cast<std::size_t>(n));
  chebyshev_values(coefficients, (first_x - middle) / half, step / half, n, result.data());
  return result;
}

double RobustPolynomial::sd(double x) const {
  const Eigen::Index n = coefficients.size();
  const Eigen::RowVectorXd row = chebyshev_row((x - middle) / half, n);
  double variance = 0;
  for (Eigen::Index j = 0; j < n; ++j) {
    double sum = 0.5 * row[j] * covariance(j, j);
    for (Eigen::Index i = 0; i < j; ++i) sum += row[i] * covariance(i, j);
    variance += 2.0 * row[j] * sum;
  }
  return std::sqrt(std::max(0.0, variance));
}

std::optional<RobustPolynomial> fit_robust_polynomial(const std::vector<double>& x,
                                                      const std::vector<double>& y,
                                                      const std::vector<double>& sd,
                                                      const std::vector<char>& valid, int degree) {
  const Eigen::Index n = degree + 1;
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (valid[i]) points.push_back(i);
  const auto count = static_cast<Eigen::Index>(points.size());
  if (count < 2 * n) return std::nullopt;

  RobustPolynomial fit;
  fit.middle = 0.5 * (x[points.front()] + x[points.back()]);
  fit.half = std::max(0.5 * (x[points.back()] - x[points.front()]), 1e-9);
  ChebyshevTable table(n, count);
  Eigen::VectorXd target(count), inverse_sd(count);  // 1 / sd
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t k = points[static_cast<std::size_t>(i)];
    table.set(i, (x[k] - fit.middle) / fit.half);
    target[i] = y[k];
    inverse_sd[i] = 1.0 / sd[k];
  }

  fit.coefficients = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count), residuals = target, precision, before;
  Eigen::VectorXd standardised(count);
  std::vector<double> sizes;
  for (int round = 0; round < kCauchyRounds + kTukeyRounds; ++round) {
    precision = weights.cwiseProduct(inverse_sd.cwiseAbs2());
    const Eigen::LLT<Eigen::MatrixXd> factor(table.information(precision));
    if (factor.info() != Eigen::Success) return std::nullopt;
    fit.coefficients += factor.solve(table.projected(precision.cwiseProduct(residuals)));
    for (Eigen::Index i = 0; i < count; ++i)
      residuals[i] = target[i] - table.value(fit.coefficients, i);
    standardised = residuals.cwiseProduct(inverse_sd);
    if (!standardised.allFinite()) return std::nullopt;
    fit.scale = spread(standardised, sizes);
    before = weights;
    const bool cauchy = round < kCauchyRounds;
    for (Eigen::Index i = 0; i < count; ++i) {
      const double size = standardised[i] / fit.scale;
      weights[i] = cauchy ? cauchy_weight(size) : tukey_weight(size);
    }
    if ((weights - before).cwiseAbs().maxCoeff() > kSettled) continue;
    if (!cauchy) break;
    round = kCauchyRounds - 1;  // on to Tukey's
  }

  fit.first = x[points.back()], fit.last = x[points.front()];
  for (Eigen::Index i = 0; i < count; ++i) {
    if (weights[i] <= 0.0) continue;
    ++fit.inliers;
    fit.first = std::min(fit.first, x[points[static_cast<std::size_t>(i)]]);
    fit.last = std::max(fit.last, x[points[static_cast<std::size_t>(i)]]);
  }
  if (fit.inliers < 2 * n || !fit.coefficients.allFinite()) return std::nullopt;
  const Eigen::LLT<Eigen::MatrixXd> factor(
      table.information(weights.cwiseProduct(inverse_sd.cwiseAbs2())));
  if (factor.info() != Eigen::Success) return std::nullopt;
  // Residuals beyond the points' own sd inflate the covariance; it is never reduced.
  const double inflation = std::max(1.0, fit.scale * fit.scale);
  fit.covariance = inflation * factor.solve(Eigen::MatrixXd::Identity(n, n));
  return fit;
}

}  // namespace alltact
