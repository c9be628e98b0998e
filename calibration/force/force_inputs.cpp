// Inputs of a force regression, learnt from a table.
#include "calibration/force/force_regression.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace alltact {
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

void learn_scaling(ForceBasis& basis,
                   const std::vector<ForceInput>& filled,
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
                             const std::vector<Eigen::Index>& rows,
                             ForceKind kind) {
  ForceBasis basis;
  Eigen::MatrixXd all = displacements(filled, rows);
  basis.mean_px = all.colwise().mean();
  all.rowwise() -= basis.mean_px.transpose();
  basis.scale = ((all.colwise().squaredNorm() / std::max<double>(1.0, all.rows() - 1.0)).array() +
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
