#include "core/inspection/face_reading.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

template <class T>
FaceReading reading(const Result<T>& found, const MeasuredValue T::*member) {
  FaceReading reading;
  if (found)
    reading.measured = (*found).*member;
  else
    reading.reason = found.error().what;
  return reading;
}

cv::Rect box_of(cv::Point2d a, cv::Point2d b) {
  const cv::Point first(static_cast<int>(std::lround(std::min(a.x, b.x))),
                        static_cast<int>(std::lround(std::min(a.y, b.y))));
  const cv::Point last(static_cast<int>(std::lround(std::max(a.x, b.x))),
                       static_cast<int>(std::lround(std::max(a.y, b.y))));
  return {first, last + cv::Point(1, 1)};
}

cv::Rect around(cv::Point2d at) {
  return box_of(at - cv::Point2d(kAroundPx, kAroundPx), at + cv::Point2d(kAroundPx, kAroundPx));
}

}  // namespace

std::string_view to_string(Measurand measurand) {
  switch (measurand) {
    case Measurand::kDistance:
      return "distance";
    case Measurand::kRadius:
      return "radius";
    case Measurand::kArea:
      return "area";
    case Measurand::kVolume:
      return "volume";
    case Measurand::kMeanDepth:
      return "mean_depth";
    case Measurand::kRoughness:
      return "roughness";
    case Measurand::kStep:
      return "step";
    case Measurand::kAngle:
      break;
  }
  return "angle";
}

std::string_view unit_of(Measurand measurand) {
  switch (measurand) {
    case Measurand::kArea:
      return "mm2";
    case Measurand::kVolume:
      return "mm3";
    case Measurand::kAngle:
      return "deg";
    default:
      return "mm";
  }
}

const std::vector<Measurand>& all_measurands() {
  static const std::vector<Measurand> all{
      Measurand::kDistance,  Measurand::kRadius,    Measurand::kArea, Measurand::kVolume,
      Measurand::kMeanDepth, Measurand::kRoughness, Measurand::kStep, Measurand::kAngle};
  return all;
}

FaceReader::FaceReader(const MeasuredFace& face, cv::Point2d a, cv::Point2d b,
                       const RoughnessFilter& filter)
    : face_(face), a_(a), b_(b), filter_(filter) {}

const SurfacePatch& FaceReader::box() {
  if (!box_) box_ = patch(box_of(a_, b_));
  return *box_;
}

SurfacePatch FaceReader::patch(const cv::Rect& box) const {
  return patch_in(face_.result, face_.face, face_.mapping, face_.smoothing_px, box);
}

FaceReading FaceReader::operator()(Measurand measurand) {
  const auto pressed = [this](MeasuredValue PressedSurface::*member, bool may_be_bound) {
    const auto part = pressed_part(box(), kPressedMm);
    FaceReading found = reading(part, member);
    found.is_lower_bound = may_be_bound && part && part->is_lower_bound;
    return found;
  };
  switch (measurand) {
    case Measurand::kDistance: {
      const auto apart = straight_distance(face_.result, face_.face, face_.sd_mm, a_, b_);
      return apart ? FaceReading{*apart, {}, false} : FaceReading{{}, apart.error().what, false};
    }
    case Measurand::kRadius:
      return reading(fit_ball(box()), &FittedBall::radius_mm);
    case Measurand::kArea:
      return pressed(&PressedSurface::area_mm2, false);
    case Measurand::kVolume:
      return pressed(&PressedSurface::volume_mm3, true);
    case Measurand::kMeanDepth:
      return pressed(&PressedSurface::mean_mm, true);
    case Measurand::kRoughness:
      return reading(roughness(box(), filter_), &Roughness::sq_mm);
    case Measurand::kStep:
      return step();
    case Measurand::kAngle:
      break;
  }
  return angle();
}

FaceReading FaceReader::step() const {
  const SurfaceLine line =
      line_between(face_.result, face_.face, face_.mapping, face_.smoothing_px, a_, b_);
  return reading(step_height(line.patch, line.along_mm), &StepHeight::height_mm);
}

FaceReading FaceReader::angle() const {
  const auto at_a = fit_plane(patch(around(a_))), at_b = fit_plane(patch(around(b_)));
  if (!at_a || !at_b) return {{}, (at_a ? at_b : at_a).error().what, false};
  return {angle_deg(*at_a, *at_b), {}, false};
}

std::optional<cv::Point2d> pixel_of(const FrameResult& result, const FacePosition& position) {
  if (!result.shape) return std::nullopt;
  const auto at = pixel_of_position(*result.shape, {position.along_mm, position.across_mm});
  if (!at) return std::nullopt;
  const cv::Point2d pixel(at->x(), at->y()), rounded = nearest_pixel(pixel);
  constexpr double kRounding_px = 1e-6;
  return cv::norm(pixel - rounded) < kRounding_px ? rounded : pixel;
}

cv::Point2d nearest_pixel(cv::Point2d pixel) { return {std::round(pixel.x), std::round(pixel.y)}; }

}  // namespace alltact
