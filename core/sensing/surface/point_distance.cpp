#include "core/sensing/surface/point_distance.h"

#include "core/sensing/measures.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

/// Columns over which errors of the face's z are correlated.
double correlation_px(const FaceShape& shape) {
  constexpr double kCoefficients = 8;
  const auto valid = std::count_if(shape.columns().begin(),
                                   shape.columns().end(),
                                   [](const FaceColumn& column) { return column.valid; });
  return std::max(1.0, static_cast<double>(valid) / kCoefficients);
}

}  // namespace

Result<MeasuredValue> straight_distance(const FrameResult& result,
                                        const Face& face,
                                        const cv::Mat& sd_mm,
                                        cv::Point2d from,
                                        cv::Point2d to) {
  const auto first = sample_face(result, face, sd_mm, from);
  const auto second = sample_face(result, face, sd_mm, to);
  if (!first || !second)
    return Error{en::say("a point lies off the face"), "", en::say("points on the face")};
  const Eigen::Vector3d apart_mm = second->point_mm() - first->point_mm();
  const double distance_mm = apart_mm.norm();
  if (!(distance_mm > 0))
    return Error{en::say("both points are one"), "", en::say("two points that are apart")};
  const Eigen::Vector3d direction = apart_mm / distance_mm;
  const FaceShape& shape = *result.shape;
  // Change of the distance when the face's z is off by one standard deviation.
  const auto by_face = [&](const FaceSample& sample) {
    const auto u = static_cast<std::size_t>(
        std::clamp<long>(std::lround(sample.pixel.x), 0, shape.width_px() - 1));
    const Eigen::Vector3d sight = sample.untouched_mm / sample.untouched_mm.z();
    return direction.dot(sight) * shape.columns()[u].z_sd_mm;
  };
  const double one = by_face(*first), two = by_face(*second);
  const double columns = (to.x - from.x) / correlation_px(shape);
  const double rho = std::exp(-0.5 * columns * columns);
  const double depth = std::hypot(first->sd_mm.value_or(0), second->sd_mm.value_or(0));
  const double variance =
      one * one + two * two - 2 * rho * one * two + std::pow(direction.z() * depth, 2);
  return MeasuredValue{distance_mm, std::sqrt(std::max(variance, 0.0))};
}

}  // namespace alltact
