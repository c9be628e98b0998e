#include "calibration/joint/calibrate.h"
#include "calibration/joint/joint_costs.h"
#include "calibration/joint/joint_fit.h"
#include "core/numerics/linear_algebra.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kGrid = 12;          // points on the curve
constexpr double kMinGain = 0.05;  // of the standard deviation
constexpr std::array kDepthFactors{0.6, 1.0, 1.6};
constexpr double kDeepest = 1.25;  // times the depth of the deepest press made
constexpr int kThirds = 3;

/// Derivatives of depths over the domain by the mapping's values, a row each.
Eigen::MatrixXd gradients_of(const MappingCurve& curve) {
  const Eigen::Index n = curve.values().size();
  Eigen::MatrixXd rows(kGrid, n);
  for (int i = 0; i < kGrid; ++i) {
    Eigen::VectorXd gradient(n);
    (void)curve.depth_mm(curve.x_max() * (i + 1) / kGrid, gradient.data());
    rows.row(i) = gradient.transpose();
  }
  return rows;
}

/// Root mean square over the domain; infinite when the presses do not determine it.
double depth_sd_mm(const std::vector<const PressSamples*>& presses, const JointFit& fit,
                   const JointOptions& options) {
  const Eigen::MatrixXd covariance = covariance_of(presses, fit, options);
  if (covariance.size() == 0) return std::numeric_limits<double>::infinity();
  const Eigen::MatrixXd rows = gradients_of(fit.curve);
  const auto n = rows.cols();
  const double sum = (rows * covariance.topLeftCorner(n, n) * rows.transpose()).trace();
  return std::sqrt(std::max(0.0, sum / kGrid));
}

/// The difference at which the curve gives a depth, extrapolated beyond the domain.
double difference_at(const MappingCurve& curve, double depth_mm) {
  double low = -0.2, high = 1.5 * curve.x_max();
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (curve.depth_mm(middle) < depth_mm ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Simulates a press with the ball at `centre` from the samples of one that was made.
PressSamples simulated_press(const PressSamples& like, const MappingCurve& curve,
                             const Eigen::Vector3d& centre, const JointOptions& options,
                             std::uint32_t number) {
  PressSamples press = like;
  press.outline.clear();
  press.given_depth.reset();
  std::uint32_t k = 0;
  for (Sample& sample : press.samples) {
    const double depth = ball_depth_mm(sample, options.along, centre, press.ball_radius_mm);
    // The sum of four uniform numbers is nearly normal; only its spread matters.
    double noise = 0;
    for (const std::uint32_t part : philox({k++, number, 0, 0}, {0, fnv1a("press advice")}))
      noise += part * 0x1p-32 - 0.5;
    sample.x = (std::isfinite(depth) ? difference_at(curve, std::max(depth, -0.1)) : 0.0) +
               press.x_sd * noise * std::sqrt(3.0);
  }
  return press;
}

/// How deep the ball is pressed in along the face's normal, and its contact's position.
struct Pressed {
  double depth_mm = 0;
  Eigen::Vector2d position_mm = Eigen::Vector2d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};
Pressed pressed_by(const PressSamples& press, const Eigen::Vector3d& centre) {
  const Sample* nearest = nearest_sample(press, centre);
  if (nearest == nullptr) return {};
  return {press.ball_radius_mm - nearest->normal.dot(centre - nearest->untouched_n),
          nearest->position_mm, nearest->normal};
}

Message position_text(double along_mm, double across_mm) {
  const Message half = across_mm < 0 ? en::say("upper") : en::say("lower");
  const Message side =
      std::abs(across_mm) < 2.0
          ? en::say("in the middle of the face")
          : en::say("{:.0f} mm from the middle on the {} side", std::abs(across_mm), half);
  return en::say("{:.0f} mm from the base, {}", along_mm, side);
}

/// The middle of the first third of the face's length in which there is no press; -1: none.
double empty_third_mm(const std::vector<Pressed>& made, double face_length_mm) {
  for (const int third : {1, 2, 0}) {  // tips are pressed more often than bases
    const double from = third * face_length_mm / kThirds, to = from + face_length_mm / kThirds;
    if (std::none_of(made.begin(), made.end(), [&](const Pressed& pressed) {
          return pressed.position_mm.x() >= from && pressed.position_mm.x() <= to;
        }))
      return 0.5 * (from + to);
  }
  return -1.0;
}

}  // namespace

WeakestDirection weakest_direction(const MappingCurve& curve, const Eigen::MatrixXd& covariance) {
  const Eigen::MatrixXd rows = gradients_of(curve);
  const auto eigen = symmetric_eigen(rows * covariance * rows.transpose());
  const Eigen::VectorXd shape = eigen.eigenvectors().col(kGrid - 1) *
                                std::sqrt(std::max(0.0, eigen.eigenvalues()[kGrid - 1]));
  WeakestDirection weakest;
  Eigen::Index at_max = 0;
  weakest.sd_mm = shape.cwiseAbs().maxCoeff(&at_max);
  weakest.depth_mm = curve.depth_mm(curve.x_max() * static_cast<double>(at_max + 1) / kGrid);
  weakest.is_scale = shape.minCoeff() * shape.maxCoeff() >= 0.0;
  weakest.sentence =
      weakest.is_scale
          ? en::say(
                "the scale is least certain: all depths may be too large or too small together, by "
                "{:.3f} mm at {:.2f} mm (one standard deviation)",
                weakest.sd_mm, weakest.depth_mm)
          : en::say(
                "the relation of shallow to deep is least certain: by {:.3f} mm at {:.2f} mm (one "
                "standard deviation), with opposite sign at the other end",
                weakest.sd_mm, weakest.depth_mm);
  return weakest;
}

std::optional<RadiusSensitivity> vary_radius(const std::vector<const PressSamples*>& presses,
                                             const JointFit& fit, const JointOptions& options,
                                             const Job& job) {
  constexpr double kPart = 0.01;
  constexpr double kSeen = 0.1;  // of the residual
  struct Tried {
    double residual_mm, depth_mm;
  };
  const double x = fit.curve.x_max();
  const auto try_radius = [&](double factor) -> std::optional<Tried> {
    std::vector<PressSamples> others;
    JointFit start = fit;
    for (std::size_t i = 0; i < presses.size(); ++i) {
      others.push_back(*presses[i]);
      others.back().ball_radius_mm *= factor;
      // Retains the depth of the ball.
      start.centres_mm[i] += (factor - 1.0) * presses[i]->ball_radius_mm *
                             pressed_by(*presses[i], fit.centres_mm[i]).normal;
    }
    std::vector<const PressSamples*> tried;
    for (const PressSamples& press : others) tried.push_back(&press);
    const JointFit fitted = fit_jointly(tried, start, options, job);
    if (!fitted.converged || job.stop_requested()) return std::nullopt;
    double mean = 0;
    for (const double residual : quality_of(tried, fitted, options).residual_mm)
      mean += residual / static_cast<double>(presses.size());
    return Tried{mean, fitted.curve.depth_mm(x)};
  };
  const auto smaller = try_radius(1.0 - kPart), given = try_radius(1.0),
             larger = try_radius(1.0 + kPart);
  if (!smaller || !given || !larger) return std::nullopt;
  RadiusSensitivity sensitivity;
  sensitivity.depth_part = larger->depth_mm / given->depth_mm - 1.0;
  sensitivity.smaller_mm = smaller->residual_mm;
  sensitivity.given_mm = given->residual_mm;
  sensitivity.larger_mm = larger->residual_mm;
  sensitivity.is_seen =
      std::min(smaller->residual_mm, larger->residual_mm) > (1.0 + kSeen) * given->residual_mm;
  const Message other = sensitivity.depth_part < 0 ? en::say("smaller") : en::say("larger");
  const Message figures = en::say(
      "a ball 1 % larger than given makes depths {:.1f} % {}; the residual is {:.4f} mm with a "
      "radius 1 % smaller, {:.4f} mm as given, {:.4f} mm with one 1 % larger",
      100.0 * std::abs(sensitivity.depth_part), other, sensitivity.smaller_mm, sensitivity.given_mm,
      sensitivity.larger_mm);
  sensitivity.sentence = en::at(
      figures, sensitivity.is_seen ? en::say("a wrong radius would be noticed")
                                   : en::say("the presses cannot show a wrong radius, so measure "
                                             "the ball to a hundredth of a millimetre"));
  return sensitivity;
}

PressAdvice advise(const std::vector<const PressSamples*>& presses, const JointFit& fit,
                   const JointOptions& options, double face_length_mm) {
  PressAdvice advice;
  advice.sd_now_mm = depth_sd_mm(presses, fit, options);
  std::vector<Pressed> made;
  double deepest = 0;
  for (std::size_t i = 0; i < presses.size(); ++i) {
    made.push_back(pressed_by(*presses[i], fit.centres_mm[i]));
    deepest = std::max(deepest, made.back().depth_mm);
  }
  advice.sd_then_mm = std::numeric_limits<double>::infinity();
  std::vector<const PressSamples*> more = presses;
  more.push_back(nullptr);
  JointFit with = fit;
  with.centres_mm.emplace_back();
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < presses.size(); ++i)
    for (const double times : kDepthFactors) {
      const double depth = times * made[i].depth_mm;
      if (depth > kDeepest * deepest || depth < 0.2) continue;
      const Eigen::Vector3d centre =
          fit.centres_mm[i] - (depth - made[i].depth_mm) * made[i].normal;
      const PressSamples press = simulated_press(*presses[i], fit.curve, centre, options, number++);
      more.back() = &press;
      with.centres_mm.back() = centre;
      const double sd = depth_sd_mm(more, with, options);
      if (!(sd < advice.sd_then_mm)) continue;
      advice.sd_then_mm = sd;
      advice.depth_mm = depth;
      advice.along_mm = made[i].position_mm.x();
      advice.across_mm = made[i].position_mm.y();
    }
  const double empty = empty_third_mm(made, face_length_mm);
  if (!std::isfinite(advice.sd_then_mm)) {
    advice.sentence = en::say("press next: at another position, 0.5 to 1 mm deep");
  } else if (empty >= 0.0) {
    advice.along_mm = empty;
    advice.across_mm = 0;
    advice.sentence = en::say(
        "press next: {}, {:.1f} mm deep; no press shows whether the mapping holds in that third",
        position_text(empty, 0), advice.depth_mm);
  } else {
    advice.enough = advice.sd_then_mm > (1.0 - kMinGain) * advice.sd_now_mm;
    advice.sentence = advice.enough
                          ? en::say(
                                "enough: another press would reduce the standard "
                                "deviation of depth from {:.4f} mm to {:.4f} mm at best",
                                advice.sd_now_mm, std::min(advice.sd_now_mm, advice.sd_then_mm))
                          : en::say(
                                "press next: {}, {:.1f} mm deep; that would reduce the "
                                "standard deviation of depth from {:.4f} mm to {:.4f} mm",
                                position_text(advice.along_mm, advice.across_mm), advice.depth_mm,
                                advice.sd_now_mm, advice.sd_then_mm);
  }
  return advice;
}

namespace {

/// One press at the solution: each sample's residual and its derivatives by the unknowns.
struct Linear {
  // Weighted, a sample each: mapping values, this press's centre, the lift-off's logarithm.
  Eigen::MatrixXd rows;
  Eigen::VectorXd residual;  // weighted
  Eigen::VectorXd weight;    // 1/mm
  Eigen::VectorXd bend;
  std::vector<double> lifted_sd_mm;
  Eigen::VectorXd optics_sd_mm;  // sd by the optics' blur, common to all samples
  std::vector<int> patch;
  double taken = 0;                       // how many numbers were fitted to the residuals
  std::vector<std::pair<int, int>> cell;  // column and row of the sample's block
  Eigen::MatrixXd outline_rows;           // weighted, by the centre
  Eigen::VectorXd outline_residual;
  Eigen::Vector3d depth_row;  // of a measured depth, weighted, by the centre; else 0
};

Linear linearised(const PressSamples& press, const JointFit& fit, const Eigen::Vector3d& centre,
                  const JointOptions& options) {
  const WeightedPress weighted = weight_samples(press, fit, centre, options);
  const ContactDisc disc(press, options.along, centre);
  const Eigen::Index n_map = fit.curve.values().size();
  const auto count = static_cast<Eigen::Index>(weighted.samples.size());
  Linear linear;
  linear.rows.resize(count, n_map + 4);
  linear.lifted_sd_mm = weighted.lifted_sd_mm;
  linear.optics_sd_mm = Eigen::VectorXd::Zero(count);
  if (press.blur_px2 > 0.0)
    linear.optics_sd_mm = kOpticsSdPx2 / press.blur_px2 *
                          Eigen::Map<const Eigen::VectorXd>(weighted.blur_mm.data(), count);
  linear.residual.resize(count);
  linear.weight = Eigen::Map<const Eigen::VectorXd>(weighted.root_weight.data(), count);
  linear.bend = Eigen::Map<const Eigen::VectorXd>(weighted.bend.data(), count);
  // By rows, as the solver stores them.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Rows by_centre(count, 3), by_values(count, n_map), by_log_lift(count, 1);
  const double log_lift = fit.lift_mm > 0.0 ? std::log(fit.lift_mm) : 0.0;
  const double* at[] = {centre.data(), fit.curve.values().data(), &log_lift};
  double* jacobians[] = {by_centre.data(), by_values.data(), by_log_lift.data()};
  [[maybe_unused]] const bool is_evaluated =
      PressCost(weighted, fit.curve, options, fit.lift_mm > 0.0)
          .Evaluate(at, linear.residual.data(), jacobians);
  assert(is_evaluated);  // weight_samples() excludes samples without a residual
  linear.rows << by_values, by_centre, by_log_lift;
  for (const Sample* sample : weighted.samples) {
    linear.patch.push_back(disc.position_of(*sample).patch);
    linear.cell.emplace_back(std::lround(std::floor(sample->pixel.x() / press.block_px)),
                             std::lround(std::floor(sample->pixel.y() / press.block_px)));
  }
  const auto points = static_cast<Eigen::Index>(weighted.outline.size());
  Rows by_outline(points, 3);
  linear.outline_residual.resize(points);
  double* outline_jacobians[] = {by_outline.data()};
  if (points > 0)
    (void)OutlineCost(weighted).Evaluate(at, linear.outline_residual.data(), outline_jacobians);
  linear.outline_rows = by_outline;
  linear.depth_row.setZero();
  if (weighted.given_depth) {
    double residual = 0;
    double* by_depth[] = {linear.depth_row.data()};
    (void)GivenDepthCost(weighted).Evaluate(at, &residual, by_depth);
  }
  return linear;
}

/// Subtracts each ring's mean residual. The common error of a ring is a separate term.
void subtract_rings(Linear& linear) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(ContactDisc::kRings), weight2 = pull;
  const auto ring_of = [&](Eigen::Index k) {
    return linear.patch[static_cast<std::size_t>(k)] / ContactDisc::kSectors;
  };
  for (Eigen::Index k = 0; k < linear.residual.size(); ++k) {
    pull[ring_of(k)] += linear.weight[k] * linear.residual[k];
    weight2[ring_of(k)] += linear.weight[k] * linear.weight[k];
  }
  for (Eigen::Index k = 0; k < linear.residual.size(); ++k)
    linear.residual[k] -= linear.weight[k] * pull[ring_of(k)] / weight2[ring_of(k)];
  linear.taken = static_cast<double>((weight2.array() > 0.0).count()) + 2.0;  // and a tilt
}

/// Correlation of the residuals of neighbouring samples.
class NoiseCorrelation {
 public:
  void add(const Linear& linear) {
    if (linear.cell.empty()) return;
    auto [low, high] = std::pair(linear.cell.front(), linear.cell.front());
    for (const auto& [column, row] : linear.cell) {
      low = {std::min(low.first, column), std::min(low.second, row)};
      high = {std::max(high.first, column), std::max(high.second, row)};
    }
    Eigen::MatrixXd grid = Eigen::MatrixXd::Zero(high.first - low.first + 1 + 2 * kReach,
                                                 high.second - low.second + 1 + 2 * kReach);
    for (std::size_t k = 0; k < linear.cell.size(); ++k)
      grid(linear.cell[k].first - low.first + kReach, linear.cell[k].second - low.second + kReach) =
          linear.residual[static_cast<Eigen::Index>(k)];
    const Eigen::Index columns = grid.rows() - 2 * kReach, rows = grid.cols() - 2 * kReach;
    const auto middle = grid.block(kReach, kReach, columns, rows);
    for (Eigen::Index u = -kReach; u <= kReach; ++u)
      for (Eigen::Index v = -kReach; v <= kReach; ++v)
        products_ += middle.cwiseProduct(grid.block(kReach + u, kReach + v, columns, rows)).sum();
    squares_ += middle.squaredNorm();
    count_ += static_cast<double>(linear.cell.size());
    taken_ += linear.taken;
    taken_products_ += products_taken(linear, low, columns, rows);
  }

  /// How many samples count as one, at least 1.
  [[nodiscard]] double samples_as_one() const {
    if (!(squares_ > 0.0)) return 1.0;
    const double taken = std::min(0.5, taken_products_ / count_);
    return std::max(1.0, products_ / squares_ / (1.0 - taken));
  }
  /// Correction of the residuals' squares for the number of fitted parameters.
  [[nodiscard]] double dof_factor() const {
    return count_ / std::max(0.5 * count_, count_ - samples_as_one() * taken_);
  }

 private:
  /// What subtracting means has removed from the products: of each pair within a ring one over the
  /// ring's samples, and the same for the tilt and the mean of the press.
  static double products_taken(const Linear& linear, const std::pair<int, int>& low,
                               Eigen::Index columns, Eigen::Index rows) {
    Eigen::MatrixXi rings = Eigen::MatrixXi::Constant(columns + 2 * kReach, rows + 2 * kReach, -1);
    std::array<double, ContactDisc::kRings> samples{}, pairs{};
    for (std::size_t k = 0; k < linear.cell.size(); ++k) {
      const int ring = linear.patch[k] / ContactDisc::kSectors;
      rings(linear.cell[k].first - low.first + kReach,
            linear.cell[k].second - low.second + kReach) = ring;
      ++samples[static_cast<std::size_t>(ring)];
    }
    for (Eigen::Index u = kReach; u < columns + kReach; ++u)
      for (Eigen::Index v = kReach; v < rows + kReach; ++v)
        if (const int ring = rings(u, v); ring >= 0)
          pairs[static_cast<std::size_t>(ring)] += static_cast<double>(
              (rings.block<2 * kReach + 1, 2 * kReach + 1>(u - kReach, v - kReach).array() == ring)
                  .count());
    constexpr double kTilt = 2.0 * (2 * kReach + 1) * (2 * kReach + 1);
    double taken = kTilt;
    for (std::size_t ring = 0; ring < samples.size(); ++ring)
      if (samples[ring] > 0.0) taken += pairs[ring] / samples[ring];
    return taken;
  }

  static constexpr Eigen::Index kReach = 1;
  double products_ = 0, squares_ = 0, count_ = 0, taken_ = 0, taken_products_ = 0;
};

/// Sums over the patches of one press.
struct PatchSums {
  Eigen::MatrixXd rows;     // gradient by an offset of 1 mm, a patch each
  Eigen::MatrixXd lifted;   // gradient by the form of the lift-off
  Eigen::VectorXd pull;     // of weight * residual
  Eigen::VectorXd square;   // of its squares
  Eigen::VectorXd weight2;  // of weight^2
  explicit PatchSums(const Linear& linear)
      : rows(Eigen::MatrixXd::Zero(linear.rows.cols(), ContactDisc::kPatches)),
        lifted(rows),
        pull(Eigen::VectorXd::Zero(ContactDisc::kPatches)),
        square(pull),
        weight2(pull) {
    for (Eigen::Index k = 0; k < linear.rows.rows(); ++k) {
      const int p = linear.patch[static_cast<std::size_t>(k)];
      const double one = linear.weight[k] * linear.residual[k];
      const Eigen::VectorXd offset =
          linear.bend[k] * linear.weight[k] * linear.rows.row(k).transpose();
      rows.col(p) += offset;
      lifted.col(p) += linear.lifted_sd_mm[static_cast<std::size_t>(k)] * offset;
      pull[p] += one;
      square[p] += one * one;
      weight2[p] += linear.weight[k] * linear.weight[k];
    }
  }
};

/// The inverse of a positive definite matrix and its condition (may be null), by the scaled
/// eigenvalues; false when it is singular.
bool invert(const Eigen::MatrixXd& matrix, Eigen::MatrixXd* inverse, double* condition) {
  const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0.0)) return false;
  const Eigen::VectorXd unscale = scale.cwiseInverse();
  const auto eigen = symmetric_eigen(unscale.asDiagonal() * matrix * unscale.asDiagonal());
  const double smallest = eigen.eigenvalues().minCoeff();
  const double largest = eigen.eigenvalues().maxCoeff();
  if (!(smallest > 1e-14 * largest)) return false;
  if (condition != nullptr) *condition = std::sqrt(largest / smallest);
  *inverse = unscale.asDiagonal() *
             (eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() *
              eigen.eigenvectors().transpose()) *
             unscale.asDiagonal();
  return true;
}

/// Root mean square over rings of their mean residuals, common to all presses. Few rings are weak
/// evidence, so only a clear excess over the assumed error counts.
double ring_error_mm(const std::vector<const PressSamples*>& presses, const JointFit& fit,
                     const JointOptions& options) {
  const FitQuality quality = quality_of(presses, fit, options);
  const double shown_mm2 = std::pow(quality.ring_mm, 2) - std::pow(quality.scatter_mm, 2);
  const double ring_mm = shown_mm2 > 2.0 * kFloorMm * kFloorMm ? std::sqrt(shown_mm2) : kFloorMm;
  return options.zone > kInnerZone ? std::hypot(ring_mm, quality.scatter_mm) : ring_mm;
}

/// Adds one observation from elsewhere with its own stated error. `row`: its weighted derivative by
/// some unknowns, of which `first` is the first.
void add_known(const Eigen::VectorXd& row, Eigen::Index first, Eigen::MatrixXd* hessian,
               Eigen::MatrixXd* spread) {
  const Eigen::MatrixXd square = row * row.transpose();
  const auto n = row.size();
  hessian->block(first, first, n, n) += square;
  spread->block(first, first, n, n) += kRootWeightOfKnown * kRootWeightOfKnown * square;
}

/// ring_mm: error of the rings common to all presses; 0: no common error is included.
Eigen::MatrixXd spread_of(const std::vector<const PressSamples*>& presses, const JointFit& fit,
                          const JointOptions& options, double ring_mm, double* condition) {
  if (condition != nullptr) *condition = 0;
  const Eigen::Index n_map = fit.curve.values().size();
  const bool free_lift = lift_is_free(fit, options);
  const Eigen::Index n = n_map + 3 * static_cast<Eigen::Index>(presses.size()) + 1;
  const Eigen::Index first = options.fix_mapping ? n_map : 0;
  const Eigen::Index unknowns = n - first - (free_lift ? 0 : 1);
  std::vector<Linear> linear;
  std::vector<PatchSums> patches;
  NoiseCorrelation correlation;
  int observations = 0;
  double scatter = 0, by_noise = 0, reach = 0, patch_count = 0, taken = 0;
  for (std::size_t i = 0; i < presses.size(); ++i) {
    linear.push_back(linearised(*presses[i], fit, fit.centres_mm[i], options));
    subtract_rings(linear.back());
    taken += linear.back().taken;
    patches.emplace_back(linear.back());
    correlation.add(linear.back());
    patch_count += static_cast<double>((patches.back().weight2.array() > 0.0).count());
    observations += linear.back().outline_rows.rows() > 0;
  }
  observations += static_cast<int>(patch_count);
  if (observations <= unknowns) return {};
  const double as_one = correlation.samples_as_one();
  const double dof_factor = patch_count / std::max(0.5 * patch_count, patch_count - taken);
  for (const PatchSums& sums : patches) {
    scatter += dof_factor * sums.pull.squaredNorm();
    by_noise += correlation.dof_factor() * as_one * sums.square.sum();
    reach += sums.weight2.squaredNorm();
  }
  // Only the excess over chance counts: twice the standard deviation of a sum of squares.
  const double chance = 1.0 + 2.0 * std::sqrt(2.0 / std::max(1.0, patch_count));
  const double patch_mm2 = scatter > chance * by_noise ? (scatter - by_noise) / reach : 0.0;

  // Hessian of the robust loss, and the spread of its gradient by the errors.
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n, n), spread = hessian;
  Eigen::MatrixXd ring_pull = Eigen::MatrixXd::Zero(n, ContactDisc::kRings), lift_pull = ring_pull;
  Eigen::VectorXd optics_pull = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < presses.size(); ++i) {
    const Linear& press = linear[i];
    const PatchSums& sums = patches[i];
    // From (mapping, this centre) to all unknowns.
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n_map + 4);
    all.topLeftCorner(n_map, n_map).setIdentity();
    all.block<3, 3>(n_map + 3 * static_cast<Eigen::Index>(i), n_map).setIdentity();
    all(n - 1, n_map + 3) = 1.0;
    const Eigen::MatrixXd curved = press.rows.transpose() * press.bend.asDiagonal() * press.rows;
    Eigen::MatrixXd pulled =
        as_one * press.rows.transpose() * press.residual.cwiseAbs2().asDiagonal() * press.rows;
    pulled += patch_mm2 * sums.rows * sums.rows.transpose();
    optics_pull += all * (press.rows.transpose() *
                          (press.bend.cwiseProduct(press.weight).cwiseProduct(press.optics_sd_mm)));
    hessian += all * curved * all.transpose();
    spread += all * pulled * all.transpose();
    for (int p = 0; p < ContactDisc::kPatches; ++p) {
      ring_pull.col(p / ContactDisc::kSectors) += ring_mm * all * sums.rows.col(p);
      lift_pull.col(p / ContactDisc::kSectors) += all * sums.lifted.col(p);
    }
    // The outline is one more observation; its points share one error.
    const Eigen::Vector3d outline_pull = press.outline_rows.transpose() * press.outline_residual;
    const auto corner = n_map + 3 * static_cast<Eigen::Index>(i);
    hessian.block<3, 3>(corner, corner) += press.outline_rows.transpose() * press.outline_rows;
    spread.block<3, 3>(corner, corner) += outline_pull * outline_pull.transpose();
    add_known(press.depth_row, corner, &hessian, &spread);
  }
  if (options.shapes != nullptr)
    for (const KnownShape& shape : *options.shapes) {
      Eigen::VectorXd row(n_map);
      double residual = 0;
      const double* at[] = {fit.curve.values().data()};
      double* by_values[] = {row.data()};
      (void)ScaleCost(shape, fit.curve, options.along).Evaluate(at, &residual, by_values);
      add_known(row, 0, &hessian, &spread);
    }
  spread += ring_pull * ring_pull.transpose() + lift_pull * lift_pull.transpose();
  if (ring_mm > 0.0) spread += optics_pull * optics_pull.transpose();
  if (fit.curve.family().absorbs()) {
    // The prior of the absorption, with its own stated error.
    add_known(Eigen::VectorXd::Constant(1, kRootWeightOfKnown / kAbsorptionSd), 2, &hessian,
              &spread);
  }
  if (free_lift) {
    add_known(Eigen::VectorXd::Constant(1, kRootWeightOfKnown), n - 1, &hessian, &spread);
  }
  Eigen::MatrixXd inverse;
  if (!invert(hessian.block(first, first, unknowns, unknowns), &inverse, condition)) return {};
  const Eigen::MatrixXd free = inverse * spread.block(first, first, unknowns, unknowns) * inverse;
  const Eigen::Index known = first + unknowns;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(known, known);
  covariance.bottomRightCorner(unknowns, unknowns) = 0.5 * (free + free.transpose());
  return covariance;
}

}  // namespace

Eigen::MatrixXd covariance_of(const std::vector<const PressSamples*>& presses, const JointFit& fit,
                              const JointOptions& options, double* condition) {
  return spread_of(presses, fit, options, ring_error_mm(presses, fit, options), condition);
}

Eigen::MatrixXd chance_covariance_of(const std::vector<const PressSamples*>& presses,
                                     const JointFit& fit, const JointOptions& options) {
  return spread_of(presses, fit, options, 0.0, nullptr);
}

}  // namespace alltact
