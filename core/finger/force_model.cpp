// Estimation of forces with a force model.
#include "core/finger/force_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

namespace alltact {
namespace {

constexpr double kRangeMargin = 1.1;       // in range up to this multiple of the table's maximum
constexpr double kPositionMarginMm = 2.0;  // margin around the positions of the table
constexpr double kRestTolerancePx = 2.0;   // tolerance for a marker at rest
constexpr double kLargestInput = 1e6;      // px, mm: larger values are invalid

bool is_usable(const Eigen::VectorXd& values) {
  return values.allFinite() && (values.size() == 0 || values.cwiseAbs().maxCoeff() < kLargestInput);
}

}  // namespace

Eigen::VectorXd ForceRange::scores(const ForceInput& input) const {
  const Eigen::Index k = components.cols();
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(k, k);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(k);
  for (Eigen::Index m = 0; m < input.seen.size(); ++m) {
    if (input.seen[m] < 0.5) continue;
    for (Eigen::Index c = 2 * m; c < 2 * m + 2; ++c) {
      const auto row = components.row(c).transpose();
      information.noalias() += row * row.transpose();
      right.noalias() += row * (input.displacement_px[c] - mean_px[c]);
    }
  }
  information.diagonal().array() += noise_px * noise_px / component_sd_px.array().square();
  return information.ldlt().solve(right);
}

void ForceRange::fill(ForceInput& input) const {
  if (input.seen.size() == 0 || input.seen.minCoeff() > 0.5) return;
  const Eigen::VectorXd likeliest = mean_px + components * scores(input);
  for (Eigen::Index m = 0; m < input.seen.size(); ++m)
    if (input.seen[m] < 0.5) input.displacement_px.segment<2>(2 * m) = likeliest.segment<2>(2 * m);
}

ForceRange::RangeDeviation ForceRange::deviation(const ForceInput& filled) const {
  const Eigen::VectorXd from_mean = filled.displacement_px - mean_px;
  const Eigen::VectorXd score = components.transpose() * from_mean;
  const Eigen::VectorXd residual = from_mean - components * score;
  const double seen = std::max(1.0, filled.seen.sum());
  return {score.cwiseQuotient(component_sd_px).squaredNorm(),
          std::sqrt(residual.squaredNorm() / (2 * seen))};
}

bool ForceRange::holds(const ForceInput& filled) const {
  const RangeDeviation found = deviation(filled);
  if (found.t2 > kRangeMargin * kRangeMargin * max_t2 ||
      found.residual_px > kRangeMargin * max_residual_px)
    return false;
  if (filled.seen.sum() < min_seen - 0.5) return false;
  if (!filled.position_mm || !position_mm)
    return filled.position_mm.has_value() || !has_all_positions;
  return ((*filled.position_mm - (*position_mm)[0]).array() >= -kPositionMarginMm).all() &&
         ((*filled.position_mm - (*position_mm)[1]).array() <= kPositionMarginMm).all();
}

int ForceBasis::size() const {
  const int multiplied = squared + (squared > 0 && has_position ? 3 : 0);
  return plain_size() + multiplied * (multiplied + 1) / 2;
}

Eigen::VectorXd ForceBasis::raw_extras(const ForceInput& filled) const {
  Eigen::VectorXd extra(extras());
  Eigen::Index at = 0;
  for (const int flag : flags) extra[at++] = filled.seen[flag];
  if (has_position) {
    // An unknown position is replaced by the mean.
    const bool known = filled.position_mm.has_value();
    const bool is_learnt = extra_mean.size() == extra.size();
    for (int i = 0; i < 2; ++i, ++at)
      extra[at] = known ? (*filled.position_mm)[i] : is_learnt ? extra_mean[at] : 0.0;
    extra[at++] = known ? 1.0 : 0.0;
  }
  if (crept > 0) {
    if (filled.crept_px.size() == components.rows())
      extra.tail(crept) =
          components.leftCols(crept).transpose() * filled.crept_px.cwiseProduct(scale);
    else
      extra.tail(crept).setZero();
  }
  return extra;
}

Eigen::VectorXd ForceBasis::operator()(const ForceInput& filled) const {
  Eigen::VectorXd z(size());
  const Eigen::Index p = gain.size();
  if (p > 0)
    z.head(p) = (components.transpose() * (filled.displacement_px - mean_px).cwiseProduct(scale))
                    .cwiseProduct(gain);
  if (extras() > 0)
    z.segment(p, extras()) = (raw_extras(filled) - extra_mean).cwiseProduct(extra_scale);
  if (squared == 0) return z;
  // Components of equal scale, so that each product has an influence.
  std::vector<Eigen::Index> factors(static_cast<std::size_t>(squared));
  std::iota(factors.begin(), factors.end(), 0);
  if (has_position)
    for (Eigen::Index i = 0; i < 3; ++i)
      factors.push_back(p + static_cast<Eigen::Index>(flags.size()) + i);
  Eigen::Index at = plain_size();
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (std::size_t j = i; j < factors.size(); ++j) z[at++] = z[factors[i]] * z[factors[j]];
  return z;
}

Eigen::VectorXd force_of(const ForceRegressor& regressor, const Eigen::VectorXd& z) {
  Eigen::VectorXd layer = z;
  for (std::size_t i = 0; i < regressor.size(); ++i) {
    Eigen::VectorXd next = regressor[i].weights * layer + regressor[i].bias;
    if (i + 1 < regressor.size()) next = next.cwiseMax(0.0);
    layer = std::move(next);
  }
  return layer;
}

Eigen::VectorXd ForceMember::operator()(const ForceInput& filled) const {
  const Eigen::VectorXd z = basis(filled);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(regressors.front().back().bias.size());
  for (const ForceRegressor& regressor : regressors) sum += force_of(regressor, z);
  return sum / static_cast<double>(regressors.size());
}

std::optional<Force> ForceModel::operator()(ForceInput input) const {
  if (input.seen.size() != marker_count || input.displacement_px.size() != 2 * marker_count ||
      input.seen.sum() < 0.5 || !is_usable(input.displacement_px) || !is_usable(input.crept_px))
    return std::nullopt;
  if (input.position_mm && !is_usable(*input.position_mm)) input.position_mm.reset();
  range.fill(input);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(axes), squares = sum;
  Eigen::VectorXd first;
  for (const ForceMember& member : members) {
    const Eigen::VectorXd force = member(input);
    if (first.size() == 0) first = force;
    sum += force - first;
    squares += (force - first).cwiseAbs2();
  }
  const double count = static_cast<double>(members.size());
  const Eigen::VectorXd mean = sum / count;
  const Eigen::VectorXd variance = (squares / count - mean.cwiseAbs2()).cwiseMax(0.0);
  const Eigen::VectorXd s = (scores.floor_N.cwiseAbs2() + variance).cwiseSqrt();
  Force force;
  force.axes = axes;
  force.force_N.head(axes) = first + mean;
  force.sd_N.head(axes) = s.cwiseProduct(scores.rms);
  force.half_90_N.head(axes) = s.cwiseProduct(scores.quantile_90);
  force.half_95_N.head(axes) = s.cwiseProduct(scores.quantile_95);
  force.in_range = range.holds(input);
  if (!force.force_N.allFinite() || !force.sd_N.allFinite() || !force.half_95_N.allFinite() ||
      !force.half_90_N.allFinite())
    return std::nullopt;
  return force;
}

Status ForceModel::belongs_to(const Finger& finger) const {
  const Message advice = en::say("alltact force with a table of this finger's markers");
  if (finger.marker_count() != marker_count || finger.markers.missing != missing)
    return Error{en::say("the force model was trained with {} markers, the finger has {} others",
                         marker_count,
                         finger.marker_count()),
                 std::string("force.model"),
                 advice};
  if (!finger.contact) return {};
  double far_px = 0;
  for (std::size_t m = 0; m < rest_px.size(); ++m)
    far_px = std::max(far_px, (rest_px[m] - finger.contact->rest_markers[m]).norm());
  if (far_px <= kRestTolerancePx) return {};
  return Error{en::say("the force model belongs to another reference: its markers rested up to "
                       "{:.1f} px from where they rest now",
                       far_px),
               std::string("force.model"),
               advice};
}

}  // namespace alltact
