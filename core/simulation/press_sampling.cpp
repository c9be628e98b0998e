#include "core/simulation/press_sampling.h"

#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

constexpr double kFinest_mm = 0.05;
constexpr double kMostSteps = 600;
constexpr double kFarthest_mm = 100;  // from its middle, of a body that goes beyond the finger

}  // namespace

SampledPress sampled(const BodyPress& press, const FrameGeometry& geometry) {
  SampledPress grid;
  grid.place = press.place;
  grid.rotation_rad = press.rotation_rad;
  // A slanted line leaves the body's outline by up to twice the depth.
  const double margin = 2 * press.place.depth_mm + 2 * kFinest_mm;
  const Eigen::Vector2d half = (press.body->half_size_mm().array() + margin).min(kFarthest_mm);
  grid.step_mm = std::max(kFinest_mm, 2 * half.maxCoeff() / kMostSteps);
  const Eigen::Vector2i steps = (half / grid.step_mm).array().ceil().cast<int>();
  grid.depth_mm.create(2 * steps.y() + 1, 2 * steps.x() + 1);
  const double c = std::cos(press.rotation_rad), s = std::sin(press.rotation_rad);
  for (int row = 0; row < grid.depth_mm.rows; ++row)
    for (int column = 0; column < grid.depth_mm.cols; ++column) {
      const double x = (column - steps.x()) * grid.step_mm, y = (row - steps.y()) * grid.step_mm;
      const Eigen::Vector3d luf =
          geometry.luf_point_mm(press.place.s_mm + c * x - s * y, press.place.y_mm + s * x + c * y);
      const double lowest = press.posed->lowest_z_mm(luf.x(), luf.y(), luf.z());
      grid.depth_mm(row, column) =
          std::isfinite(lowest) ? static_cast<float>(luf.z() - lowest) : 0.0F;
    }
  grid.touched = grid.depth_mm > 0;
  return grid;
}

void sample_bodies(FrameGeometry& geometry) {
  for (auto& press : geometry.presses)
    if (const auto* body = std::get_if<BodyPress>(&press)) press = sampled(*body, geometry);
}

void widen(SampledPress& press, int steps) {
  cv::Mat_<float> depth;
  cv::copyMakeBorder(
      press.depth_mm, depth, steps, steps, steps, steps, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat_<std::uint8_t> touched;
  cv::copyMakeBorder(
      press.touched, touched, steps, steps, steps, steps, cv::BORDER_CONSTANT, cv::Scalar(0));
  press.depth_mm = depth;
  press.touched = touched;
}

}  // namespace alltact
