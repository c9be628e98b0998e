#include "core/simulation/press_sampling.h"

#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

constexpr double kMinStep_mm = 0.05;
constexpr double kMaxSteps = 600;
constexpr double kMaxHalf_mm = 100;  // of half the body's size

}  // namespace

SampledPress sample_press(const BodyPress& press, const FrameGeometry& geometry) {
  SampledPress grid;
  grid.pose = press.pose;
  grid.rotation_rad = press.rotation_rad;
  // A slanted line leaves the body's outline by up to twice the depth.
  const double margin = 2 * press.pose.depth_mm + 2 * kMinStep_mm;
  const Eigen::Vector2d half = (press.body->half_size_mm().array() + margin).min(kMaxHalf_mm);
  grid.step_mm = std::max(kMinStep_mm, 2 * half.maxCoeff() / kMaxSteps);
  const Eigen::Vector2i steps = (half / grid.step_mm).array().ceil().cast<int>();
  grid.depth_mm.create(2 * steps.y() + 1, 2 * steps.x() + 1);
  const double c = std::cos(press.rotation_rad), s = std::sin(press.rotation_rad);
  for (int row = 0; row < grid.depth_mm.rows; ++row)
    for (int column = 0; column < grid.depth_mm.cols; ++column) {
      const double x = (column - steps.x()) * grid.step_mm, y = (row - steps.y()) * grid.step_mm;
      const Eigen::Vector3d luf =
          geometry.luf_point_mm(press.pose.s_mm + c * x - s * y, press.pose.y_mm + s * x + c * y);
      const double lowest = press.posed->lowest_z_mm(luf.x(), luf.y(), luf.z());
      grid.depth_mm(row, column) =
          std::isfinite(lowest) ? static_cast<float>(luf.z() - lowest) : 0.0F;
    }
  grid.in_contact = grid.depth_mm > 0;
  return grid;
}

void sample_bodies(FrameGeometry& geometry) {
  for (auto& press : geometry.presses)
    if (const auto* body = std::get_if<BodyPress>(&press)) press = sample_press(*body, geometry);
}

void pad_grid(SampledPress& press, int steps) {
  cv::Mat_<float> depth;
  cv::copyMakeBorder(
      press.depth_mm, depth, steps, steps, steps, steps, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat_<std::uint8_t> in_contact;
  cv::copyMakeBorder(
      press.in_contact, in_contact, steps, steps, steps, steps, cv::BORDER_CONSTANT, cv::Scalar(0));
  press.depth_mm = depth;
  press.in_contact = in_contact;
}

}  // namespace alltact
