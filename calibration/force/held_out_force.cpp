#include "calibration/force/held_out_force.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core/utility.hpp>

namespace alltact {

HeldOutForce hold_out_force(const std::vector<ForceInput>& filled,
                            const Eigen::MatrixXd& force_N,
                            const ForceFolds& folds,
                            ForceKind kind,
                            const ForceNetworkOptions& options,
                            const Job& job) {
  HeldOutForce result;
  result.members.resize(static_cast<std::size_t>(folds.count));
  result.estimated_N = Eigen::MatrixXd::Zero(force_N.rows(), force_N.cols());
  cv::parallel_for_(cv::Range(0, folds.count), [&](const cv::Range& range) {
    for (int fold = range.start; fold < range.end && !job.stop_requested(); ++fold)
      result.members[static_cast<std::size_t>(fold)] =
          fit_force_member(filled,
                           force_N,
                           folds.rows_without(fold),
                           kind,
                           options,
                           static_cast<std::uint32_t>(fold));
  });
  if (job.stop_requested()) return result;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(force_N.rows(), force_N.cols()), squares = sum;
  for (int fold = 0; fold < folds.count; ++fold) {
    const ForceMember& member = result.members[static_cast<std::size_t>(fold)];
    for (Eigen::Index row = 0; row < force_N.rows(); ++row) {
      const auto i = static_cast<std::size_t>(row);
      const Eigen::RowVectorXd estimate = member(filled[i]).transpose();
      if (folds.of[i] == fold) result.estimated_N.row(row) = estimate;
      // Relative to the gauge's force, against loss of digits.
      const Eigen::RowVectorXd off = estimate - force_N.row(row);
      sum.row(row) += off, squares.row(row) += off.cwiseAbs2();
    }
  }
  const double count = folds.count;
  result.spread_N = (squares / count - (sum / count).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return result;
}

ForceErrorScores error_scores(const HeldOutForce& held_out, const Eigen::MatrixXd& force_N) {
  constexpr double kMinN = 1e-9;  // a table without noise
  const Eigen::MatrixXd error = held_out.estimated_N - force_N;
  ForceErrorScores scores;
  scores.floor_N = (error.colwise().squaredNorm() / static_cast<double>(error.rows()))
                       .cwiseSqrt()
                       .cwiseMax(kMinN)
                       .transpose();
  const Eigen::RowVectorXd floor2 = scores.floor_N.cwiseAbs2().transpose();
  scores.score = error.cwiseAbs().cwiseQuotient(
      (held_out.spread_N.cwiseAbs2().rowwise() + floor2).cwiseSqrt());
  return scores;
}

double conformal_quantile(std::vector<double> values, double level) {
  const double rank = std::ceil((static_cast<double>(values.size()) + 1) * level);
  const std::size_t index =
      std::min(values.size(), static_cast<std::size_t>(std::max(1.0, rank))) - 1;
  std::nth_element(
      values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
  return values[index];
}

Eigen::VectorXd covered_part(const Eigen::MatrixXd& score, const ForceFolds& folds, double level) {
  Eigen::VectorXd covered = Eigen::VectorXd::Zero(score.cols());
  for (Eigen::Index axis = 0; axis < score.cols(); ++axis)
    for (int fold = 0; fold < folds.count; ++fold) {
      std::vector<double> others;
      for (const Eigen::Index row : folds.rows_without(fold)) others.push_back(score(row, axis));
      const double quantile = conformal_quantile(std::move(others), level);
      for (const Eigen::Index row : folds.rows_in(fold))
        covered[axis] += score(row, axis) <= quantile ? 1 : 0;
    }
  return covered / static_cast<double>(score.rows());
}

}  // namespace alltact
