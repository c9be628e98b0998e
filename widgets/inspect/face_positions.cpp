#include "widgets/inspect/face_positions.h"

#include "core/sensing/face/position_pixel.h"

#include <cmath>

namespace alltact {

cv::Point2d nearest_pixel(cv::Point2d pixel) {
  return {std::round(pixel.x), std::round(pixel.y)};
}

std::optional<cv::Point2d> pixel_of(const InspectedFrame& frame,
                                    const std::optional<FacePosition>& position) {
  if (!position || !frame.result.shape) return std::nullopt;
  const auto at = pixel_of_position(*frame.result.shape, {position->along_mm, position->across_mm});
  if (!at) return std::nullopt;
  const cv::Point2d pixel(at->x(), at->y()), rounded = nearest_pixel(pixel);
  constexpr double kRounding_px = 1e-6;
  return cv::norm(pixel - rounded) < kRounding_px ? rounded : pixel;
}

std::optional<FacePosition> position_of(const InspectedFrame& frame, cv::Point2d pixel) {
  if (!frame.result.shape) return std::nullopt;
  const Eigen::Vector2d position_mm = frame.result.shape->position_mm(pixel.x, pixel.y);
  return FacePosition{position_mm.x(), position_mm.y()};
}

std::optional<Profile> other_profile(const InspectedFrame& frame,
                                     const FacePosition& a,
                                     const FacePosition& b) {
  if (!frame.other || !frame.other->shape || !frame.other->depth) return std::nullopt;
  const auto from = pixel_of_position(*frame.other->shape, {a.along_mm, a.across_mm});
  const auto to = pixel_of_position(*frame.other->shape, {b.along_mm, b.across_mm});
  if (!from || !to) return std::nullopt;
  return profile_between(*frame.other, frame.face, {}, {from->x(), from->y()}, {to->x(), to->y()});
}

}  // namespace alltact
