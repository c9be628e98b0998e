// The face unrolled into a grid of cells, rows across and columns along, with the lines of sight of
// its pixels.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <span>
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
  [[nodiscard]] double along_mm(int column) const { return first_s_ + (column + 0.5) * step_s_; }
  /// Of the cells in the middle of the face, from the first row of this part; not limited to it.
  [[nodiscard]] double middle_row() const { return middle_row_; }
  [[nodiscard]] const Sight& sight(int column) const {
    return sights_[static_cast<std::size_t>(column)];
  }
  /// Column of cells, limited to the first and last, of an image column.
  [[nodiscard]] int column_of(int u) const;
  /// Some of the cells, as if they were all.
  [[nodiscard]] UnrolledFace part(const cv::Rect& cells) const;

  /// An image (CV_32FC1, NaN where nothing is measured) at the pixels of the cells. Cells without a
  /// measurement take the nearest across the face, else along it; all 0 where there is none.
  /// `measured`: CV_8UC1, 255 where a cell has its own.
  [[nodiscard]] cv::Mat from_pixels(const cv::Mat& image, cv::Mat* measured = nullptr) const;
  /// Each of `all` (cells, CV_32FC1) at the pixels of an image of this size. Above and below the
  /// face all are 0.
  [[nodiscard]] std::vector<cv::Mat> to_pixels(std::span<const cv::Mat> all,
                                               const cv::Size& size) const;

 private:
  struct PixelColumns;
  [[nodiscard]] PixelColumns pixel_columns(const cv::Size& size) const;
  void tabulate_columns();
  void make_grid(double cell_mm);
  /// A table over the visible image columns, at a position along the face.
  [[nodiscard]] double along(const std::vector<double>& table, double s_mm) const;

  const FaceShape& shape_;
  // By visible image column, ascending along the face.
  std::vector<double> s_, u_, middle_v_, mm_per_px_;
  std::vector<double> shift_s_, shift_w_, shift_w_slope_, cos_;  // of the line of sight, in mm
  double half_w_ = 0, step_s_ = 1, step_w_ = 1;
  double first_s_ = 0, middle_row_ = 0;
  cv::Size size_;
  std::vector<Sight> sights_;  // by column of cells
};

}  // namespace alltact
