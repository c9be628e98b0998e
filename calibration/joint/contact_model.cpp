#include "calibration/joint/contact_model.h"

#include "calibration/joint/joint_costs.h"
#include "calibration/joint/joint_fit.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace alltact {

// This file holds the computations for every sample and the loops over samples, because a
// calibration spends its time here.

namespace {

// cosine; lines that meet the ball flatter than this carry little information
constexpr double kGrazing = 0.25;
constexpr double kRobustAt = 2.0;  // standard deviations from which the loss is linear
constexpr double kTaper = 0.02;    // half width of the zone's soft border

/// Cosine of the angle at which a sample's line meets the ball; NaN where it misses. Along a
/// grazing line a small error across the ball's surface is a large one of depth.
double facing_of(const Sample& sample, MappingAlong along, const Eigen::Vector3d& centre,
                 double radius_mm) {
  const bool normal = along == MappingAlong::kNormal;
  const Eigen::Vector3d direction = normal ? sample.normal : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d from = (normal ? sample.untouched_n : sample.untouched_z) - centre;
  const double distance = from.cross(direction).norm();
  return std::sqrt((radius_mm - distance) * (radius_mm + distance)) / radius_mm;
}

/// Weights of the outline's points, robust against points on something else.
void weight_outline(const PressSamples& press, const Eigen::Vector3d& centre,
                    WeightedPress* weighted) {
  // Neighbouring samples share their errors: only a patch is one observation. The outline's points
  // are so far apart that each is one.
  const double each = std::sqrt(
      std::max(1.0, static_cast<double>(weighted->samples.size()) / ContactDisc::kPatches));
  for (const OutlinePoint& point : press.outline) {
    const double z =
        outline_angle_rad(point.direction, centre, press.ball_radius_mm) / point.sd_rad;
    if (!std::isfinite(z)) continue;
    weighted->outline.push_back(&point);
    weighted->outline_root_weight.push_back(
        each / (point.sd_rad * std::pow(1.0 + z * z / (kRobustAt * kRobustAt), 0.25)));
  }
  const auto count = static_cast<Eigen::Index>(weighted->outline.size());
  Eigen::VectorXd along_z(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    Eigen::Vector3d by_centre;
    (void)outline_angle_rad(weighted->outline[i]->direction, centre, press.ball_radius_mm,
                            &by_centre);
    along_z[k] = weighted->outline_root_weight[i] * by_centre.z();
  }
  const double length = along_z.norm();
  if (!(length > 0.0)) return;
  weighted->outline_along_z = along_z / length;
  weighted->outline_z_gain = 1.0 / std::hypot(1.0, length / each * kFaceSdMm);
}

}  // namespace

double ball_depth_mm(const Sample& sample, MappingAlong along, const Eigen::Vector3d& centre_mm,
                     double radius_mm, Eigen::Vector3d* by_centre) {
  const bool normal = along == MappingAlong::kNormal;
  const Eigen::Vector3d direction = normal ? sample.normal : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d from = (normal ? sample.untouched_n : sample.untouched_z) - centre_mm;
  // Back from the untouched point against `direction` to the far side of the ball.
  const double ahead = from.dot(direction);
  const Eigen::Vector3d aside = from - ahead * direction;
  const double distance = aside.norm();
  const double half2 = (radius_mm - distance) * (radius_mm + distance);
  if (!(half2 > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  const double half = std::sqrt(half2);
  const double scale = along == MappingAlong::kProjected ? sample.cos_incline : 1.0;
  if (by_centre != nullptr) *by_centre = scale * (aside / half - direction);
  return scale * (ahead + half);
}

double skin_depth_mm(const Sample& sample, MappingAlong along, const Eigen::Vector3d& centre_mm,
                     double radius_mm, const PressedPlane& plane, double lift_mm,
                     Eigen::Vector3d* by_centre, double* by_lift) {
  const double ball = ball_depth_mm(sample, along, centre_mm, radius_mm, by_centre);
  if (by_lift != nullptr) *by_lift = 0.0;
  if (!(lift_mm > 0.0) || !std::isfinite(ball)) return ball;
  const double per_normal = along == MappingAlong::kZ ? sample.cos_incline : 1.0;
  const SkinDepth skin =
      skin_depth(ball * per_normal, plane.height_mm(centre_mm), radius_mm, lift_mm);
  if (by_centre != nullptr)
    *by_centre = skin.by_ball * *by_centre + skin.by_height / per_normal * plane.normal;
  if (by_lift != nullptr) *by_lift = skin.by_lift / per_normal;
  return skin.mm / per_normal;
}

double blur_mm(const Sample& sample, const PressSamples& press, const CurveAt& curve,
               MappingAlong along, const Eigen::Vector3d& centre_mm, const PressedPlane& plane,
               double lift_mm) {
  const auto depth_of = [&](const Sample& there) {
    return skin_depth_mm(there, along, centre_mm, press.ball_radius_mm, plane, lift_mm);
  };
  const double depth = depth_of(sample);
  double laplacian = 0, slope2 = 0;
  for (const Eigen::Vector3d& step : {sample.by_u, sample.by_v}) {
    const auto at = [&](double pixels) {
      Sample there = sample;
      there.untouched_z += pixels * step;
      there.untouched_n += pixels * step;
      return depth_of(there);
    };
    const double before = at(-1), after = at(1);
    laplacian += before + after - 2 * depth;
    slope2 += std::pow(0.5 * (after - before), 2);
  }
  const double x = curve.inverse(depth, sample.unit_position, sample.x).x;
  const double h = 0.01 * curve.x_max(), slope = curve.slope_mm(x);
  const double bend = (curve.slope_mm(x + h) - curve.slope_mm(x - h)) / (2 * h);
  const double blur = 0.5 * press.blur_px2 * (laplacian - bend / (slope * slope) * slope2);
  return std::isfinite(blur) ? blur : 0.0;
}

namespace {

/// Misfit of a sample to the ball: slope (x - g(d)), the noise of x as depth, mm. NaN where the
/// ball or the curve gives none.
struct Misfit {
  double mm = 0;
  double slope_mm = 0;   ///< dM/dx where M gives the ball's depth
  double blur_mm = 0;    ///< see blur_mm()
  double lifted_mm = 0;  ///< distance of the skin from the ball, outside the contact
};
Misfit misfit_of(const Sample& sample, const PressSamples& press, const CurveAt& curve,
                 MappingAlong along, const Eigen::Vector3d& centre_mm, const PressedPlane& plane,
                 double lift_mm) {
  const double depth =
      skin_depth_mm(sample, along, centre_mm, press.ball_radius_mm, plane, lift_mm);
  const double blur = blur_mm(sample, press, curve, along, centre_mm, plane, lift_mm);
  const auto [x, slope_mm] = curve.inverse(depth + blur, sample.unit_position, sample.x);
  Misfit misfit{slope_mm * (sample.x - x), slope_mm, blur, 0.0};
  if (lift_mm > 0.0)
    misfit.lifted_mm =
        depth - std::max(ball_depth_mm(sample, along, centre_mm, press.ball_radius_mm), 0.0);
  return misfit;
}

}  // namespace

ContactDisc::ContactDisc(const PressSamples& press, MappingAlong along,
                         const Eigen::Vector3d& centre_mm)
    : along_(along),
      centre_mm_(centre_mm),
      radius_mm_(press.ball_radius_mm),
      plane_(plane_below(press, centre_mm)) {
  // Height over the face's plane there, so that a middle beyond the face's edge counts as well.
  const double height = press.samples.empty() ? radius_mm_ : plane_.height_mm(centre_mm);
  // A ball without contact retains a tiny rim, so that a fit can recover.
  rim2_ = std::max((radius_mm_ - height) * (radius_mm_ + height), 1e-3 * radius_mm_ * radius_mm_);
}

ContactDisc::Position ContactDisc::position_of(const Sample& sample) const {
  const bool normal = along_ == MappingAlong::kNormal;
  const double depth = ball_depth_mm(sample, normal ? MappingAlong::kNormal : MappingAlong::kZ,
                                     centre_mm_, radius_mm_);
  if (!std::isfinite(depth)) return {std::numeric_limits<double>::infinity(), kPatches - 1};
  Eigen::Vector3d contact_point = normal ? sample.untouched_n : sample.untouched_z;
  contact_point -= depth * (normal ? sample.normal : Eigen::Vector3d(0.0, 0.0, 1.0));
  const Eigen::Vector3d from = contact_point - centre_mm_;
  const Eigen::Vector3d aside = from - from.dot(sample.normal) * sample.normal;
  Position position{std::sqrt(aside.squaredNorm() / rim2_), 0};
  int ring = 0;
  while (ring + 1 < kRings && position.radius > kRingRadius[ring]) ++ring;
  const double turn = (std::atan2(aside.y(), aside.x()) + M_PI) / (2.0 * M_PI);
  position.patch = ring * kSectors + std::min(kSectors - 1, static_cast<int>(turn * kSectors));
  return position;
}

WeightedPress weight_samples(const PressSamples& press, const JointFit& fit,
                             const Eigen::Vector3d& centre, const JointOptions& options) {
  const ContactDisc disc(press, options.along, centre);
  const CurveAt curve = fit.curve.at();
  WeightedPress weighted;
  weighted.plane = disc.plane();
  weighted.ball_radius_mm = press.ball_radius_mm;
  weighted.given_depth = press.given_depth;
  std::vector<double> normed, taper, sigma;
  for (const Sample& sample : press.samples) {
    const double inside =
        (options.zone + kTaper - disc.position_of(sample).radius) / (2.0 * kTaper);
    if (!(inside > 0.0)) continue;
    const double facing = facing_of(sample, options.along, centre, press.ball_radius_mm);
    if (!(facing > kGrazing)) continue;
    const Misfit misfit =
        misfit_of(sample, press, curve, options.along, centre, weighted.plane, fit.lift_mm);
    if (!std::isfinite(misfit.mm)) continue;
    const double lifted_sd = kLiftPart * misfit.lifted_mm;
    const double sd = std::hypot(misfit.slope_mm * press.x_sd, kFloorMm, lifted_sd);
    weighted.lifted_sd_mm.push_back(lifted_sd);
    weighted.samples.push_back(&sample);
    weighted.blur_mm.push_back(misfit.blur_mm);
    weighted.slope_mm.push_back(misfit.slope_mm);
    taper.push_back(std::min(1.0, inside));
    sigma.push_back(sd);
    normed.push_back(misfit.mm / sd);
  }
  std::vector<double> sizes;
  sizes.reserve(normed.size());
  for (const double z : normed) sizes.push_back(std::abs(z));
  const double scale = std::max(1.0, 1.4826 * upper_median(sizes));
  for (std::size_t i = 0; i < normed.size(); ++i) {
    const double z = normed[i] / (scale * kRobustAt);
    const double weight = taper[i] / std::sqrt(1.0 + z * z);
    weighted.root_weight.push_back(std::sqrt(weight) / (sigma[i] * scale));
    weighted.bend.push_back(1.0 / (1.0 + z * z));
  }
  weight_outline(press, centre, &weighted);
  return weighted;
}

FitQuality quality_of(const std::vector<const PressSamples*>& presses, const JointFit& fit,
                      const JointOptions& options) {
  FitQuality quality;
  const CurveAt curve = fit.curve.at();
  struct Patch {
    double sum = 0, lifted = 0;
    int count = 0;
  };
  std::vector<std::vector<double>> ring_values(ContactDisc::kRings);
  std::vector<double> ring_scatter;
  double lifted2 = 0;
  int lifted_rings = 0;
  for (std::size_t i = 0; i < presses.size(); ++i) {
    const ContactDisc disc(*presses[i], options.along, fit.centres_mm[i]);
    std::vector<Patch> patches(ContactDisc::kPatches);
    double absolute = 0;
    int count = 0;
    for (const Sample& sample : presses[i]->samples) {
      const ContactDisc::Position position = disc.position_of(sample);
      if (!(position.radius <= options.zone)) continue;
      const Misfit misfit = misfit_of(sample, *presses[i], curve, options.along, fit.centres_mm[i],
                                      disc.plane(), fit.lift_mm);
      if (!std::isfinite(misfit.mm)) continue;
      absolute += std::abs(misfit.mm);
      ++count;
      Patch& patch = patches[static_cast<std::size_t>(position.patch)];
      patch.sum += misfit.mm;
      patch.lifted += kLiftPart * misfit.lifted_mm;
      ++patch.count;
    }
    quality.residual_mm.push_back(count > 0 ? absolute / count : 0.0);
    for (int ring = 0; ring < ContactDisc::kRings; ++ring) {
      std::vector<double> means;
      double lifted = 0;
      for (int sector = 0; sector < ContactDisc::kSectors; ++sector) {
        const Patch& patch = patches[static_cast<std::size_t>(
            std::ptrdiff_t{ring} * ContactDisc::kSectors + sector)];
        if (patch.count < 2) continue;
        means.push_back(patch.sum / patch.count);
        lifted += patch.lifted / patch.count;
      }
      if (means.size() < 3) continue;
      const auto n = static_cast<double>(means.size());
      lifted2 += lifted * lifted / (n * n);
      ++lifted_rings;
      double mean = 0;
      for (const double m : means) mean += m / n;
      double variance = 0;
      for (const double m : means) variance += (m - mean) * (m - mean) / (n - 1.0);
      ring_values[static_cast<std::size_t>(ring)].push_back(mean);
      ring_scatter.push_back(variance / n);
    }
  }
  // A ring's mean over all presses: their common residual is the skin leaving the ball.
  double sum = 0;
  for (const auto& values : ring_values) {
    if (values.empty()) continue;
    double mean = 0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    sum += mean * mean;
    ++quality.rings;
  }
  if (lifted_rings > 0) quality.lifted_sd_mm = std::sqrt(lifted2 / lifted_rings);
  if (quality.rings > 0) {
    quality.ring_mm = std::sqrt(sum / quality.rings);
    double scatter = 0;
    for (const double v : ring_scatter) scatter += v;
    quality.scatter_mm = std::sqrt(scatter / static_cast<double>(ring_scatter.size()) /
                                   static_cast<double>(presses.size()));
  }
  return quality;
}

PressedPlane plane_below(const PressSamples& press, const Eigen::Vector3d& centre_mm) {
  const Sample* nearest = nearest_sample(press, centre_mm);
  return nearest == nullptr ? PressedPlane{} : PressedPlane{nearest->untouched_n, nearest->normal};
}

double contact_radius_mm(double rim2_mm2, double lift_mm) {
  return rim2_mm2 / (std::sqrt(lift_mm * lift_mm + rim2_mm2) + lift_mm);
}

double half_space_tail(double q) {
  return 2.0 / M_PI * ((2.0 - q * q) * std::asin(1.0 / q) + std::sqrt(q * q - 1.0));
}

SkinDepth skin_depth(double ball_mm, double height_mm, double radius_mm, double lift_mm) {
  const double rim2 = (radius_mm - height_mm) * (radius_mm + height_mm);
  if (!(lift_mm > 0.0) || !(rim2 > 0.0)) return {ball_mm};
  const double up = ball_mm + height_mm;  // of the ball's surface below its centre
  const double contact = contact_radius_mm(rim2, lift_mm);
  const double root = contact + lift_mm;
  const double rho2 = (radius_mm - up) * (radius_mm + up);
  if (rho2 <= contact * contact || !(radius_mm > contact)) return {ball_mm};
  const double rho = std::sqrt(rho2);
  const double up_there = std::sqrt((radius_mm - contact) * (radius_mm + contact));
  const double depth_there = up_there - height_mm;
  const double left = std::exp(-(rho - contact) / lift_mm);
  // Derivatives of a and of rho.
  const double contact_by_height = -height_mm / root, contact_by_lift = lift_mm / root - 1.0;
  const double rho_by_up = -up / rho, there_by_contact = -contact / up_there;
  SkinDepth skin;
  skin.mm = depth_there * left;
  skin.by_ball = -skin.mm * rho_by_up / lift_mm;
  skin.by_height = left * (there_by_contact * contact_by_height - 1.0) -
                   skin.mm * (rho_by_up - contact_by_height) / lift_mm;
  skin.by_lift = left * there_by_contact * contact_by_lift + skin.mm * contact_by_lift / lift_mm +
                 skin.mm * (rho - contact) / (lift_mm * lift_mm);
  return skin;
}

}  // namespace alltact
