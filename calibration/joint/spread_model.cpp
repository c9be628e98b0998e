#include "calibration/joint/spread_model.h"

#include "calibration/joint/contact_model.h"
#include "core/sensing/depth/light_spread.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/depth/unrolled_face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace alltact {
namespace {

constexpr int kSamplesAround = 500;   // a press
constexpr double kReachLayers = 4.0;  // beyond the rim of a contact
constexpr double kMaxReachMm = 14.0;  // of samples from the contact's middle
constexpr double kModelPart = 0.01;   // of x: what the formulas of light_spread.h leave
constexpr double kModelFloor = 0.0015;
constexpr double kCorrelatedLayers2 = 3.0;  // squared thicknesses for one observation
constexpr double kTypicalFadeMm = 2.4;

double blur_mm(const SpreadPress& press, double log_blur) {
  const double lens_px2 = kOpticsPx2 * std::exp(std::clamp(log_blur, -3.0, 3.0));
  return std::sqrt((press.blur_px2 - kOpticsPx2 + lens_px2) * press.mm2_per_px2);
}

std::optional<Eigen::Vector2d> face_position(const FaceShape& shape,
                                             const Eigen::Vector3d& view_point) {
  const auto pixel = shape.camera().project(view_point);
  if (!pixel) return std::nullopt;
  return shape.position_mm(pixel->x(), pixel->y());
}

/// Change of the normal's direction per mm along the face.
double curvature_at(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  constexpr double kCurvatureStepPx = 12.0;
  const auto before = shape.at(pixel.x() - kCurvatureStepPx, pixel.y()),
             after = shape.at(pixel.x() + kCurvatureStepPx, pixel.y());
  if (!before || !after) return 0.0;
  const Eigen::Vector3d step = after->view_point_mm - before->view_point_mm;
  return (after->normal - before->normal).dot(step) / step.squaredNorm();
}

SpreadSample spread_sample(const Sample& sample, const SightInLayer& sight, bool base_at_low_u) {
  SpreadSample made;
  made.position_mm = sample.position_mm;
  made.sight_mm = sight.displacement_mm;
  const Eigen::Vector3d off = sample.untouched_z - sample.untouched_n;
  const double along = (off - off.dot(sample.normal) * sample.normal).norm();
  made.z_mm = {(sample.normal.x() < 0) == base_at_low_u ? along : -along, 0.0};
  made.cos_sight = sight.cos_sight;
  made.x = sample.x;
  return made;
}

SkinForm skin_form(Bed bed, const Eigen::VectorXd& shared) {
  SkinForm form;
  form.bed = bed;
  form.lift_mm = std::exp(std::clamp(shared[kLogReturn], -4.0, 1.0));
  form.fade_mm = std::exp(std::clamp(shared[kLogReturn], -1.0, 7.0));
  form.lift_power = std::clamp(shared[kLiftPower], -0.5, 1.5);
  for (int i = 0; i < 3; ++i) form.rise[static_cast<std::size_t>(i)] = shared[kRise + i];
  form.rise_power = std::clamp(shared[kRisePower], 0.0, 2.5);
  return form;
}

}  // namespace

const SpreadSample& SpreadPress::nearest_to(const Eigen::Vector2d& position_mm) const {
  return *std::min_element(samples.begin(), samples.end(),
                           [&](const SpreadSample& a, const SpreadSample& b) {
                             return (a.position_mm - position_mm).squaredNorm() <
                                    (b.position_mm - position_mm).squaredNorm();
                           });
}

std::optional<SpreadPress> spread_press(const Press& press, const Face& face,
                                        const Eigen::Vector3d& centre_mm) {
  constexpr std::size_t kLeastSamples = 50;
  constexpr double kLightSd = 0.01;
  const auto contact = ball_on_face(press.shape, face, centre_mm, press.ball_radius_mm);
  if (!contact || !(contact->depth_mm > 0)) return std::nullopt;
  const Eigen::Vector3d view_point = contact->middle_mm - face.layer_mm * contact->normal;
  const auto pixel = press.shape.camera().project(view_point);
  const auto position = face_position(press.shape, view_point);
  if (!pixel || !position) return std::nullopt;
  SpreadPress made;
  made.radius_mm = press.ball_radius_mm;
  made.curvature_per_mm = curvature_at(press.shape, *pixel);
  made.given_depth = press.given_depth;
  // Where a finger's bend moves its tip relative to the lamps, a change of the light is not as
  // smooth as light_gain.h assumes.
  if (face.kind == FaceKind::kFinRay) made.light_sd = kLightSd;
  made.start << *position, std::log(std::clamp(contact->depth_mm, 0.05, 0.9 * face.layer_mm)), 0.0;
  const double reach = std::min(kMaxReachMm, contact->radius_mm + kReachLayers * face.layer_mm);
  const PressSamples around = sample_around(press, face, contact->middle_mm, reach, kSamplesAround);
  double area_mm2 = 0;
  for (const Sample& sample : around.samples) {
    const auto sight = sight_in_layer(press.shape, sample.pixel.x(), sample.pixel.y());
    if (!sight) continue;
    SpreadSample one = spread_sample(sample, *sight, press.shape.base_at_low_u());
    one.sd = std::hypot(around.x_sd, std::hypot(kModelFloor, kModelPart * sample.x));
    made.mm2_per_px2 += 0.5 * (sample.by_u.squaredNorm() + sample.by_v.squaredNorm());
    area_mm2 += sample.by_u.cross(sample.by_v).norm() * around.block_px * around.block_px;
    made.reach_mm =
        std::max(made.reach_mm, (one.position_mm - *position).norm() + one.sight_mm.norm());
    made.samples.push_back(one);
  }
  if (made.samples.size() < kLeastSamples) return std::nullopt;
  made.mm2_per_px2 /= static_cast<double>(made.samples.size());
  made.blur_px2 = around.blur_px2;
  made.observations =
      std::max(8.0, area_mm2 / (kCorrelatedLayers2 * face.layer_mm * face.layer_mm));
  made.reach_mm += 1.0;
  return made;
}

UnknownPrior prior_of(int shared, Hypothesis hypothesis) {
  const bool is_half_space = hypothesis.bed == Bed::kHalfSpace;
  switch (shared) {
    case kLogRho:
      return {std::log(0.97), 0.5};
    case kLogB:
      return {0.0, 1.5};
    case kLogBAlong:  // of spread light: what the lamps do otherwise than light_spread.h has it
      return {0.0, hypothesis.seen == SeenAt::kSpread ? 0.2 : 0.4};
    case kLogReturn:
      return is_half_space ? UnknownPrior{std::log(kTypicalFadeMm), 2.0}
                           : UnknownPrior{std::log(kTypicalLiftMm), 1.0};
    case kLiftPower:
      return {0.0, 0.5};
    case kRisePower:
      return {1.0, 0.5};
    case kLogBlur:  // 0.1 to 0.9 px^2
      return {-0.5, 0.6};
    case kLogOpticalThickness:
      return {std::log(0.6), 0.8};
    case kLogWidth:
      return {0.0, 0.12};
    default:
      return {0.0, 0.04};  // rises
  }
}

CurvePrior rho_prior(double optical_thickness) {
  constexpr double kFormulaSd = 0.025;
  constexpr double kCoat = 0.01, kCoatSd = 0.015;  // part of the light that the outside gives back
  const double black = 0.98 - 0.016 * optical_thickness;
  const double by_coat = 2.0 / std::pow(optical_thickness, 1.3);
  const double coat_sd = by_coat * kCoatSd, sd = std::hypot(kFormulaSd, coat_sd);
  return {std::log(black) + by_coat * kCoat,
          -0.016 * optical_thickness / black - 1.3 * by_coat * kCoat, sd,
          -1.3 * coat_sd * coat_sd / sd};
}

CurvePrior b_prior(double optical_thickness) {
  constexpr double kAbsorbed = 0.01, kAbsorbedSd = 0.01;
  // 1 / cos of the light less 1, where sight is along the normal: lamps stand next to the camera.
  constexpr double kLonger = 0.15, kLongerSd = 0.25;
  constexpr double kLeast = 0.02;  // thin layers' b may be below 0
  const auto log_b = [](double t, double* sd) {
    const double by_light = 0.47 * t * std::exp(-0.35 * t), by_absorbed = 2.7 * std::pow(t, 1.5);
    const double b =
        std::expm1(0.248 * std::pow(t, 1.05) - 0.08 + kLonger * by_light + kAbsorbed * by_absorbed);
    const double smooth = 0.5 * (b + std::hypot(b, 2.0 * kLeast));
    *sd = std::hypot(kLongerSd * by_light, kAbsorbedSd * by_absorbed) * (1.0 + smooth) / smooth;
    return std::log(smooth);
  };
  constexpr double kStep = 1e-3;  // of the logarithm of t
  CurvePrior prior{};
  double sd_up = 0, sd_down = 0;
  const double up = log_b(optical_thickness * std::exp(kStep), &sd_up),
               down = log_b(optical_thickness * std::exp(-kStep), &sd_down);
  prior.mean = log_b(optical_thickness, &prior.sd);
  prior.mean_by_log = 0.5 * (up - down) / kStep;
  prior.sd_by_log = 0.5 * (sd_up - sd_down) / kStep;
  return prior;
}

SpreadModel::SpreadModel(std::vector<SpreadPress> presses, double layer_mm)
    : presses_(std::move(presses)), layer_mm_(layer_mm) {
  const auto [first, last] = std::minmax_element(
      presses_.begin(), presses_.end(),
      [](const SpreadPress& a, const SpreadPress& b) { return a.start[0] < b.start[0]; });
  middle_mm_ = 0.5 * (first->start[0] + last->start[0]);
  half_mm_ = std::max(0.5 * (last->start[0] - first->start[0]), 1.0);
}

LightSpread SpreadModel::spread_by(const Eigen::VectorXd& shared) const {
  LightSpread spread;
  spread.optical_thickness =
      std::clamp(std::exp(shared[kLogOpticalThickness]), 0.01, LightSpread::kMaxOpticalThickness);
  spread.width_factor =
      std::clamp(std::exp(shared[kLogWidth]), LightSpread::kMinWidth, LightSpread::kMaxWidth);
  spread.b_straight = std::exp(std::clamp(shared[kLogB], -6.0, 4.0));
  spread.log_b_along = std::clamp(shared[kLogBAlong], -3.0, 3.0);
  spread.middle_mm = middle_mm_;
  spread.half_mm = half_mm_;
  return spread;
}

FitState SpreadModel::start() const {
  FitState start;
  for (int i = 0; i < kSharedCount; ++i)
    start.shared[i] = prior_of(i, {SeenAt::kSpread, Bed::kMembrane}).mean;
  for (const SpreadPress& press : presses_) start.own.push_back(press.start);
  return start;
}

void SpreadModel::predict(std::size_t index, Hypothesis hypothesis, const Eigen::VectorXd& shared,
                          const OwnUnknowns& own, Eigen::VectorXd* x) const {
  constexpr double kNearPole = 0.1;
  const SpreadPress& press = presses_[index];
  const bool is_spread = hypothesis.seen == SeenAt::kSpread;
  const RoundContact contact{press.radius_mm, press.curvature_per_mm, layer_mm_,
                             std::exp(std::min(own[kLogDepth], 2.0))};
  const RadialProfile depth =
      skin_profile(contact, skin_form(hypothesis.bed, shared), press.reach_mm)
          .blurred(blur_mm(press, shared[kLogBlur]));
  const LightSpread spread = spread_by(shared);
  const SpreadSample& nearest = press.nearest_to(own.head<2>());
  const double b = b_at(spread, own[kAlong], is_spread ? nearest.cos_sight : 1.0);
  const double thickness = std::exp(shared[kLogRho]) * layer_mm_;
  const auto on_curve = [&](double depth_mm) {
    return depth_mm / std::max(kNearPole * thickness, thickness * (1.0 + b) - b * depth_mm);
  };
  const double stretch = 1.0 + layer_mm_ * press.curvature_per_mm;
  const auto distance = [&](const Eigen::Vector2d& at) {
    const double along = stretch * (at.x() - own[kAlong]), across = at.y() - own[kAcross];
    return std::sqrt(along * along + across * across);  // of millimetres: hypot takes long
  };
  // Depth of the skin where a line that is displaced like this through the layer meets it.
  const auto depth_met = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& displacement) {
    const auto depth_at = [&](double part) {
      return depth.at(distance(from + part * displacement)) / layer_mm_;
    };
    // Nearest to the axis the skin above the line is deepest.
    const double nearest_part =
        displacement.dot(own.head<2>() - from) / std::max(displacement.squaredNorm(), 1e-12);
    const double deepest = depth_at(std::clamp(nearest_part, 1.0 - depth[0] / layer_mm_, 1.0));
    return (1.0 - meeting_part(depth_at, deepest)) * layer_mm_;
  };
  const auto local_depth = [&](SeenAt seen, const SpreadSample& sample) {
    const Eigen::Vector2d& at = sample.position_mm;
    switch (seen) {
      case SeenAt::kZ:
        return depth_met(at, sample.z_mm);
      case SeenAt::kSight:
        return depth_met(at, sample.sight_mm);
      case SeenAt::kOuterZ:
        return depth.at(distance(at + sample.z_mm));
      case SeenAt::kOuterSight:
        return depth.at(distance(at + sample.sight_mm));
      default:
        return depth.at(distance(at));
    }
  };
  const double light = press.light_sd * own[kLight];
  const auto under_light = [&](double x_alone) { return x_alone + light * (1.0 - x_alone); };
  x->resize(static_cast<Eigen::Index>(press.samples.size()));
  Eigen::Index k = 0;
  if (!is_spread) {
    for (const SpreadSample& sample : press.samples)
      (*x)[k++] = under_light(on_curve(local_depth(hypothesis.seen, sample)));
    return;
  }
  RadialProfile lost_even = depth;
  const double around = 1.0 - oblique_spread(spread, nearest.cos_sight).core;
  for (int i = 0; i < RadialProfile::kCount; ++i) lost_even[i] = around * on_curve(depth[i]);
  const RadialProfile skirt = lost_even.skirt_lost(skirt_width_mm(spread, layer_mm_));
  for (const SpreadSample& sample : press.samples) {
    const ObliqueSpread oblique = oblique_spread(spread, sample.cos_sight);
    const double y_met = on_curve(depth_met(sample.position_mm, sample.sight_mm));
    const double lost =
        skirt.at(distance(sample.position_mm + oblique.skirt_shift * sample.sight_mm));
    (*x)[k++] = under_light(seen_difference(y_met, lost, oblique.core));
  }
}

}  // namespace alltact
