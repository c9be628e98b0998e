#include "calibration/report/press_residuals.h"

#include "calibration/joint/joint_fit.h"
#include "calibration/presses/press_samples.h"
#include "core/finger/mapping.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

constexpr int kSamples = 800;  // for each press: a compromise of detail and drawing time

double face_width_mm(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  if (shape.face().kind == FaceKind::kFinRay) return shape.face().width_mm;
  const auto area = shape.pixel_area(pixel.x(), pixel.y());
  return area ? std::sqrt(area->on_face_mm2) * shape.camera().size().height : 0.0;
}

/// nullopt: nothing lies under the ball.
std::optional<PressResiduals> residuals_of(const Press& press,
                                           const Face& face,
                                           const Mapping& mapping,
                                           const BallFit& ball) {
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
    result.samples.push_back({sample.pixel,
                              sample.x,
                              depth,
                              factor * mapping.depth_mm(sample.x) - depth -
                                  blur_mm(sample, around, curve, along, ball.centre_mm),
                              sample.position_mm.x(),
                              sample.position_mm.y(),
                              rim,
                              factor});
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
                                            const Face& face,
                                            const Calibration& calibration) {
  std::vector<PressResiduals> all;
  const auto mapping = Mapping::create(calibration.mapping);
  if (!mapping) return all;
  for (const BallFit& ball : calibration.balls) {
    const auto press = std::find_if(
        presses.begin(), presses.end(), [&](const Press* one) { return one->name == ball.press; });
    if (press == presses.end()) continue;
    auto residuals = residuals_of(**press, face, *mapping, ball);
    if (residuals) all.push_back(std::move(*residuals));
  }
  return all;
}

std::vector<ZoneError> zone_errors(const std::vector<PressResiduals>& residuals,
                                   const Calibration& calibration,
                                   FaceKind kind) {
  const bool flat = kind == FaceKind::kFlat;
  std::array<ZoneError, 5> zones;
  zones[0].zone = flat ? en::say("left") : en::say("base");
  zones[1].zone = en::say("middle");
  zones[2].zone = flat ? en::say("right") : en::say("tip");
  zones[3].zone = en::say("upper half");
  zones[4].zone = en::say("lower half");
  for (const PressResiduals& press : residuals) {
    const auto ball = std::find_if(calibration.balls.begin(),
                                   calibration.balls.end(),
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
    all.push_back(zone.error_mm ? en::count("{1} {2:.3f} mm ({0} presses)",
                                            "{1} {2:.3f} mm ({0} press)",
                                            zone.presses,
                                            zone.zone,
                                            *zone.error_mm)
                                : en::say("{} unknown: no press there", zone.zone));
  return en::list(all);
}

}  // namespace alltact
