// Change of the light since the recording, for instance from ageing or dimmed lamps. It is fitted
// to the skin without contact.
#pragma once

#include "core/sensing/face/face_pixels.h"
#include "core/sensing/reference/reference_image.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Smooth change of the light over the face: the factor for the live image,
///   q(s, t) = 1 + c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2,
/// with s and t the pixel's position within the face's bounding rectangle, -1 to 1.
class LightGain {
 public:
  static constexpr int kTerms = 6;

  using Covariance = Eigen::Matrix<double, kTerms, kTerms>;

  LightGain() = default;  ///< no change
  LightGain(const cv::Rect& face, const std::array<double, kTerms>& terms, double inlier_fraction,
            double brighter = 0.0, double noise_ratio = 1.0,
            const Covariance& covariance = Covariance::Zero());

  /// Of row v, in ascending powers of the pixel's column.
  [[nodiscard]] std::array<float, 3> of_row(int v) const;
  [[nodiscard]] double at(double u, double v) const;

  /// Relative brightness of the light in the middle of the face against the recording, minus 1:
  /// 0.02 for 2 %.
  [[nodiscard]] double change() const { return 1.0 / (1.0 + terms_[0]) - 1.0; }
  /// Fraction of the face without contact, 0 to 1, to which the change was fitted.
  [[nodiscard]] double inlier_fraction() const { return inlier_fraction_; }
  /// Fraction of the face that is clearly brighter (3 %, and 5 sd) than its reference after the
  /// correction. Nearly 0 on the recorded finger, since contacts darken.
  [[nodiscard]] double brighter() const { return brighter_; }
  /// Noise of contact-free skin against its reference, relative to the estimate from second
  /// differences; at least 1. Compression hides noise from second differences but leaves it in
  /// means over some pixels, from which this ratio is estimated.
  [[nodiscard]] double noise_ratio() const { return noise_ratio_; }
  /// Standard deviation of q at a pixel, from the covariance of the fit.
  [[nodiscard]] double sd_at(double u, double v) const;

 private:
  std::array<double, kTerms> terms_{};
  double middle_u_ = 0, middle_v_ = 0, half_u_ = 1, half_v_ = 1;
  double inlier_fraction_ = 0, brighter_ = 0, noise_ratio_ = 1;
  Covariance covariance_ = Covariance::Zero();
};

/// Fits q robustly to the ratio of both images, in blocks of some pixels. Skin that is pressed or
/// bulges is an outlier as long as a third of the face is free. A tenth is enough where contacts
/// darken by more than 3 %: no light may leave so much of the face brighter than its reference. The
/// smaller the free part, the stronger the prior towards a constant change. A change of the light
/// that resembles a contact is not found. A contact as wide and even as a change of the light is
/// taken for one.
/// grey: CV_8UC1 of the reference's size. noise_sd: noise of one image, grey levels, which weights
/// the blocks. noise_gain: the reference's noise relative to it. estimated_sd: noise from second
/// differences; only noise_ratio() and sd_at() depend on it. Returns no change where the face
/// cannot be compared.
[[nodiscard]] LightGain light_gain(const cv::Mat& grey, const ReferenceImage& reference,
                                   const FaceRuns& face, double noise_sd, double noise_gain,
                                   std::optional<double> estimated_sd = std::nullopt);

// Small blocks of the face with their brightness ratio to the reference; the light's change is
// fitted to them.

constexpr int kLightTerms = 6;
using LightTerms = Eigen::Matrix<double, kLightTerms, 1>;

/// 1, s, t, s^2, s t, t^2 of a position within the face's bounding rectangle, -1 to 1.
[[nodiscard]] inline LightTerms light_basis(double s, double t) {
  LightTerms basis;
  basis << 1.0, s, t, s * s, s * t, t * t;
  return basis;
}

struct LightBlock {
  double s = 0, t = 0;          ///< position, -1 to 1
  double ratio = 0, noise = 0;  ///< live over reference, and its white noise
  double sd = 0;                ///< noise and the reference's other errors together
};

/// Normal equations of one step of least squares, summed over the inlier blocks.
struct LightEquations {
  Eigen::Matrix<double, kLightTerms, kLightTerms> normal;
  LightTerms pull;
  double inlier_sum = 0;  ///< sum of the blocks' robust weights, 0 to 1 each
};

/// Blocks as a structure of arrays.
class LightBlocks {
 public:
  void add(const LightBlock& block);

  [[nodiscard]] std::size_t size() const { return s_.size(); }
  [[nodiscard]] bool empty() const { return s_.empty(); }
  [[nodiscard]] LightBlock operator[](std::size_t i) const {
    return {s_[i], t_[i], ratio_[i], noise_[i], sd_[i]};
  }
  [[nodiscard]] const std::vector<double>& ratios() const { return ratio_; }
  [[nodiscard]] const std::vector<double>& noises() const { return noise_; }

  /// Normal equations of the next step from `terms`. Tukey's biweight weighs each block by its
  /// residual, with `tukey` times its sd combined with `widening` as the limit.
  [[nodiscard]] LightEquations equations(const LightTerms& terms, double tukey,
                                         double widening) const;

 private:
  std::vector<double> s_, t_, ratio_, noise_, sd_;
};

/// About `block_count` blocks of the face, which lies within `bounds`. noise_sd: noise of one
/// image, grey levels. noise_gain: the reference's noise relative to it. floor: errors of
/// references apart from noise.
[[nodiscard]] LightBlocks light_blocks(const cv::Mat& grey, const ReferenceImage& reference,
                                       const FaceRuns& face, const cv::Rect& bounds,
                                       double block_count, double noise_sd, double noise_gain,
                                       double floor);

}  // namespace alltact
