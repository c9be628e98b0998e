#include "core/sensing/depth/depth_along_z.h"

#include "core/numerics/bilinear.h"
#include "core/sensing/depth/depth_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

// A cell below this mean depth only needs scaling; it lies above the noise.
constexpr float kIndentedMm = 0.02F, kMaxIndentedMm = 0.1F;
// The same limit for bulges: shallower ones are so wide that scaling is off by a few hundredths.
constexpr double kBulgingMm = 0.05;
// 3 sd, from the first quartile of a normal law's magnitudes (0.319 sd)
constexpr float kAboveNoise = 9.4F;
constexpr int kSteps = 6;  // each at least halves the error

/// The finger's length profile in the x-z plane, along the middle of the face. Across it a twisted
/// face continues along its normal.
class Profile {
 public:
  std::vector<double> foot_x_mm;  ///< x of the contact-free face seen along the normal, ascending
  std::vector<double> z_mm, normal_x, normal_y, normal_z;

  explicit Profile(const FaceShape& shape) {
    const double layer_mm = shape.face().layer_mm;
    for (int u = 0; u < shape.width_px(); ++u) {
      const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
      const auto local = shape.at(u, 0.5 * (column.upper_v + column.lower_v));
      if (!local) continue;
      const double foot = local->view_point_mm.x() + layer_mm * local->normal.x();
      if (!foot_x_mm.empty() && foot <= foot_x_mm.back()) continue;
      foot_x_mm.push_back(foot);
      z_mm.push_back(local->view_point_mm.z());
      normal_x.push_back(local->normal.x());
      normal_y.push_back(local->normal.y());
      normal_z.push_back(local->normal.z());
    }
  }

  struct Section {
    double z_mm, normal_x, normal_y, normal_z;
  };
  /// Section whose normal leads to x on the contact-free face; clamped to the ends. The search
  /// starts at the last result, because neighbours are requested in order.
  [[nodiscard]] Section at(double x_mm) {
    const std::size_t last = foot_x_mm.size() - 1;
    std::size_t r = last_index_;
    while (r < last && foot_x_mm[r] < x_mm) ++r;
    while (r > 1 && !(foot_x_mm[r - 1] < x_mm)) --r;
    last_index_ = r;
    const std::size_t l = r - 1;
    const double part = std::clamp((x_mm - foot_x_mm[l]) / (foot_x_mm[r] - foot_x_mm[l]), 0.0, 1.0);
    const auto between = [&](const std::vector<double>& values) {
      return values[l] + part * (values[r] - values[l]);
    };
    return {between(z_mm), between(normal_x), between(normal_y), between(normal_z)};
  }

 private:
  std::size_t last_index_ = 1;
};

/// Threshold of a cell's mean depth for indentations and bulges. Derived from the first quartile of
/// the magnitudes.
float indented_mm(const cv::Mat& cells_mm) {
  std::vector<float> means;
  for (auto mean = cells_mm.begin<float>(); mean != cells_mm.end<float>(); ++mean)
    if (std::isfinite(*mean)) means.push_back(std::abs(*mean));
  if (means.empty()) return kIndentedMm;
  const auto quarter = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 4);
  std::nth_element(means.begin(), quarter, means.end());
  return std::clamp(kAboveNoise * *quarter, kIndentedMm, kMaxIndentedMm);
}

/// Cells near an indentation, where another pixel can see the line along z.
cv::Mat indented_cells(const cv::Mat& cells_mm, const FaceShape& shape) {
  const double min_mm = static_cast<double>(indented_mm(cells_mm));
  cv::Mat indented = (cells_mm > min_mm) | (cells_mm < -std::max(min_mm, kBulgingMm));
  double nearest_mm = 1e9;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) nearest_mm = std::min(nearest_mm, column.z_mm);
  const double px_per_mm = 1.0 / shape.camera().mm_per_px_at(nearest_mm);
  const int reach =
      1 + static_cast<int>(std::ceil(shape.face().layer_mm * px_per_mm / kDepthCellPx));
  cv::dilate(indented, indented, cv::Mat::ones(3, 2 * reach + 1, CV_8U));
  return indented;
}

struct Lookup {
  double depth_mm = NAN;
  cv::Point seen_at;  ///< the pixel that sees the line
};

/// Depth along z over one pixel; NaN where the pixel that sees the line has no measurement.
Lookup measure_along_z(const cv::Mat& depth_normal_mm,
                       const FaceShape& shape,
                       Profile& profile,
                       const FaceShape::Local& here) {
  const double layer_mm = shape.face().layer_mm;
  const Eigen::Vector3d untouched = untouched_point_mm(here, layer_mm, MappingAlong::kZ);
  // Distance of the contact-free face beyond the profile on this line.
  const Profile::Section foot = profile.at(untouched.x());
  const double beyond_mm = untouched.z() - foot.z_mm - foot.normal_z * layer_mm;
  double depth = 0, pressed_z = 0;
  cv::Point at;
  for (int step = 0; step < kSteps; ++step) {
    // The foot moves back along the normal as the layer thins.
    Profile::Section section = profile.at(untouched.x());
    section = profile.at(untouched.x() + section.normal_x * depth);
    const double thickness = layer_mm - depth;
    const double falls_mm = section.normal_y * section.normal_y / section.normal_z * depth;
    const double z_mm = section.z_mm + beyond_mm - falls_mm;
    const Eigen::Vector3d seen_at(untouched.x() - section.normal_x * thickness,
                                  untouched.y() - section.normal_y * thickness,
                                  z_mm);
    const auto pixel = shape.camera().project(seen_at);
    if (!pixel) return {};
    const double found = bilinear(depth_normal_mm, *pixel);
    if (!std::isfinite(found)) return {};
    at = {static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y()))};
    depth = step < 2 ? found : 0.5 * (depth + found);
    pressed_z = z_mm + section.normal_z * (layer_mm - depth);
  }
  return {untouched.z() - pressed_z, at};
}

}  // namespace

cv::Mat depth_along_z(const cv::Mat& depth_normal_mm,
                      const cv::Mat& cells_mm,
                      const FaceShape& shape,
                      cv::Mat& flags) {
  CV_Assert(depth_normal_mm.type() == CV_32FC1 && depth_normal_mm.cols == shape.width_px() &&
            flags.type() == CV_8UC1 && flags.size() == depth_normal_mm.size());
  cv::Mat depth_mm = depth_normal_mm.clone();
  const cv::Mat flags_before = flags.clone();
  Profile profile(shape);
  const std::vector<float>& along_z = shape.along_z_per_normal();
  const cv::Mat indented = indented_cells(cells_mm, shape);
  for (int row = 0; row < depth_mm.rows; ++row) {
    const std::uint8_t* cell = indented.ptr<std::uint8_t>(row / kDepthCellPx);
    float* depth = depth_mm.ptr<float>(row);
    auto* flag = flags.ptr<std::uint8_t>(row);
    for (int u = 0; u < depth_mm.cols; ++u) {
      // On an even face, depth along the normal and along z differ by a factor only.
      depth[u] *= along_z[static_cast<std::size_t>(u)];
      if (cell[u / kDepthCellPx] == 0 || !std::isfinite(depth[u]) || profile.foot_x_mm.size() < 2)
        continue;
      const auto here = shape.at(u, row);
      if (!here) continue;
      const Lookup found = measure_along_z(depth_normal_mm, shape, profile, *here);
      if (!std::isfinite(found.depth_mm)) continue;
      depth[u] = static_cast<float>(found.depth_mm);
      flag[u] = flags_before.at<std::uint8_t>(found.seen_at);
    }
  }
  return depth_mm;
}

}  // namespace alltact
