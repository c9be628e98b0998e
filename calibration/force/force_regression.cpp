#include "calibration/force/force_regression.h"

#include "calibration/force/force_table.h"
#include "core/numerics/philox.h"

#include <algorithm>
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
  Eigen::MatrixXd step(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& gradient, double rate,
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
                         yc.colwise().squaredNorm().transpose(), static_cast<double>(z.rows())};
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

ForceRegressor fit_force_network(const Eigen::MatrixXd& z, const Eigen::MatrixXd& force_N,
                                 const ForceNetworkOptions& options, std::uint32_t which) {
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

ForceMember fit_force_member(const std::vector<ForceInput>& filled, const Eigen::MatrixXd& force_N,
                             const std::vector<Eigen::Index>& rows, ForceKind kind,
                             const ForceNetworkOptions& options, std::uint32_t which) {
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
        z, y, options,
        which * static_cast<std::uint32_t>(options.members) + static_cast<std::uint32_t>(i)));
  return member;
}

// Inputs of a force regression, learnt from a table.

namespace {

constexpr int kMaxRangeComponents = 12, kMaxComponents = 40, kSquared = 8, kCrept = 3;
constexpr double kMinNoisePx = 0.05;  // of a marker, however still the table
// sd of a column without more motion than this carries no information
constexpr double kColumnNoisePx = 0.2;
constexpr int kFillings = 10;          // iterations until hidden markers converge
constexpr int kMinHidden = 3;          // frames required to learn a flag
constexpr double kMinNetworkSd = 0.1;  // of the first component's: smaller components are noise

/// Eigenvectors of the columns' covariance, greatest first.
struct Principal {
  Eigen::MatrixXd components;
  Eigen::VectorXd sd;
};

Principal principal_components(const Eigen::MatrixXd& centred, Eigen::Index max_count) {
  const double count = std::max<double>(1, static_cast<double>(centred.rows() - 1));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(centred.transpose() * centred / count);
  const Eigen::Index columns = centred.cols();
  const double greatest = std::max(eigen.eigenvalues()[columns - 1], 0.0);
  Eigen::Index retained = 0;
  while (retained < std::min({max_count, columns, centred.rows() - 1}) &&
         eigen.eigenvalues()[columns - 1 - retained] > 1e-10 * greatest)
    ++retained;
  return {eigen.eigenvectors().rightCols(retained).rowwise().reverse(),
          eigen.eigenvalues().tail(retained).reverse().cwiseSqrt()};
}

Eigen::MatrixXd displacements(const std::vector<ForceInput>& inputs,
                              const std::vector<Eigen::Index>& rows) {
  Eigen::MatrixXd all(static_cast<Eigen::Index>(rows.size()),
                      inputs.front().displacement_px.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    all.row(static_cast<Eigen::Index>(i)) =
        inputs[static_cast<std::size_t>(rows[i])].displacement_px.transpose();
  return all;
}

/// Replaces hidden values by the mean of the seen ones.
void fill_with_means(std::vector<ForceInput>& inputs) {
  const Eigen::Index columns = inputs.front().displacement_px.size();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(columns), count = sum;
  for (const ForceInput& input : inputs)
    for (Eigen::Index c = 0; c < columns; ++c)
      if (input.seen[c / 2] > 0.5) sum[c] += input.displacement_px[c], count[c] += 1;
  for (ForceInput& input : inputs)
    for (Eigen::Index c = 0; c < columns; ++c)
      if (input.seen[c / 2] < 0.5)
        input.displacement_px[c] = count[c] > 0 ? sum[c] / count[c] : 0.0;
}

ForceRange range_of_filled(const std::vector<ForceInput>& inputs) {
  std::vector<Eigen::Index> rows(inputs.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<Eigen::Index>(i);
  Eigen::MatrixXd all = displacements(inputs, rows);
  ForceRange range;
  range.mean_px = all.colwise().mean();
  all.rowwise() -= range.mean_px.transpose();
  Principal principal = principal_components(all, kMaxRangeComponents);
  range.components = std::move(principal.components);
  range.component_sd_px = std::move(principal.sd);
  const double residual =
      (all - all * range.components * range.components.transpose()).squaredNorm();
  const auto freedom = static_cast<double>(all.size() - all.rows() * range.components.cols());
  range.noise_px = std::max(kMinNoisePx, freedom > 0 ? std::sqrt(residual / freedom) : 0.0);
  return range;
}

void learn_scaling(ForceBasis& basis, const std::vector<ForceInput>& filled,
                   const std::vector<Eigen::Index>& rows) {
  const Eigen::Index count = basis.extras();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(count), squares = sum, known = sum;
  for (const Eigen::Index row : rows) {
    const ForceInput& input = filled[static_cast<std::size_t>(row)];
    const Eigen::VectorXd extra = basis.raw_extras(input);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index axis = i - static_cast<Eigen::Index>(basis.flags.size());
      if (basis.has_position && axis >= 0 && axis < 2 && !input.position_mm) continue;
      sum[i] += extra[i], squares[i] += extra[i] * extra[i], known[i] += 1;
    }
  }
  basis.extra_mean = Eigen::VectorXd::Zero(count);
  basis.extra_scale = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (known[i] < 2) continue;
    const double mean = sum[i] / known[i];
    const double variance = squares[i] / known[i] - mean * mean;
    basis.extra_mean[i] = mean;
    if (variance > 1e-12 * std::max(1.0, mean * mean))
      basis.extra_scale[i] = 1 / std::sqrt(variance);
  }
}

}  // namespace

ForceRange learn_force_range(std::vector<ForceInput>& inputs) {
  const bool is_hidden = std::any_of(inputs.begin(), inputs.end(), [](const ForceInput& input) {
    return input.seen.minCoeff() < 0.5;
  });
  if (is_hidden) fill_with_means(inputs);
  ForceRange range = range_of_filled(inputs);
  for (int i = 0; is_hidden && i < kFillings; ++i) {
    for (ForceInput& input : inputs) range.fill(input);
    range = range_of_filled(inputs);
  }
  range.min_seen = static_cast<int>(inputs.front().seen.size());
  range.has_all_positions = std::all_of(inputs.begin(), inputs.end(), [](const ForceInput& input) {
    return input.position_mm.has_value();
  });
  for (ForceInput& input : inputs) {
    range.fill(input);  // as in the measurement of forces
    const ForceRange::RangeDeviation found = range.deviation(input);
    range.max_t2 = std::max(range.max_t2, found.t2);
    range.max_residual_px = std::max(range.max_residual_px, found.residual_px);
    range.min_seen = std::min(range.min_seen, static_cast<int>(input.seen.sum() + 0.5));
    if (!input.position_mm) continue;
    if (!range.position_mm) range.position_mm = {*input.position_mm, *input.position_mm};
    (*range.position_mm)[0] = (*range.position_mm)[0].cwiseMin(*input.position_mm);
    (*range.position_mm)[1] = (*range.position_mm)[1].cwiseMax(*input.position_mm);
  }
  return range;
}

ForceBasis learn_force_basis(const std::vector<ForceInput>& filled,
                             const std::vector<Eigen::Index>& rows, ForceKind kind) {
  ForceBasis basis;
  Eigen::MatrixXd all = displacements(filled, rows);
  basis.mean_px = all.colwise().mean();
  all.rowwise() -= basis.mean_px.transpose();
  basis.scale =
      ((all.colwise().squaredNorm() / std::max(1.0, static_cast<double>(all.rows()) - 1.0))
           .array() +
       kColumnNoisePx * kColumnNoisePx)
          .sqrt()
          .inverse()
          .matrix()
          .transpose();
  basis.components.resize(all.cols(), 0);
  if (kind == ForceKind::kMean) return basis;
  all = all * basis.scale.asDiagonal();
  Principal principal = principal_components(all, kMaxComponents);
  basis.components = std::move(principal.components);
  const Eigen::VectorXd& sd = principal.sd;
  basis.gain = Eigen::VectorXd::Ones(sd.size());
  if (sd.size() > 0 && kind == ForceKind::kQuadratic) basis.gain.setConstant(1 / sd[0]);
  if (sd.size() > 0 && kind == ForceKind::kNetwork)
    basis.gain = sd.cwiseMax(kMinNetworkSd * sd[0]).cwiseInverse();
  const auto n = static_cast<double>(rows.size());
  Eigen::VectorXd seen = Eigen::VectorXd::Zero(filled.front().seen.size());
  double positions = 0;
  bool has_creep = true;
  for (const Eigen::Index row : rows) {
    const ForceInput& input = filled[static_cast<std::size_t>(row)];
    seen += input.seen;
    positions += input.position_mm ? 1 : 0;
    has_creep = has_creep && input.crept_px.size() > 0;
  }
  for (Eigen::Index m = 0; m < seen.size(); ++m)
    if (std::min(seen[m], n - seen[m]) >= kMinHidden) basis.flags.push_back(static_cast<int>(m));
  basis.has_position = positions >= kMinHidden;
  const int components = static_cast<int>(sd.size());
  basis.crept = has_creep ? std::min(kCrept, components) : 0;
  basis.squared = kind == ForceKind::kQuadratic ? std::min(kSquared, components) : 0;
  learn_scaling(basis, filled, rows);
  return basis;
}

}  // namespace alltact
