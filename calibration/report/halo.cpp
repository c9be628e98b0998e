#include "calibration/report/halo.h"

#include "calibration/joint/lift_off.h"
#include "calibration/presses/press_samples.h"
#include "core/finger/mapping.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace alltact {
namespace {

// Rings, mm outside the rim of the ball's cap. The nearer lies beyond the rounding of the rim by
// optics and skin; both lie within the skirt of scattered light.
constexpr double kNearFromMm = 0.5, kNearToMm = 1.0, kFarFromMm = 1.5, kFarToMm = 2.0;
constexpr int kRingSamples = 4000;
constexpr int kMinRingSamples = 30;
// References have an error of some hundredths of a grey level's depth: less is no halo.
constexpr double kMinHaloMm = 0.012;
constexpr double kSignificant = 2.5;  // standard errors: chance in one of 100 with few presses
// From ring to ring light decays to between a half and a tenth (skirts of 0.6 to 1.5 mm). An
// unfaded half space decays to two thirds, and skin that bulges changes its sign.
constexpr double kFallsTo = 0.5, kFallsNoFurther = 0.08;
// A bonded layer fades a half space's skirt within a part of its thickness.
constexpr double kFadePart = 0.25;

/// Depth of an elastic half space at q = r / a > 1, as a part of that at the contact's edge.
double half_space_tail(double q) {
  return 2.0 / M_PI * ((2.0 - q * q) * std::asin(1.0 / q) + std::sqrt(q * q - 1.0));
}

struct Rings {
  double near_mm = 0, far_mm = 0, skin_mm = 0;
};

/// nullopt: too little of a ring is visible.
std::optional<Rings> rings_of(const Press& press,
                              const Face& face,
                              const Mapping& mapping,
                              const BallFit& ball) {
  const double radius_mm = press.ball_radius_mm;
  const PressSamples samples =
      sample_around(press, face, ball.centre_mm, radius_mm + 1.5 * kFarToMm, kRingSamples);
  const PressedPlane plane = plane_below(samples, ball.centre_mm);
  const double depth_mm = radius_mm - plane.height_mm(ball.centre_mm);
  if (!(depth_mm > 0)) return std::nullopt;
  const double rim_mm = std::sqrt(std::max(0.0, depth_mm * (2 * radius_mm - depth_mm)));
  const double a_mm = std::sqrt(radius_mm * depth_mm);
  const double at_edge_mm =
      std::sqrt(std::max(0.0, radius_mm * radius_mm - a_mm * a_mm)) - (radius_mm - depth_mm);
  Rings rings;
  int near = 0, far = 0;
  for (const Sample& sample : samples.samples) {
    const Eigen::Vector3d from = sample.untouched_n - ball.centre_mm;
    const double r_mm = (from - from.dot(plane.normal) * plane.normal).norm();
    const double outside_mm = r_mm - rim_mm;
    const bool is_near = outside_mm >= kNearFromMm && outside_mm <= kNearToMm;
    const bool is_far = outside_mm >= kFarFromMm && outside_mm <= kFarToMm;
    if (!is_near && !is_far) continue;
    const double factor = mapping.parameters().variation.at(sample.position_mm);
    const double read_mm =
        factor * (sample.x < 0 ? mapping.slope_mm(0) * sample.x : mapping.depth_mm(sample.x));
    if (!std::isfinite(read_mm)) continue;
    (is_near ? rings.near_mm : rings.far_mm) += read_mm;
    ++(is_near ? near : far);
    if (is_near)
      rings.skin_mm += at_edge_mm * half_space_tail(r_mm / a_mm) *
                       std::exp(-(r_mm - a_mm) / (kFadePart * face.layer_mm));
  }
  if (near < kMinRingSamples || far < kMinRingSamples) return std::nullopt;
  rings.near_mm /= near;
  rings.skin_mm /= near;
  rings.far_mm /= far;
  return rings;
}

}  // namespace

Halo measure_halo(const std::vector<const Press*>& presses,
                  const Face& face,
                  const Calibration& calibration) {
  Halo halo;
  const auto mapping = Mapping::create(calibration.mapping);
  if (!mapping) return halo;
  std::vector<double> excess_mm;
  for (const BallFit& ball : calibration.balls) {
    const auto press = std::find_if(
        presses.begin(), presses.end(), [&](const Press* one) { return one->name == ball.press; });
    if (press == presses.end()) continue;
    const auto rings = rings_of(**press, face, *mapping, ball);
    if (!rings) continue;
    halo.near_mm += rings->near_mm;
    halo.far_mm += rings->far_mm;
    excess_mm.push_back(rings->near_mm - rings->skin_mm);
  }
  halo.presses = static_cast<int>(excess_mm.size());
  if (excess_mm.empty()) return halo;
  const double n = halo.presses;
  halo.near_mm /= n;
  halo.far_mm /= n;
  for (const double excess : excess_mm) halo.excess_mm += excess / n;
  if (excess_mm.size() < 2) return halo;
  double squares = 0;
  for (const double excess : excess_mm)
    squares += (excess - halo.excess_mm) * (excess - halo.excess_mm);
  halo.excess_sd_mm = std::sqrt(squares / (n - 1) / n);
  halo.is_seen = halo.excess_mm > kMinHaloMm && halo.excess_mm > kSignificant * halo.excess_sd_mm &&
                 halo.far_mm < kFallsTo * halo.near_mm &&
                 halo.far_mm > kFallsNoFurther * halo.near_mm;
  return halo;
}

}  // namespace alltact
