#include "calibration/reference/persistent_contact.h"

#include "calibration/reference/pose_brightness.h"
#include "calibration/reference/spots.h"
#include "core/numerics/median.h"

#include <cmath>
#include <limits>
#include <vector>

namespace alltact {
namespace {

constexpr int kMinCompared = 16;  // frames of the recording

/// Residuals of the recording's frames at poses that the earlier rows cover; NaN elsewhere.
PatchValues left_of(const SkinPatches& patches, const Eigen::MatrixXd& modes, int recorded) {
  const Eigen::MatrixXd terms = pose_terms_of(modes);
  std::vector<char> without(static_cast<std::size_t>(patches.frames()), 0);
  std::fill(without.begin(), without.begin() + recorded, 1);
  PoseBrightness fit(patches, terms);
  fit.fit_with_light(without);
  fit.fit_light();
  const std::vector<int> numbers(without.size());  // unused without a gap
  DeletedResiduals left = deleted_residuals(fit.residuals(), terms, without, numbers, -1);
  for (int i = 0; i < recorded; ++i)
    if (!(left.leverage[i] < kMaxLeverage))
      left.values.row(i).setConstant(std::numeric_limits<float>::quiet_NaN());
  return left.values.topRows(recorded);
}

/// By patch, a row for each position along the face; NaN where too few frames have a value.
cv::Mat medians_of(const PatchValues& left, const SkinPatches& patches) {
  cv::Mat medians(patches.along, patches.across, CV_32FC1, cv::Scalar(0));
  std::vector<float> known;
  for (int p = 0; p < patches.count(); ++p) {
    known.clear();
    for (Eigen::Index i = 0; i < left.rows(); ++i)
      if (std::isfinite(left(i, p))) known.push_back(left(i, p));
    medians.at<float>(p / patches.across, p % patches.across) =
        static_cast<int>(known.size()) < kMinCompared ? std::numeric_limits<float>::quiet_NaN()
                                                      : upper_median(known);
  }
  return medians;
}

}  // namespace

std::optional<PersistentContact> find_persistent_contact(const SkinPatches& patches,
                                                         const Eigen::MatrixXd& modes,
                                                         int recorded) {
  if (patches.frames() - recorded < kMinFittedFrames) return std::nullopt;
  const PatchValues left = left_of(patches, modes, recorded);
  const cv::Mat medians = medians_of(left, patches);
  const cv::Mat known = medians == medians;
  const auto spot = find_spot(medians, known, {.mm_per_px = {patches.across_mm, patches.along_mm}});
  if (!spot) return std::nullopt;
  PersistentContact touch;
  touch.darker = spot->lower;
  touch.along_mm = patches.begin_mm + (spot->centre_px.y() + 0.5) * patches.along_mm;
  touch.across_mm = (spot->centre_px.x() + 0.5) * patches.across_mm - 0.5 * patches.width_mm;
  const auto patch = static_cast<Eigen::Index>(std::lround(spot->centre_px.y()) * patches.across +
                                               std::lround(spot->centre_px.x()));
  float darkest = 0;
  for (int i = 0; i < recorded; ++i) {
    const float off = left(i, patch);
    touch.frames += off < -0.5 * spot->lower;
    if (off < darkest) darkest = off, touch.darkest = i;
  }
  return touch;
}

}  // namespace alltact
