#include "calibration/twin/twin_contact.h"
#include "calibration/twin/twin_image.h"
#include "core/camera/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kBlocksAcross = 40;  // of a dark disc's diameter
constexpr int kBlurBorder_px = 20;

/// The blocks' part of the image with a border for blur; the full image where no camera model
/// covers a part so far from the axis.
cv::Rect view_of(const TwinPatch& patch, const CameraParameters& camera) {
  const cv::Rect full(0, 0, camera.width_px, camera.height_px);
  if (patch.corners.empty()) return full;
  const int side = patch.side_px, border = (kBlurBorder_px / side + 1) * side;
  cv::Rect view = cv::boundingRect(patch.corners);
  view = cv::Rect(view.x - border,
                  view.y - border,
                  view.width + side + 2 * border,
                  view.height + side + 2 * border);
  const int left = std::max(0, view.x), top = std::max(0, view.y);
  view = cv::Rect(left, top, view.br().x - left, view.br().y - top) & full;
  const CameraParameters seen = cropped_camera(camera, view);
  return Camera::create(seen) && Camera::create(downsampled_camera(seen, side)) ? view : full;
}

}  // namespace

TwinRings rings_of(const TwinPress& press) {
  const double reach = kTwinReach * press.disc_radius_px;
  std::vector<double> sum(static_cast<std::size_t>(reach) + 1), count(sum.size());
  for (int v = 0; v < press.grey.rows; ++v)
    for (int u = 0; u < press.grey.cols; ++u) {
      const double radius = std::hypot(u - press.disc_px.x(), v - press.disc_px.y());
      const float reference = press.reference.at<float>(v, u);
      if (!(radius < reach) || !(reference > 0)) continue;
      sum[static_cast<std::size_t>(radius)] += press.grey.at<std::uint8_t>(v, u) / reference - 1;
      count[static_cast<std::size_t>(radius)] += 1;
    }
  TwinRings rings;
  std::vector<double> mean(sum.size());  // over three rings
  for (std::size_t i = 1; i + 1 < sum.size(); ++i) {
    const double n = count[i - 1] + count[i] + count[i + 1];
    mean[i] = n > 0 ? (sum[i - 1] + sum[i] + sum[i + 1]) / n : 0;
  }
  const auto darkest = std::min_element(mean.begin(), mean.end());
  auto rim = std::find_if(darkest, mean.end(), [&](double x) { return x > 0.02 * *darkest; });
  if (rim == mean.end()) return rings;
  rings.rim_px = static_cast<double>(rim - mean.begin());
  const auto brightest = std::max_element(rim, mean.end());
  rings.halo_px = static_cast<double>(brightest - rim);
  rings.brightest = std::max(0.0, *brightest);
  return rings;
}

TwinPatch patch_of(const TwinPress& press,
                   const cv::Mat& untouched,
                   const CameraParameters& camera,
                   bool is_coarse) {
  TwinPatch patch;
  patch.is_coarse = is_coarse;
  const double across = is_coarse ? kBlocksAcross / 3.0 : kBlocksAcross;
  patch.side_px = std::max(1, static_cast<int>(2 * press.disc_radius_px / across));
  const int side = patch.side_px;
  const double reach = kTwinReach * press.disc_radius_px;
  std::vector<double> target;
  for (int v = 0; v + side <= press.grey.rows; v += side)
    for (int u = 0; u + side <= press.grey.cols; u += side) {
      const double du = u + 0.5 * (side - 1) - press.disc_px.x();
      const double dv = v + 0.5 * (side - 1) - press.disc_px.y();
      if (std::hypot(du, dv) > reach) continue;
      double live = 0, reference = 0, twin = 0;
      bool saturated = false;
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const std::uint8_t level = press.grey.at<std::uint8_t>(v + i, u + j);
          saturated |= level >= 254;
          live += level;
          reference += press.reference.at<float>(v + i, u + j);
          twin += untouched.at<float>(v + i, u + j);
        }
      if (saturated || !(reference > 0) || !std::isfinite(reference)) continue;
      patch.corners.emplace_back(u, v);
      target.push_back(live / reference * twin / (side * side));
      const double turn = (std::atan2(dv, du) + std::numbers::pi) / (2 * std::numbers::pi);
      patch.sectors.push_back(std::min(kTwinSectors - 1, static_cast<int>(kTwinSectors * turn)));
    }
  patch.target =
      Eigen::Map<Eigen::VectorXd>(target.data(), static_cast<Eigen::Index>(target.size()));
  patch.view = view_of(patch, camera);
  return patch;
}

}  // namespace alltact
