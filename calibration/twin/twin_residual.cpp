#include "calibration/twin/twin_residual.h"

#include "calibration/twin/twin_contact.h"

#include <cmath>

namespace alltact {
namespace {

/// Sums over one ring.
struct RingSums {
  double count = 0, radius = 0, real = 0, twin = 0, difference2 = 0, ratio = 0;
};

}  // namespace

TwinResidual residual_of(const TwinPress& press,
                         const cv::Mat& twin,
                         const cv::Mat& twin_untouched,
                         const Eigen::Vector2d& middle_px) {
  TwinResidual result;
  result.press = press.name;
  result.reach_px = kTwinReach * press.disc_radius_px;
  std::vector<RingSums> rings(static_cast<std::size_t>(result.reach_px) + 1);
  double count = 0, sum2 = 0, ratio_sum2 = 0;
  for (int v = 0; v < press.grey.rows; ++v)
    for (int u = 0; u < press.grey.cols; ++u) {
      const double radius = std::hypot(u - middle_px.x(), v - middle_px.y());
      const float reference = press.reference.at<float>(v, u);
      if (!(radius < result.reach_px) || !(reference > 0)) continue;
      const double real = press.grey.at<std::uint8_t>(v, u), made = twin.at<float>(v, u);
      const double by_ratio = made - real / reference * twin_untouched.at<float>(v, u);
      RingSums& ring = rings[static_cast<std::size_t>(radius)];
      ring.count += 1;
      ring.radius += radius;
      ring.real += real;
      ring.twin += made;
      ring.difference2 += (made - real) * (made - real);
      ring.ratio += by_ratio;
      count += 1;
      sum2 += (made - real) * (made - real);
      ratio_sum2 += by_ratio * by_ratio;
    }
  if (count == 0) return result;
  result.rms = std::sqrt(sum2 / count);
  result.ratio_rms = std::sqrt(ratio_sum2 / count);
  double profile2 = 0, ratio_profile2 = 0;
  for (const RingSums& ring : rings) {
    if (ring.count == 0) continue;
    const double n = ring.count, difference = (ring.twin - ring.real) / n;
    const double variance = std::max(0.0, ring.difference2 / n - difference * difference);
    result.profile.push_back({ring.radius / n,
                              ring.real / n,
                              ring.twin / n,
                              std::sqrt(variance / std::max(1.0, n - 1))});
    profile2 += difference * difference;
    ratio_profile2 += (ring.ratio / n) * (ring.ratio / n);
  }
  result.profile_rms = std::sqrt(profile2 / static_cast<double>(result.profile.size()));
  result.ratio_profile_rms = std::sqrt(ratio_profile2 / static_cast<double>(result.profile.size()));
  return result;
}

}  // namespace alltact
