// The face unrolled into a grid of cells, rows across and columns along, with the lines of sight of
// its pixels.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Where a pixel's line of sight leads within the layer.
struct SightInLayer {
  Eigen::Vector2d displacement_mm;  ///< along the face and across it, through the entire layer
  double cos_sight = 1;             ///< between the line of sight and the normal
};
/// nullopt off the face.
[[nodiscard]] std::optional<SightInLayer> sight_in_layer(const FaceShape& shape, double u,
                                                         double v);

class UnrolledFace {
 public:
  /// The lines of sight of a column of cells. A pixel's line of sight is displaced through the
  /// layer by `along` columns, and by across + across_slope * (rows from the middle) rows.
  struct Sight {
    double along = 0, across = 0, across_slope = 0;
    double cos_sight = 1;
  };

  /// Even numbers of cells of about this size. `shape` must outlive it.
  UnrolledFace(const FaceShape& shape, double cell_mm);

  /// Hardly any of the face is visible.
  [[nodiscard]] bool is_empty() const { return s_.size() < 2 || !(s_.back() > s_.front()); }
  [[nodiscard]] const cv::Size& size() const { return size_; }
  [[nodiscard]] double step_along_mm() const { return step_s_; }
  [[nodiscard]] double step_across_mm() const { return step_w_; }
  [[nodiscard]] double along_mm(int column) const { return s_.front() + (column + 0.5) * step_s_; }
  [[nodiscard]] double middle_row() const { return 0.5 * size_.height - 0.5; }
  [[nodiscard]] const Sight& sight(int column) const {
    return sights_[static_cast<std::size_t>(column)];
  }
  /// Column of cells, limited to the first and last, of an image column.
  [[nodiscard]] int column_of(int u) const;

  /// An image (CV_32FC1, NaN where nothing is measured) at the pixels of the cells. Cells without a
  /// measurement take the nearest across the face, else along it; all 0 where there is none.
  [[nodiscard]] cv::Mat from_pixels(const cv::Mat& image) const;
  /// Cells (CV_32FC1) at the pixels.
  [[nodiscard]] cv::Mat to_pixels(const cv::Mat& cells, const cv::Size& size) const;

 private:
  void tabulate_columns();
  void make_grid(double cell_mm);
  /// A table over the visible image columns, at a position along the face.
  [[nodiscard]] double along(const std::vector<double>& table, double s_mm) const;

  const FaceShape& shape_;
  // By visible image column, ascending along the face.
  std::vector<double> s_, u_, middle_v_, mm_per_px_;
  std::vector<double> shift_s_, shift_w_, shift_w_slope_, cos_;  // of the line of sight, in mm
  double half_w_ = 0, step_s_ = 1, step_w_ = 1;
  cv::Size size_;
  std::vector<Sight> sights_;  // by column of cells
};

}  // namespace alltact
