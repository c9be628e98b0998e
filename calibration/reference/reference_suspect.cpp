#include "calibration/reference/reference_suspect.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kSuspectPatchMm = 1.5;
constexpr double kSurroundingsMm = 12.0;
constexpr float kLeastBrighter = 0.03F;  // about 0.1 mm of a usual layer
constexpr float kSigmas = 8.0F;
constexpr double kLeastMm2 = 1.0, kMostMm2 = 150.0;
constexpr double kRimMm = 4.0;   // around something that presses
constexpr double kEdgePx = 4.0;  // beside the face's edges a shift of a tenth of a pixel shows

int odd(double px) {
  return 2 * std::max(1, static_cast<int>(px / 2)) + 1;
}

/// Means over squares of the known part; NaN where that is less than half.
cv::Mat means(const cv::Mat& x, const cv::Mat& known, int side) {
  cv::Mat filled = x.clone(), weight, sum, count;
  filled.setTo(0.0F, ~known);
  known.convertTo(weight, CV_32F, 1.0 / 255);
  cv::boxFilter(filled, sum, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::boxFilter(weight, count, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::Mat mean = sum / cv::max(count, 1e-6);
  mean.setTo(std::numeric_limits<float>::quiet_NaN(), (count < 0.5F) | ~known);
  return mean;
}

/// 255 in columns of the face, away from its edges, where x is known.
cv::Mat inner_face(const cv::Mat& x, const FaceShape& shape) {
  cv::Mat inner(x.size(), CV_8UC1, cv::Scalar(0));
  for (int u = 0; u < x.cols; ++u) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    const int first = std::max(0, static_cast<int>(std::ceil(column.upper_v + kEdgePx))),
              last = std::min(x.rows - 1, static_cast<int>(column.lower_v - kEdgePx));
    for (int v = first; v <= last; ++v)
      if (std::isfinite(x.at<float>(v, u))) inner.at<std::uint8_t>(v, u) = 255;
  }
  return inner;
}

}  // namespace

std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                       const Reference& reference,
                                                       const FaceShape& shape) {
  if (!reference.known_pose || difference.x.empty()) return std::nullopt;
  std::vector<double> depths;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) depths.push_back(column.z_mm);
  if (depths.empty()) return std::nullopt;
  const double mm_per_px = shape.camera().mm_per_px_at(upper_median(depths));
  const cv::Mat known = inner_face(difference.x, shape);
  const cv::Mat patch = means(difference.x, known, odd(kSuspectPatchMm / mm_per_px));
  const cv::Mat darker = patch - means(difference.x, known, odd(kSurroundingsMm / mm_per_px));
  std::vector<float> usual;
  for (int v = 0; v < darker.rows; v += 2)
    for (int u = 0; u < darker.cols; u += 2)
      if (const float value = darker.at<float>(v, u); std::isfinite(value))
        usual.push_back(std::abs(value));
  const float limit = std::max(kLeastBrighter, kSigmas * 1.4826F * upper_median(usual));
  const cv::Mat bright = darker < -0.5F * limit;
  cv::Mat pressed;
  cv::dilate(darker > limit,
             pressed,
             cv::getStructuringElement(cv::MORPH_ELLIPSE,
                                       {odd(2 * kRimMm / mm_per_px), odd(2 * kRimMm / mm_per_px)}));
  cv::Mat labels, stats, middles;
  const int count = cv::connectedComponentsWithStats(bright, labels, stats, middles);
  std::optional<ReferenceSuspect> found;
  for (int label = 1; label < count; ++label) {
    const double area_mm2 = stats.at<int>(label, cv::CC_STAT_AREA) * mm_per_px * mm_per_px;
    if (area_mm2 < kLeastMm2 || area_mm2 > kMostMm2) continue;
    const cv::Mat spot = labels == label;
    double least = 0;
    cv::minMaxLoc(darker, &least, nullptr, nullptr, nullptr, spot);
    const bool is_rim = cv::countNonZero(spot & pressed) > 0;
    if (is_rim || -least < static_cast<double>(limit) || (found && -least < found->brighter))
      continue;
    const int u =
        std::clamp(static_cast<int>(middles.at<double>(label, 0)), 0, shape.width_px() - 1);
    found = ReferenceSuspect{-least, shape.length_at(u), area_mm2, reference.frame};
  }
  return found;
}

Message sentence_of(const ReferenceSuspect& suspect) {
  return en::say(
      "the face is {:.0f} % brighter than its reference {:.0f} mm from the base: something pressed "
      "there when the reference was recorded, near its frame {}; record the reference again",
      100.0 * suspect.brighter,
      suspect.along_mm,
      suspect.frame);
}

}  // namespace alltact
