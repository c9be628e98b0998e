#include "widgets/inspect/face_places.h"

#include "core/sensing/face/place_pixel.h"

#include <cmath>

namespace alltact {

cv::Point2d whole_pixel(cv::Point2d pixel) {
  return {std::round(pixel.x), std::round(pixel.y)};
}

std::optional<cv::Point2d> pixel_of(const InspectedFrame& frame,
                                    const std::optional<FacePlace>& place) {
  if (!place || !frame.result.shape) return std::nullopt;
  const auto at = pixel_of_place(*frame.result.shape, {place->along_mm, place->across_mm});
  if (!at) return std::nullopt;
  const cv::Point2d pixel(at->x(), at->y()), whole = whole_pixel(pixel);
  constexpr double kRounding_px = 1e-6;
  return cv::norm(pixel - whole) < kRounding_px ? whole : pixel;
}

std::optional<FacePlace> place_of(const InspectedFrame& frame, cv::Point2d pixel) {
  if (!frame.result.shape) return std::nullopt;
  const Eigen::Vector2d place_mm = frame.result.shape->place_mm(pixel.x, pixel.y);
  return FacePlace{place_mm.x(), place_mm.y()};
}

std::optional<Profile> other_profile(const InspectedFrame& frame,
                                     const FacePlace& a,
                                     const FacePlace& b) {
  if (!frame.other || !frame.other->shape || !frame.other->depth) return std::nullopt;
  const auto from = pixel_of_place(*frame.other->shape, {a.along_mm, a.across_mm});
  const auto to = pixel_of_place(*frame.other->shape, {b.along_mm, b.across_mm});
  if (!from || !to) return std::nullopt;
  return profile_between(*frame.other, frame.face, {}, {from->x(), from->y()}, {to->x(), to->y()});
}

}  // namespace alltact
