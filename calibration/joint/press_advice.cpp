#include "calibration/joint/press_advice.h"

#include "core/numerics/philox.h"
#include "core/numerics/symmetric_eigen.h"

#include <algorithm>
#include <array>
#include <cmath>

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
double depth_sd_mm(const std::vector<const PressSamples*>& presses,
                   const JointFit& fit,
                   const JointOptions& options) {
  const Eigen::MatrixXd covariance = covariance_of(presses, fit, options).covariance;
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
PressSamples simulated_press(const PressSamples& like,
                             const MappingCurve& curve,
                             const Eigen::Vector3d& centre,
                             const JointOptions& options,
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
          nearest->position_mm,
          nearest->normal};
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
      weakest.is_scale ? en::say(
                             "least certain is the scale: all depths may be too large or too small "
                             "together, by {:.3f} mm at {:.2f} mm (one standard deviation)",
                             weakest.sd_mm,
                             weakest.depth_mm)
                       : en::say(
                             "least certain is how shallow and deep go together: by {:.3f} mm at "
                             "{:.2f} mm (one standard deviation), the other way at the other end",
                             weakest.sd_mm,
                             weakest.depth_mm);
  return weakest;
}

std::optional<RadiusSensitivity> vary_radius(const std::vector<const PressSamples*>& presses,
                                             const JointFit& fit,
                                             const JointOptions& options,
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
      "a ball 1 % larger than said makes depths {:.1f} % {}; the residual is {:.4f} mm "
      "with a radius 1 % smaller, {:.4f} mm as given, {:.4f} mm with one 1 % larger",
      100.0 * std::abs(sensitivity.depth_part),
      other,
      sensitivity.smaller_mm,
      sensitivity.given_mm,
      sensitivity.larger_mm);
  sensitivity.sentence =
      en::at(figures,
             sensitivity.is_seen ? en::say("a wrong radius would be noticed")
                                 : en::say("the presses cannot show a wrong radius, so measure "
                                           "the ball to a hundredth of a millimetre"));
  return sensitivity;
}

PressAdvice advise(const std::vector<const PressSamples*>& presses,
                   const JointFit& fit,
                   const JointOptions& options,
                   double face_length_mm) {
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
    advice.sentence = en::say("press next: at another place, 0.5 to 1 mm deep");
  } else if (empty >= 0.0) {
    advice.along_mm = empty;
    advice.across_mm = 0;
    advice.sentence = en::say(
        "press next: {}, {:.1f} mm deep; no press tells whether the mapping holds in that third",
        position_text(empty, 0),
        advice.depth_mm);
  } else {
    advice.enough = advice.sd_then_mm > (1.0 - kMinGain) * advice.sd_now_mm;
    advice.sentence =
        advice.enough
            ? en::say(
                  "enough: one press more would take the standard deviation of depth from "
                  "{:.4f} mm to {:.4f} mm at best",
                  advice.sd_now_mm,
                  std::min(advice.sd_now_mm, advice.sd_then_mm))
            : en::say(
                  "press next: {}, {:.1f} mm deep; that would take the standard deviation "
                  "of depth from {:.4f} mm to {:.4f} mm",
                  position_text(advice.along_mm, advice.across_mm),
                  advice.depth_mm,
                  advice.sd_now_mm,
                  advice.sd_then_mm);
  }
  return advice;
}

}  // namespace alltact
