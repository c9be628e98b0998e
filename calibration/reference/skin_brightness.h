// Brightness of the finger's skin in patches of a millimetre, the same skin in every frame of a
// recording.
#pragma once

#include "core/sensing/reference/reference_image.h"

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A row a frame, a column a patch: patch (i, j) is column i * across + j.
using PatchValues = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct SkinPatches {
  int along = 0, across = 0;           ///< number of patches from base to tip, and across
  double along_mm = 1, across_mm = 1;  ///< size of a patch
  double begin_mm = 0;                 ///< of the first, from the face's base; mostly before it
  double width_mm = 0;                 ///< of the face
  std::vector<float> pixels;           ///< of the grid, by patch
  /// Natural logarithm of the mean grey level. NaN where a frame does not show the full patch and 4
  /// mm of skin beyond it towards both ends, or it is too dark or clipped.
  PatchValues log_level;

  [[nodiscard]] int count() const { return along * across; }
  [[nodiscard]] Eigen::Index frames() const { return log_level.rows(); }
  /// From the face's base, as FaceShape::length_at.
  [[nodiscard]] double s_mm(int patch) const {
    return begin_mm + (patch / across + 0.5) * along_mm;
  }
  /// From the middle line, > 0 towards +y.
  [[nodiscard]] double y_mm(int patch) const {
    return (patch % across + 0.5) * across_mm - 0.5 * width_mm;
  }
};

/// Averages every recorded face over the patches of its grid. Patches are `patch_mm` long and about
/// as wide; those of fewer than 2 pixels of the grid stay empty.
[[nodiscard]] SkinPatches skin_patches(const FaceGrid& grid, const std::vector<FaceImage>& faces,
                                       double face_width_mm, double patch_mm = 1.0);

// Brightness of each patch of untouched skin in every pose of a recording, as a smooth function of
// the finger's modes.

/// Frames that the simplest fit needs: ten for each term.
inline constexpr int kMinFittedFrames = 64;
/// Maximum variance of the fit in a pose from noise, in units of a patch's own variance. Above it
/// the frames do not determine the pose (DeletedResiduals::leverage).
inline constexpr double kMaxPoseLeverage = 1.5;

/// Constant, linear and square terms of the leading modes, a row a frame. The number of terms is
/// limited by the frames (six for each term).
[[nodiscard]] Eigen::MatrixXd pose_terms_of(const Eigen::MatrixXd& modes);

/// The patches, merged two by two.
[[nodiscard]] SkinPatches coarser_patches(const SkinPatches& fine);

/// log level = terms * coefficients of the patch + light of the frame over the face (six terms in
/// position) + residual.
class PoseBrightness {
 public:
  /// Both arguments must outlive this.
  PoseBrightness(const SkinPatches& patches, const Eigen::MatrixXd& terms);

  /// Fits each patch over the frames outside `without`, one-sided: darker ones lose their weight.
  /// `from_bright`: starts from the upper envelope (asymmetric least squares), so that even half of
  /// the frames may be darker.
  void fit_one_sided(const std::vector<char>& without, bool from_bright);
  /// The same by least squares.
  void fit(const std::vector<char>& without);
  /// Fits the light of every frame to the residuals, one-sided.
  void fit_light();
  /// Least squares of patches and of the light of every frame, alternating.
  void fit_with_light(const std::vector<char>& without);
  void set_light_of(const PoseBrightness& other) { light_ = other.light_; }

  /// Residuals, < 0 darker: a row a frame; NaN where a patch is not shown, or by too few frames.
  [[nodiscard]] PatchValues residuals() const;
  /// Robust sd of each patch's residuals.
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

/// Residuals of a least squares fit as if the frame, and its neighbours in time, had been left out
/// of the fit.
struct DeletedResiduals {
  PatchValues values;
  /// By frame: the variance of the fit there from noise, in units of a patch's own variance
  /// (kMaxPoseLeverage).
  Eigen::VectorXd leverage;
};
/// gap: number of frames (by `numbers`) before and after that are left out too.
[[nodiscard]] DeletedResiduals deleted_residuals(const PatchValues& residuals,
                                                 const Eigen::MatrixXd& terms,
                                                 const std::vector<char>& without,
                                                 const std::vector<int>& numbers, int gap);

}  // namespace alltact
