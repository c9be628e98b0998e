#include "calibration/force/force_regression.h"

#include "calibration/force/force_split.h"
#include "core/numerics/philox.h"

#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace alltact {
namespace {

/// Sums of squares of a ridge regression in the eigenvectors of z' z.
struct RidgeSums {
  Eigen::VectorXd eigenvalue;
  Eigen::MatrixXd target;  // eigenvectors' z' y, one column an axis
  Eigen::VectorXd total;   // y' y
  double rows = 0;

  /// Logarithm of the marginal likelihood of all axes, with the noise at its maximum.
  [[nodiscard]] double evidence(double lambda) const {
    const double spread = (1 + eigenvalue.array() / lambda).log().sum();
    double sum = 0;
    for (Eigen::Index axis = 0; axis < target.cols(); ++axis) {
      const double fitted =
          (target.col(axis).array().square() / (eigenvalue.array() + lambda)).sum();
      const double left = std::max(total[axis] - fitted, 1e-14 * total[axis]);
      sum -= 0.5 * rows * std::log(std::max(left, 1e-300) / rows) + 0.5 * spread;
    }
    return sum;
  }

  [[nodiscard]] double best_lambda() const {
    const double unit = std::max(eigenvalue.maxCoeff(), 1e-300);
    double best = unit, max_evidence = evidence(unit);
    for (int i = -100; i <= 60; ++i) {
      const double lambda = unit * std::pow(10.0, 0.1 * i);
      if (const double found = evidence(lambda); found > max_evidence)
        max_evidence = found, best = lambda;
    }
    return best;
  }
};

/// Random numbers of one network, in sequence.
class NetworkDraws {
 public:
  NetworkDraws(std::uint64_t seed, std::uint32_t which) : seed_(seed), which_(which) {}
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * M_PI * uniform());
  }

 private:
  double uniform() { return philox_uniform(seed_, "force network", which_, next_++); }
  std::uint64_t seed_;
  std::uint32_t which_, next_ = 0;
};

/// Weights with Adam's moments of their gradients.
struct AdamLayer {
  Eigen::MatrixXd weights, first, second;  // the last column is the bias

  AdamLayer(int inputs, int outputs, NetworkDraws& draws)
      : weights(Eigen::MatrixXd::Zero(outputs, inputs + 1)), first(weights), second(weights) {
    const double sd = std::sqrt(2.0 / std::max(1, inputs));  // He et al., ICCV 2015
    for (int column = 0; column < inputs; ++column)
      for (int row = 0; row < outputs; ++row) weights(row, column) = sd * draws.normal();
  }

  [[nodiscard]] Eigen::MatrixXd operator()(const Eigen::MatrixXd& inputs) const {
    return (weights.leftCols(weights.cols() - 1) * inputs).colwise() +
           weights.col(weights.cols() - 1);
  }
  /// Updates the weights; returns the gradient by the inputs.
  Eigen::MatrixXd step(const Eigen::MatrixXd& inputs,
                       const Eigen::MatrixXd& gradient,
                       double rate,
                       int t) {
    constexpr double kFirst = 0.9, kSecond = 0.999, kDecay = 1e-3;
    const Eigen::Index last = weights.cols() - 1;
    Eigen::MatrixXd back = weights.leftCols(last).transpose() * gradient;
    Eigen::MatrixXd slope(weights.rows(), weights.cols());
    slope.leftCols(last).noalias() = gradient * inputs.transpose();
    slope.col(last) = gradient.rowwise().sum();
    first += (1 - kFirst) * (slope - first);
    second += (1 - kSecond) * (slope.cwiseAbs2() - second);
    const double of_first = 1 - std::pow(kFirst, t), of_second = 1 - std::pow(kSecond, t);
    weights.leftCols(last) *= 1 - rate * kDecay;
    weights.array() -=
        rate * (first.array() / of_first) / ((second.array() / of_second).sqrt() + 1e-8);
    return back;
  }
  [[nodiscard]] ForceLayer layer() const {
    return {weights.leftCols(weights.cols() - 1), weights.col(weights.cols() - 1)};
  }
};

Eigen::MatrixXd slope_where_above_0(const Eigen::MatrixXd& gradient,
                                    const Eigen::MatrixXd& hidden) {
  return (hidden.array() > 0).select(gradient, 0.0);
}

}  // namespace

ForceRegressor fit_force_ridge(const Eigen::MatrixXd& z, const Eigen::MatrixXd& force_N) {
  const Eigen::RowVectorXd z_mean = z.colwise().mean(), y_mean = force_N.colwise().mean();
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(force_N.cols(), z.cols());
  if (z.cols() > 0) {
    const Eigen::MatrixXd zc = z.rowwise() - z_mean, yc = force_N.rowwise() - y_mean;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(zc.transpose() * zc);
    const RidgeSums sums{eigen.eigenvalues().cwiseMax(0.0),
                         eigen.eigenvectors().transpose() * (zc.transpose() * yc),
                         yc.colwise().squaredNorm().transpose(),
                         static_cast<double>(z.rows())};
    const double best = sums.best_lambda();
    constexpr int kHalfDecades = 2;
    for (int i = -kHalfDecades; i <= kHalfDecades; ++i) {
      const double lambda = best * std::pow(10.0, 0.5 * i);
      const Eigen::VectorXd shrunk = (sums.eigenvalue.array() + lambda).inverse();
      weights += (eigen.eigenvectors() * shrunk.asDiagonal() * sums.target).transpose() /
                 (2 * kHalfDecades + 1);
    }
  }
  const Eigen::VectorXd bias = y_mean.transpose() - weights * z_mean.transpose();
  return {ForceLayer{std::move(weights), bias}};
}

ForceRegressor fit_force_network(const Eigen::MatrixXd& z,
                                 const Eigen::MatrixXd& force_N,
                                 const ForceNetworkOptions& options,
                                 std::uint32_t which) {
  constexpr Eigen::Index kBatch = 32;
  constexpr double kRate = 3e-3;
  constexpr Eigen::Index kPasses = 100, kMinSteps = 300;  // more overfits a small table
  const Eigen::Index rows = z.rows(), axes = force_N.cols();
  const Eigen::VectorXd mean = force_N.colwise().mean().transpose();
  const Eigen::VectorXd sd =
      ((force_N.rowwise() - mean.transpose()).colwise().squaredNorm() / static_cast<double>(rows))
          .cwiseSqrt()
          .cwiseMax(1e-9)
          .transpose();
  const Eigen::MatrixXd inputs = z.transpose();
  const Eigen::MatrixXd targets =
      ((force_N.rowwise() - mean.transpose()) * sd.cwiseInverse().asDiagonal()).transpose();
  const int steps = static_cast<int>(
      std::min<Eigen::Index>(options.steps, std::max(kMinSteps, kPasses * rows / kBatch)));
  NetworkDraws draws(options.seed, which);
  AdamLayer one(static_cast<int>(z.cols()), options.hidden_1, draws);
  AdamLayer two(options.hidden_1, options.hidden_2, draws);
  AdamLayer three(options.hidden_2, static_cast<int>(axes), draws);
  three.weights *= 0.1;  // starts near the mean
  const Eigen::Index batch = std::min(kBatch, rows);
  Eigen::MatrixXd x(z.cols(), batch), y(axes, batch);
  std::vector<Eigen::Index> order;
  std::size_t next = 0;
  std::uint32_t epoch = 0;
  for (int t = 1; t <= steps; ++t) {
    for (Eigen::Index i = 0; i < batch; ++i, ++next) {
      if (next >= order.size()) {
        order = drawn_order(rows, options.seed, "force network rows", 4096 * which + epoch++);
        next = 0;
      }
      x.col(i) = inputs.col(order[next]), y.col(i) = targets.col(order[next]);
    }
    const Eigen::MatrixXd h1 = one(x).cwiseMax(0.0), h2 = two(h1).cwiseMax(0.0);
    const Eigen::MatrixXd error = (three(h2) - y) / static_cast<double>(batch);
    const double rate = 0.5 * kRate * (1 + std::cos(M_PI * (t - 1) / steps));
    const Eigen::MatrixXd g2 = slope_where_above_0(three.step(h2, error, rate, t), h2);
    const Eigen::MatrixXd g1 = slope_where_above_0(two.step(h1, g2, rate, t), h1);
    one.step(x, g1, rate, t);
  }
  ForceLayer out = three.layer();
  out.weights = sd.asDiagonal() * out.weights;
  out.bias = sd.cwiseProduct(out.bias) + mean;
  return {one.layer(), two.layer(), std::move(out)};
}

ForceMember fit_force_member(const std::vector<ForceInput>& filled,
                             const Eigen::MatrixXd& force_N,
                             const std::vector<Eigen::Index>& rows,
                             ForceKind kind,
                             const ForceNetworkOptions& options,
                             std::uint32_t which) {
  ForceMember member{learn_force_basis(filled, rows, kind), {}};
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd z(count, member.basis.size()), y(count, force_N.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = rows[static_cast<std::size_t>(i)];
    if (z.cols() > 0) z.row(i) = member.basis(filled[static_cast<std::size_t>(row)]).transpose();
    y.row(i) = force_N.row(row);
  }
  if (kind != ForceKind::kNetwork) {
    member.regressors = {fit_force_ridge(z, y)};
    return member;
  }
  for (int i = 0; i < options.members; ++i)
    member.regressors.push_back(fit_force_network(
        z,
        y,
        options,
        which * static_cast<std::uint32_t>(options.members) + static_cast<std::uint32_t>(i)));
  return member;
}

}  // namespace alltact
