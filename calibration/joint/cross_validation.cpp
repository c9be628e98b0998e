#include "calibration/joint/cross_validation.h"

#include "calibration/joint/stored_curve.h"
#include "calibration/verdict/press_coverage.h"
#include "calibration/verdict/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace alltact {
namespace {

constexpr double kTiePart = 0.1;  // of the better error: closer errors are ties

/// The contact's position on the face, by the ball fitted to it.
ContactSpot spot_of(const PressSamples& press, const Eigen::Vector3d& centre_mm) {
  const Sample* nearest = nearest_sample(press, centre_mm);
  if (nearest == nullptr) return {};
  const double height_mm = plane_below(press, centre_mm).height_mm(centre_mm);
  const double rim2 = (press.ball_radius_mm - height_mm) * (press.ball_radius_mm + height_mm);
  return {nearest->position_mm.x(), nearest->position_mm.y(), std::sqrt(std::max(0.0, rim2)), 0};
}

/// The position of each press, numbered from 0. With fewer than three positions each press has its
/// own: one press alone does not show the scale.
std::vector<int> positions_of(const ChoiceInput& input, const JointFit& all) {
  std::vector<ContactSpot> spots;
  for (std::size_t i = 0; i < input.presses.size(); ++i)
    spots.push_back(spot_of(*input.presses[i], all.centres_mm[i]));
  std::vector<int> positions = position_numbers(spots);
  constexpr int kFewest = 3;
  if (std::all_of(positions.begin(), positions.end(), [](int n) { return n + 1 < kFewest; }))
    std::iota(positions.begin(), positions.end(), 0);
  return positions;
}

}  // namespace

double error_of_press(const PressSamples& press,
                      const JointFit& mapping,
                      const Eigen::Vector3d& centre_mm,
                      const JointOptions& options,
                      const Job& job) {
  // The inner zone only: the rim does not show the mapping's shape.
  JointOptions ball_only = options;
  ball_only.fix_mapping = true;
  ball_only.zone = kInnerZone;
  ball_only.watch = nullptr;
  const std::vector<const PressSamples*> one{&press};
  const JointFit ball =
      fit_jointly(one, {mapping.curve, {centre_mm}, false, mapping.lift_mm}, ball_only, job);
  return ball.converged ? quality_of(one, ball, ball_only).residual_mm.front()
                        : std::numeric_limits<double>::infinity();
}

HeldOutPresses hold_out(const ChoiceInput& input,
                        const JointFit& all,
                        const JointOptions& options,
                        const Job& job) {
  const std::vector<int> positions = positions_of(input, all);
  const int count =
      positions.empty() ? 0 : 1 + *std::max_element(positions.begin(), positions.end());
  HeldOutPresses result;
  std::vector<double> errors_mm(input.presses.size(), -1.0);
  for (int left = 0; left < count && !job.stop_requested(); ++left) {
    std::vector<const PressSamples*> others;
    JointFit fit{all.curve, {}, false, all.lift_mm};
    for (std::size_t i = 0; i < input.presses.size(); ++i) {
      if (positions[i] == left) continue;
      others.push_back(input.presses[i]);
      fit.centres_mm.push_back(all.centres_mm[i]);
    }
    fit = fit_jointly(others, std::move(fit), options, job);
    const bool is_good = fit.converged && increases(fit.curve, options.along);
    for (std::size_t i = 0; i < input.presses.size(); ++i)
      if (positions[i] == left)
        errors_mm[i] = is_good
                           ? error_of_press(*input.presses[i], fit, all.centres_mm[i], options, job)
                           : std::numeric_limits<double>::infinity();
    result.curves.push_back(std::move(fit.curve));
  }
  for (const double error_mm : errors_mm) {
    if (error_mm < 0) break;  // stopped before it
    result.errors_mm.push_back(error_mm);
  }
  return result;
}

double spread_of(const std::vector<MappingCurve>& curves) {
  const auto n = static_cast<double>(curves.size());
  if (curves.size() < 2) return 0;
  double spread = 0;
  for (int i = 1; i <= kDomainPoints; ++i) {
    const double x = curves.front().x_max() * i / kDomainPoints;
    double mean = 0, squares = 0;
    for (const MappingCurve& curve : curves) mean += curve.depth_mm(x) / n;
    for (const MappingCurve& curve : curves) squares += std::pow(curve.depth_mm(x) - mean, 2);
    spread += kMeanOfSd * std::sqrt(squares * (n - 1) / n) / kDomainPoints;
  }
  return spread;
}

double mean_mm(const std::vector<double>& values) {
  double mean = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  return mean;
}

Excess excess_of(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean += (a[i] - b[i]) / n;
  double variance = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    variance += (a[i] - b[i] - mean) * (a[i] - b[i] - mean) / (n - 1.0);
  return {mean, std::sqrt(variance / n)};
}

bool is_no_worse(const std::vector<double>& a, const std::vector<double>& b) {
  const Excess excess = excess_of(a, b);
  return excess.mean <= std::max({kTieMm, kTiePart * mean_mm(b), excess.standard_error});
}

}  // namespace alltact
