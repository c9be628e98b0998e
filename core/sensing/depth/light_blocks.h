// Small blocks of the face with their brightness ratio to the reference; the light's change is
// fitted to them.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/reference_image.h"

#include <array>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

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
  [[nodiscard]] LightEquations equations(const LightTerms& terms,
                                         double tukey,
                                         double widening) const;

 private:
  std::vector<double> s_, t_, ratio_, noise_, sd_;
};

/// About `block_count` blocks of the face, which lies within `bounds`. noise_sd: noise of one
/// image, grey levels. noise_gain: the reference's noise relative to it. floor: errors of
/// references apart from noise.
[[nodiscard]] LightBlocks light_blocks(const cv::Mat& grey,
                                       const ReferenceImage& reference,
                                       const FaceRuns& face,
                                       const cv::Rect& bounds,
                                       double block_count,
                                       double noise_sd,
                                       double noise_gain,
                                       double floor);

}  // namespace alltact
