// Brightness of the finger's skin in patches of a millimetre, the same skin in every frame of a
// recording.
#pragma once

#include "core/sensing/reference/face_image.h"

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
[[nodiscard]] SkinPatches skin_patches(const FaceGrid& grid,
                                       const std::vector<FaceImage>& faces,
                                       double face_width_mm,
                                       double patch_mm = 1.0);

}  // namespace alltact
