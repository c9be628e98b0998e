// How bright each patch of untouched skin is in every pose of a recording, as a smooth function of
// the finger's modes.
#pragma once

#include "calibration/reference/skin_patches.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Frames that the simplest fit needs: ten for each term.
inline constexpr int kLeastFittedFrames = 64;
/// The variance that noise may give a fit in a pose, in units of a patch's own; beyond that the
/// frames say too little of the pose (DeletedResiduals::leverage).
inline constexpr double kMostLeverage = 1.5;

/// Constant, linear and square terms of the leading modes, a row a frame, as many as the frames can
/// bear (six for each term).
[[nodiscard]] Eigen::MatrixXd pose_terms_of(const Eigen::MatrixXd& modes);

/// The patches by twos.
[[nodiscard]] SkinPatches coarser_patches(const SkinPatches& fine);

/// log level = terms * coefficients of the patch + light of the frame over the face (six terms in
/// place) + what is left.
class PoseBrightness {
 public:
  /// Both must live as long.
  PoseBrightness(const SkinPatches& patches, const Eigen::MatrixXd& terms);

  /// Fits each patch over the frames that are not `without`, one-sided: darker ones lose their
  /// weight. `from_bright`: starts from the upper envelope (asymmetric least squares), so that even
  /// half of the frames may be darker.
  void fit_one_sided(const std::vector<char>& without, bool from_bright);
  /// The same by least squares.
  void fit(const std::vector<char>& without);
  /// Fits the light of every frame to what is left, one-sided.
  void fit_light();
  /// By least squares, the light of every frame, and again.
  void fit_with_light(const std::vector<char>& without);
  void set_light_of(const PoseBrightness& other) { light_ = other.light_; }

  /// What is left, < 0 darker: a row a frame; NaN where a patch is not shown, or not by nearly all
  /// frames.
  [[nodiscard]] PatchValues residuals() const;
  /// Of what is left of each patch, robust.
  [[nodiscard]] const std::vector<float>& sd() const { return sd_; }

 private:
  void fit_patch(int patch, const std::vector<char>& without, bool from_bright);
  void fit_light_of(Eigen::Index frame);
  [[nodiscard]] double level(Eigen::Index frame, int patch) const {
    return static_cast<double>(patches_.log_level(frame, patch)) -
           light_.row(frame).dot(light_basis_.row(patch));
  }

  const SkinPatches& patches_;
  const Eigen::MatrixXd& terms_;
  Eigen::MatrixXd light_, light_basis_;  // a row a frame; a row a patch
  std::vector<float> sd_;
  std::vector<int> usable_;  // patches
  PatchValues fitted_;
};

/// Residuals of a least squares fit as they would be if the frame, and those around it in time, had
/// had no part in it.
struct DeletedResiduals {
  PatchValues values;
  /// By frame: the variance that noise gives the fit there, in units of a patch's own
  /// (kMostLeverage).
  Eigen::VectorXd leverage;
};
/// gap: frames (by `numbers`) before and after that have no part either.
[[nodiscard]] DeletedResiduals deleted_residuals(const PatchValues& residuals,
                                                 const Eigen::MatrixXd& terms,
                                                 const std::vector<char>& without,
                                                 const std::vector<int>& numbers,
                                                 int gap);

}  // namespace alltact
