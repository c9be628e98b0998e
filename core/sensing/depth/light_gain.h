// Lamps age, warm up and are dimmed: how the light differs from that of the recording, told by the
// skin that nothing touches.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/reference_picture.h"

#include <array>
#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// The light's change over the face, smooth: what the live picture must be multiplied with,
///   q(s, t) = 1 + c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2,
/// s and t the pixel's place within the face's bounding rectangle, -1 to 1.
class LightGain {
 public:
  static constexpr int kTerms = 6;

  using Covariance = Eigen::Matrix<double, kTerms, kTerms>;

  LightGain() = default;  ///< no change
  LightGain(const cv::Rect& face,
            const std::array<double, kTerms>& terms,
            double believed,
            double brighter = 0.0,
            double noise_ratio = 1.0,
            const Covariance& covariance = Covariance::Zero());

  /// Of row v, in ascending powers of the pixel's column.
  [[nodiscard]] std::array<float, 3> of_row(int v) const;
  [[nodiscard]] double at(double u, double v) const;

  /// By how much the light in the middle of the face is brighter than when it was recorded: 0.02
  /// for 2 %.
  [[nodiscard]] double change() const { return 1.0 / (1.0 + terms_[0]) - 1.0; }
  /// Part of the face that looks untouched, 0 to 1; the change was read from there.
  [[nodiscard]] double believed() const { return believed_; }
  /// Part of the face that is clearly brighter (5 %, and 5 sd) than its reference once the light is
  /// corrected: nearly none on the finger that was recorded, since what presses darkens.
  [[nodiscard]] double brighter() const { return brighter_; }
  /// How noisy untouched skin is against its reference, times what second differences promise; at
  /// least 1. Compression hides noise from those but leaves it in the means
  /// over some pixels, which this is told from.
  [[nodiscard]] double noise_ratio() const { return noise_ratio_; }
  /// Standard deviation of q at a pixel, by how well the untouched skin tells it.
  [[nodiscard]] double sd_at(double u, double v) const;

 private:
  std::array<double, kTerms> terms_{};
  double middle_u_ = 0, middle_v_ = 0, half_u_ = 1, half_v_ = 1;
  double believed_ = 0, brighter_ = 0, noise_ratio_ = 1;
  Covariance covariance_ = Covariance::Zero();
};

/// Fits q robustly to the ratio of both pictures, in blocks of some pixels. Skin that is pressed or
/// bulges stands out and does not count, as long as a third of the face is untouched; where it
/// darkens by more than 5 %, a tenth is enough: what presses only darkens, so that no light may
/// leave so much of the face brighter than its reference. The smaller the untouched part, the
/// simpler the change is taken to be. A change of the light that looks like a contact is not seen,
/// nor a contact that is as wide and as even as a change of the light.
/// grey: CV_8UC1 of the reference's size. noise_sd, noise_gain: grey levels of one picture, by
/// which blocks are weighed, and the reference's against it. told_sd: what second differences
/// promise, from which noise_ratio() and sd_at() are told; it changes nothing else. No change where
/// the face cannot be compared.
[[nodiscard]] LightGain light_gain(const cv::Mat& grey,
                                   const ReferencePicture& reference,
                                   const FaceRuns& face,
                                   double noise_sd,
                                   double noise_gain,
                                   std::optional<double> told_sd = std::nullopt);

}  // namespace alltact
