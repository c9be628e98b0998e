#include "calibration/reference/spots.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kSpotPatchMm = 1.5;
constexpr double kSurroundingsMm = 12.0;
constexpr float kMinLower = 0.03F;  // of brightness: about 0.1 mm of a typical layer
constexpr float kSpotSigmas = 8.0F;
constexpr double kMinMm2 = 1.0, kMaxMm2 = 150.0;
constexpr double kSpotRimMm = 4.0;  // around a contact

cv::Size window(double mm, const Eigen::Vector2d& mm_per_px) {
  const auto window_px = [](double px) { return 2 * std::max(1, static_cast<int>(px / 2)) + 1; };
  return {window_px(mm / mm_per_px.x()), window_px(mm / mm_per_px.y())};
}

/// Means over windows of the known part; NaN where that is less than `least` of the window.
cv::Mat means(const cv::Mat& x, const cv::Mat& known, const cv::Size& window, double least) {
  cv::Mat filled = x.clone(), weight, sum, count;
  filled.setTo(0.0F, ~known);
  known.convertTo(weight, CV_32F, 1.0 / 255);
  cv::boxFilter(filled, sum, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::boxFilter(weight, count, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::Mat mean = sum / cv::max(count, 1e-6);
  mean.setTo(std::numeric_limits<float>::quiet_NaN(), (count < least) | ~known);
  return mean;
}

float median_magnitude(const cv::Mat& x) {
  std::vector<float> magnitudes;
  for (int v = 0; v < x.rows; v += 2)
    for (int u = 0; u < x.cols; u += 2)
      if (const float value = x.at<float>(v, u); std::isfinite(value))
        magnitudes.push_back(std::abs(value));
  return magnitudes.empty() ? 0.0F : upper_median(magnitudes);
}

cv::Mat contrast(const cv::Mat& x, const cv::Mat& known, const Eigen::Vector2d& mm_per_px) {
  constexpr double kMostOfPatch = 0.5, kSomeOfSurroundings = 0.15;
  return means(x, known, window(kSpotPatchMm, mm_per_px), kMostOfPatch) -
         means(x, known, window(kSurroundingsMm, mm_per_px), kSomeOfSurroundings);
}

std::optional<Spot> lowest_spot(const cv::Mat& x,
                                const cv::Mat& known,
                                const Eigen::Vector2d& mm_per_px) {
  const cv::Mat higher = contrast(x, known, mm_per_px);
  const float limit = std::max(kMinLower, kSpotSigmas * 1.4826F * median_magnitude(higher));
  cv::Mat labels, stats, middles;
  const int count =
      cv::connectedComponentsWithStats(higher < -0.5F * limit, labels, stats, middles);
  std::optional<Spot> found;
  for (int label = 1; label < count; ++label) {
    const double area_mm2 = stats.at<int>(label, cv::CC_STAT_AREA) * mm_per_px.prod();
    if (area_mm2 < kMinMm2 || area_mm2 > kMaxMm2) continue;
    double least = 0;
    cv::minMaxLoc(higher, &least, nullptr, nullptr, nullptr, labels == label);
    if (-least < static_cast<double>(limit) || (found && -least < found->lower)) continue;
    found = Spot{-least, {middles.at<double>(label, 0), middles.at<double>(label, 1)}, area_mm2};
  }
  return found;
}

}  // namespace

std::optional<Spot> find_spot(const cv::Mat& x, const cv::Mat& known, const SpotSearch& search) {
  if (search.near_higher) return lowest_spot(x, known, search.mm_per_px);
  const cv::Mat lower = contrast(x, known, search.mm_per_px) <= kMinLower;
  cv::Mat higher_px;
  cv::distanceTransform(lower | ~known, higher_px, cv::DIST_L2, 3);
  const double rim_px = kSpotRimMm / std::sqrt(search.mm_per_px.prod());
  return lowest_spot(x, known & (higher_px > rim_px), search.mm_per_px);
}

}  // namespace alltact
