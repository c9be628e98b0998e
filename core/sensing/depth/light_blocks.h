// Small pieces of the face, each with how bright it is against its reference: what the light's
// change is told from.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/reference_picture.h"

#include <array>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

constexpr int kLightTerms = 6;
using LightTerms = Eigen::Matrix<double, kLightTerms, 1>;

/// 1, s, t, s^2, s t, t^2 of a place within the face's bounding rectangle, -1 to 1.
[[nodiscard]] inline LightTerms light_basis(double s, double t) {
  LightTerms basis;
  basis << 1.0, s, t, s * s, s * t, t * t;
  return basis;
}

struct LightBlock {
  double s = 0, t = 0;          ///< place, -1 to 1
  double ratio = 0, noise = 0;  ///< live over reference, and its white noise
  double sd = 0;                ///< with what references are off by apart from it
};

/// What a step of least squares needs, sums over the blocks that are believed.
struct LightEquations {
  Eigen::Matrix<double, kLightTerms, kLightTerms> normal;
  LightTerms pull;
  double believed = 0;  ///< sum of the blocks' shares, 0 to 1 each
};

/// Blocks, number by number.
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

  /// Of the step that follows `terms`, which weighs each block by Tukey's biweight of how far it is
  /// off, in `tukey` times its sd together with `widening`.
  [[nodiscard]] LightEquations equations(const LightTerms& terms,
                                         double tukey,
                                         double widening) const;

 private:
  std::vector<double> s_, t_, ratio_, noise_, sd_;
};

/// About `most` blocks of the face, which lies within `bounds`. noise_sd, noise_gain: of one
/// picture, grey levels, and the reference's against it; floor: what references are off by, apart
/// from noise.
[[nodiscard]] LightBlocks light_blocks(const cv::Mat& grey,
                                       const ReferencePicture& reference,
                                       const FaceRuns& face,
                                       const cv::Rect& bounds,
                                       double most,
                                       double noise_sd,
                                       double noise_gain,
                                       double floor);

}  // namespace alltact
