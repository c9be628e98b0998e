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
    case Measurand::kSectionDepth:
      return "section_depth";
    case Measurand::kSectionWidth:
      return "section_width";
    case Measurand::kSectionArea:
      return "section_area";
    case Measurand::kAngle:
      break;
  }
  return "angle";
}

std::string_view unit_of(Measurand measurand) {
  switch (measurand) {
    case Measurand::kArea:
    case Measurand::kSectionArea:
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
  using enum Measurand;
  static const std::vector<Measurand> all{kDistance,     kRadius,       kArea,       kVolume,
                                          kMeanDepth,    kRoughness,    kStep,       kAngle,
                                          kSectionDepth, kSectionWidth, kSectionArea};
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
    const auto part = pressed_part(box(), kLeastDepthMm);
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
    case Measurand::kSectionDepth:
    case Measurand::kSectionWidth:
    case Measurand::kSectionArea:
      return section(measurand);
    case Measurand::kAngle:
      break;
  }
  return angle();
}

SurfaceLine FaceReader::line() const {
  return line_between(face_.result, face_.face, face_.mapping, face_.smoothing_px, a_, b_);
}

FaceReading FaceReader::section(Measurand measurand) const {
  const auto section = section_of(line());
  if (!section) return {{}, section.error().what, false};
  if (measurand == Measurand::kSectionWidth)
    return section->width_mm ? FaceReading{*section->width_mm, {}, false}
                             : FaceReading{{}, section->width_mm.error().what, false};
  return {measurand == Measurand::kSectionDepth ? section->depth_mm : section->area_mm2,
          {},
          section->is_lower_bound};
}

FaceReading FaceReader::step() const {
  const SurfaceLine line = this->line();
  return reading(step_height(line.patch, line.along_mm), &StepHeight::height_mm);
}

FaceReading FaceReader::angle() const {
  const auto at_a = fit_plane(patch(around(a_))), at_b = fit_plane(patch(around(b_)));
  if (!at_a || !at_b) return {{}, (at_a ? at_b : at_a).error().what, false};
  return {angle_deg(*at_a, *at_b), {}, false};
}

namespace {

/// Both sides of the deepest point at half of its depth, and how steep they are there.
struct HalfWidth {
  double width_mm = 0;
  double left_slope = 0, right_slope = 0;  // depth per mm along the face, absolute
};

/// Depths are shifted by so many of their common standard deviations. nullopt: the line ends first.
std::optional<HalfWidth> half_width(const SurfaceLine& line, std::size_t deepest, double shift) {
  const auto& points = line.patch.points;
  const auto depth_mm = [&](std::size_t i) {
    return points[i].depth_mm + shift * points[i].common_mm;
  };
  const double half_mm = 0.5 * depth_mm(deepest);
  const std::size_t last = points.size() - 1;
  std::size_t left = deepest, right = deepest;
  while (left > 0 && depth_mm(left) >= half_mm) --left;
  while (right < last && depth_mm(right) >= half_mm) ++right;
  if (depth_mm(left) >= half_mm || depth_mm(right) >= half_mm) return std::nullopt;
  const auto crossing = [&](std::size_t below, std::size_t above) {
    const double part = (half_mm - depth_mm(below)) / (depth_mm(above) - depth_mm(below));
    return std::lerp(line.along_mm[below], line.along_mm[above], part);
  };
  // Noise makes the slope between neighbours uncertain: over two points to each side.
  const auto slope = [&](std::size_t low, std::size_t high) {
    const std::size_t from = low - std::min<std::size_t>(low, 1), to = std::min(high + 1, last);
    return std::abs(depth_mm(to) - depth_mm(from)) / (line.along_mm[to] - line.along_mm[from]);
  };
  return HalfWidth{crossing(right, right - 1) - crossing(left, left + 1), slope(left, left + 1),
                   slope(right - 1, right)};
}

Result<MeasuredValue> width_of(const SurfaceLine& line, std::size_t deepest) {
  const auto& points = line.patch.points;
  if (points[deepest].is_limit)
    return Error{en::say("the deepest point is at a limit of the measuring range"), "",
                 en::say("a shallower contact")};
  const auto width = half_width(line, deepest, 0), moved = half_width(line, deepest, 1);
  if (!width || !moved)
    return Error{en::say("the line ends before half of its greatest depth"), "",
                 en::say("a line across the entire contact")};
  // The half level moves both sides; each side has its own noise, too.
  const double noise_mm = points[deepest].noise_mm;
  const double left_mm = noise_mm / std::max(width->left_slope, 1e-9),
               right_mm = noise_mm / std::max(width->right_slope, 1e-9);
  const double noise = std::hypot(left_mm, right_mm, 0.5 * (left_mm + right_mm));
  return MeasuredValue{width->width_mm, std::hypot(noise, moved->width_mm - width->width_mm)};
}

}  // namespace

Result<LineSection> section_of(const SurfaceLine& line) {
  const auto& points = line.patch.points;
  const auto deepest =
      std::max_element(points.begin(), points.end(),
                       [](const auto& a, const auto& b) { return a.depth_mm < b.depth_mm; });
  if (deepest == points.end() || !(deepest->depth_mm > kLeastDepthMm))
    return Error{en::say("nothing here is deeper than {} mm", kLeastDepthMm), "",
                 en::say("a piece where something presses")};
  double area_mm2 = 0, noise = 0, common = 0;
  bool is_lower_bound = false;
  std::vector<double> strips_mm(points.size(), 0.0);  // width that each point stands for
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double high_mm = std::max(points[i].depth_mm, points[i + 1].depth_mm);
    const double low_mm = std::min(points[i].depth_mm, points[i + 1].depth_mm);
    if (!(high_mm > kLeastDepthMm)) continue;
    // Depths are along z, so that the width of a strip is measured across it.
    const double apart_mm = (points[i + 1].untouched_mm - points[i].untouched_mm).head<2>().norm();
    const double from_mm = std::max(low_mm, kLeastDepthMm);
    const double part = low_mm < from_mm ? (high_mm - from_mm) / (high_mm - low_mm) : 1;
    area_mm2 += part * apart_mm * 0.5 * (high_mm + from_mm);
    for (const std::size_t end : {i, i + 1}) strips_mm[end] += 0.5 * part * apart_mm;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    noise += std::pow(strips_mm[i] * points[i].noise_mm, 2);
    common += strips_mm[i] * points[i].common_mm;
    is_lower_bound = is_lower_bound || (points[i].is_limit && points[i].depth_mm > kLeastDepthMm);
  }
  return LineSection{{deepest->depth_mm, std::hypot(deepest->noise_mm, deepest->common_mm)},
                     width_of(line, static_cast<std::size_t>(deepest - points.begin())),
                     {area_mm2, std::hypot(std::sqrt(noise * line.patch.noise_pixels), common)},
                     is_lower_bound};
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
