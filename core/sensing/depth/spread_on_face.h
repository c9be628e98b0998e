// What spread light makes of the brightness differences of a face, and back, by cells of the
// unrolled face (light_spread.h has the model). In single precision, as it is done for every frame.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/unrolled_face.h"

#include <algorithm>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Curves of even layers.

constexpr double kLeastDenominator = 0.1;  ///< the curves' poles are not reached

/// Depth of an even layer on the curve of thickness rho T, mm.
template <class Real>
[[nodiscard]] inline Real depth_on_curve(Real y, Real b, Real thickness_mm) {
  return thickness_mm * (1 + b) * y / std::max(Real(kLeastDenominator), 1 + b * y);
}

/// Its slope.
template <class Real>
[[nodiscard]] inline Real depth_per_difference(Real y, Real b, Real thickness_mm) {
  const Real denominator = std::max(Real(kLeastDenominator), 1 + b * y);
  return thickness_mm * (1 + b) / (denominator * denominator);
}

template <class Real>
[[nodiscard]] inline Real difference_at_depth(Real depth_mm, Real b, Real thickness_mm) {
  const Real full = thickness_mm * (1 + b);
  return depth_mm / std::max(Real(kLeastDenominator) * full, full - b * depth_mm);
}

/// rho T of a mapping.
[[nodiscard]] inline double thickness_of(const MappingParameters& mapping) {
  return mapping.a_mm / (1.0 + mapping.b);
}

/// Removal raises detail, and noise, by no more than (1 - (1 - core)^9) / core: it takes the core
/// for larger where that is much.
[[nodiscard]] double core_for_removal(double core);

/// The skirt's light on a face: q, on a grid of half as many rows and columns.
class SkirtLight {
 public:
  /// `core`: by columns of this grid.
  SkirtLight(const UnrolledFace& face, double width_mm, std::vector<float> core);

  /// q of cells that would show y on even layers: r q - width^2 laplace q = r e.
  void set(const cv::Mat& y);
  /// A step towards the q for which it holds for the y that are seen through it: `y`, on this
  /// grid, are those seen through the present q.
  void approach(const cv::Mat& seen_x, const cv::Mat& y);

  [[nodiscard]] const cv::Size& size() const { return size_; }
  [[nodiscard]] const cv::Mat& q() const { return q_; }

 private:
  void solve(double middle, const cv::Mat& sources);

  cv::Size size_;
  cv::Mat q_, bending_;  // width^2 times the square of a wave's number, by the transform's waves
  std::vector<float> core_;
};

class SpreadOnFace {
 public:
  enum class Core { kOfLight, kForRemoval };
  /// `layer_mm`: thickness.
  SpreadOnFace(const UnrolledFace& face, const MappingParameters& mapping, double layer_mm,
               Core core);

  [[nodiscard]] float b(int column) const { return columns_.b[static_cast<std::size_t>(column)]; }

  /// y of each cell, and the x at the pixel whose core it is.
  struct Cells {
    cv::Mat y, seen_x;
  };
  /// From x by cells (CV_32FC1).
  [[nodiscard]] Cells undo(const cv::Mat& x);
  /// x by cells, of y by cells.
  [[nodiscard]] cv::Mat seen(const cv::Mat& y);

  /// By columns of cells: displacement of the lines of sight through the layer, in cells
  /// (UnrolledFace::Sight), and their spread.
  struct Columns {
    std::vector<float> along, across, across_slope, core, skirt_shift, b;
  };

 private:
  void tabulate_seeing();
  [[nodiscard]] float across_of(std::size_t column, float row) const;
  [[nodiscard]] std::size_t nearest(float column) const;
  void undo_rows(const cv::Mat& x, bool is_half, Cells* cells) const;

  float middle_row_, layer_mm_, thickness_mm_;
  Columns columns_;
  std::vector<float> half_b_;  // of every two columns
  SkirtLight skirt_;
  std::vector<float> seeing_;  // column of the pixel that sees a column, by column and part
};

}  // namespace alltact
