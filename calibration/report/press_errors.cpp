#include "calibration/report/press_errors.h"

#include "calibration/joint/contact_model.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/presses/press.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/mapping.h"
#include "core/numerics/median.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/depth/depth_sd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kSamples = 800;  // for each press: a compromise of detail and drawing time

double face_width_mm(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  if (shape.face().kind == FaceKind::kFinRay) return shape.face().width_mm;
  const auto area = shape.pixel_area(pixel.x(), pixel.y());
  return area ? std::sqrt(area->on_face_mm2) * shape.camera().size().height : 0.0;
}

/// nullopt: nothing lies under the ball.
std::optional<PressResiduals> residuals_of(const Press& press, const Face& face,
                                           const Mapping& mapping, const BallFit& ball) {
  const double radius_mm = press.ball_radius_mm;
  const MappingAlong along = mapping.parameters().along;
  const PressSamples around =
      sample_around(press, face, ball.centre_mm, 1.06 * radius_mm, kSamples);
  const ContactDisc disc(around, along, ball.centre_mm);
  const MappingCurve curve = curve_of(mapping.parameters());
  PressResiduals result;
  result.press = press.name;
  const Sample* nearest = nullptr;
  double nearest_rim = 2.0;
  for (const Sample& sample : around.samples) {
    const double rim = disc.position_of(sample).radius;
    if (!(rim <= 1.0)) continue;
    const double depth = ball_depth_mm(sample, along, ball.centre_mm, radius_mm);
    const double factor = mapping.parameters().variation.at(sample.position_mm);
    result.samples.push_back({sample.pixel, sample.x, depth,
                              factor * mapping.depth_mm(sample.x) - depth -
                                  blur_mm(sample, around, curve.at(), along, ball.centre_mm),
                              sample.position_mm.x(), sample.position_mm.y(), rim, factor});
    if (rim < nearest_rim) nearest_rim = rim, nearest = &sample;
  }
  if (nearest == nullptr) return std::nullopt;
  result.along_mm = nearest->position_mm.x();
  result.across_mm = nearest->position_mm.y();
  for (const ResidualSample& sample : result.samples)
    result.contact_radius_mm = std::max(
        result.contact_radius_mm,
        std::hypot(sample.along_mm - result.along_mm, sample.across_mm - result.across_mm));
  result.face_length_mm = face_length_mm(press.shape);
  result.face_width_mm = face_width_mm(press.shape, nearest->pixel);
  return result;
}

}  // namespace

double face_length_mm(const FaceShape& shape) {
  double longest = 0;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid)
      longest = std::max(longest, shape.length_at(u));
  return longest;
}

std::vector<PressResiduals> press_residuals(const std::vector<const Press*>& presses,
                                            const Face& face, const Calibration& calibration) {
  std::vector<PressResiduals> all;
  const auto mapping = Mapping::create(calibration.mapping);
  if (!mapping) return all;
  for (const BallFit& ball : calibration.balls) {
    const auto press = std::find_if(presses.begin(), presses.end(),
                                    [&](const Press* one) { return one->name == ball.press; });
    if (press == presses.end()) continue;
    auto residuals = residuals_of(**press, face, *mapping, ball);
    if (residuals) all.push_back(std::move(*residuals));
  }
  return all;
}

std::vector<ZoneError> zone_errors(const std::vector<PressResiduals>& residuals,
                                   const Calibration& calibration, FaceKind kind) {
  const bool flat = kind == FaceKind::kFlat;
  std::array<ZoneError, 5> zones;
  zones[0].zone = flat ? en::say("left") : en::say("base");
  zones[1].zone = en::say("middle");
  zones[2].zone = flat ? en::say("right") : en::say("tip");
  zones[3].zone = en::say("upper half");
  zones[4].zone = en::say("lower half");
  for (const PressResiduals& press : residuals) {
    const auto ball = std::find_if(calibration.balls.begin(), calibration.balls.end(),
                                   [&](const BallFit& one) { return one.press == press.press; });
    if (ball == calibration.balls.end() || !(press.face_length_mm > 0)) continue;
    const double error = ball->held_out_mm > 0 ? ball->held_out_mm : ball->residual_mm;
    const int third =
        std::clamp(static_cast<int>(3.0 * press.along_mm / press.face_length_mm), 0, 2);
    for (const int zone : {third, press.across_mm < 0 ? 3 : 4}) {
      ZoneError& one = zones[static_cast<std::size_t>(zone)];
      one.error_mm = one.error_mm.value_or(0.0) + error;
      ++one.presses;
    }
  }
  for (ZoneError& zone : zones)
    if (zone.error_mm) *zone.error_mm /= zone.presses;
  return {zones.begin(), zones.end()};
}

Message zone_sentence(const std::vector<ZoneError>& zones) {
  std::vector<Message> all;
  for (const ZoneError& zone : zones)
    all.push_back(zone.error_mm
                      ? en::count("{1} {2:.3f} mm ({0} presses)", "{1} {2:.3f} mm ({0} press)",
                                  zone.presses, zone.zone, *zone.error_mm)
                      : en::say("{} unknown: no press there", zone.zone));
  return en::list(all);
}

namespace {

constexpr double kInContactMm = 0.1;

/// Means over a contact's samples; NaN where there is none.
struct MeanSd {
  double all_mm = 0, without_mapping_mm = 0;
};
MeanSd mean_sd(const ComparedPress& compared, const PressResiduals& contact,
               const Mapping& mapping) {
  const auto& [press, reference] = compared;
  Difference difference = press->difference;
  cv::Mat1b mask(difference.x.size(), 0);
  for (const ResidualSample& sample : contact.samples)
    if (sample.ball_depth_mm > kInContactMm)
      mask(static_cast<int>(sample.pixel.y()), static_cast<int>(sample.pixel.x())) = 1;
  // Depth is computed around this contact only, to save time.
  constexpr int kAround = 40;  // px: further than a layer's thickness displaces a point
  const cv::Rect box = cv::boundingRect(mask);
  const cv::Rect near =
      cv::Rect(box.tl() - cv::Point(kAround, kAround), box.br() + cv::Point(kAround, kAround)) &
      cv::Rect({0, 0}, mask.size());
  cv::Mat x(difference.x.size(), CV_32FC1, cv::Scalar(NAN));
  press->difference.x(near).copyTo(x(near));
  difference.x = x;
  DepthMap depth = depth_map(difference, mapping, press->shape);
  depth.live_sd = difference.grey_sd / std::hypot(1.0, reference->noise_gain);
  // With the errors of recorded poses: how far the finger deflects differs from contact to contact.
  Reference known = *reference;
  known.error_factor = std::min(known.error_factor, 1.0);
  known.outer_error_factor = std::min(known.outer_error_factor, 1.0);
  DepthErrorModel error(depth, known, press->shape, mapping);
  MeanSd sum;
  int count = 0;
  for (int v = 0; v < mask.rows; ++v) {
    if (cv::countNonZero(mask.row(v)) == 0) continue;
    error.row(v, [&](int u, const DepthErrorTerms& causes) {
      if (mask(v, u) == 0) return;
      sum.all_mm += causes.total();
      DepthErrorTerms others = causes;
      others.mapping = 0;
      sum.without_mapping_mm += others.total();
      ++count;
    });
  }
  return {sum.all_mm / count, sum.without_mapping_mm / count};
}

}  // namespace

ContactError contact_error(const std::vector<ComparedPress>& presses,
                           const std::vector<PressResiduals>& contacts,
                           const MappingParameters& parameters) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping) return {};
  std::vector<double> all_mm, others_mm;
  for (const PressResiduals& contact : contacts) {
    const auto compared =
        std::find_if(presses.begin(), presses.end(),
                     [&](const ComparedPress& one) { return one.press->name == contact.press; });
    if (compared == presses.end()) continue;
    const MeanSd sd = mean_sd(*compared, contact, *mapping);
    if (!std::isfinite(sd.all_mm)) continue;
    all_mm.push_back(kMeanOfSd * sd.all_mm);
    others_mm.push_back(sd.without_mapping_mm);
  }
  return {upper_median(all_mm), upper_median(others_mm)};
}

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

struct Rings {
  double near_mm = 0, far_mm = 0, skin_mm = 0;
};

/// nullopt: too little of a ring is visible.
std::optional<Rings> rings_of(const Press& press, const Face& face, const Mapping& mapping,
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

Halo measure_halo(const std::vector<const Press*>& presses, const Face& face,
                  const Calibration& calibration) {
  Halo halo;
  const auto mapping = Mapping::create(calibration.mapping);
  if (!mapping) return halo;
  std::vector<double> excess_mm;
  for (const BallFit& ball : calibration.balls) {
    const auto press = std::find_if(presses.begin(), presses.end(),
                                    [&](const Press* one) { return one->name == ball.press; });
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
