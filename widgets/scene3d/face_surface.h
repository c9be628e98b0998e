// The face of one frame as a grid of points that is the same whatever the frame.
#pragma once

#include "core/sensing/pipeline.h"

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// An engraved dot on one of the side faces.
struct SurfaceMarker {
  Eigen::Vector3d at_mm;
  double column = 0;     ///< of the grid, with fractions
  double behind_mm = 0;  ///< from the outer side of the face, along the side face
  bool is_seen = true;   ///< false: its place is an estimate
};

/// Vertices evenly over the face in the picture: columns between its first and last, rows between
/// its edges. All pictures here have the grid's size; millimetres in the camera frame, z > 0.
struct FaceSurface {
  cv::Mat untouched_mm;  ///< CV_32FC3, finite: the outer side as it would be if nothing pressed
  cv::Mat depth_mm;      ///< CV_32FC1 along z, NaN where there is none
  cv::Mat pixel;         ///< CV_32FC2: where each vertex lies in the picture (u, v)
  /// Of each column: mm along the face from its base (FaceShape::length_at). Empty: not known.
  std::vector<double> along_mm;
  /// A finger's face, with side faces behind it; a flat sensor is its face alone.
  bool has_body = false;
  std::vector<SurfaceMarker> markers;
  [[nodiscard]] int columns() const { return untouched_mm.cols; }
  [[nodiscard]] int rows() const { return untouched_mm.rows; }
};

/// Of the outer side as it is drawn by `grid` (CV_32FC3): unit, towards the camera. Column and row
/// of the grid.
[[nodiscard]] Eigen::Vector3d inward_normal(const cv::Mat& grid, int column, int row);

/// nullopt where the frame has no face, or no depth. Depth is interpolated between pixels.
///   columns, rows: at least 2
[[nodiscard]] std::optional<FaceSurface> face_surface(const FrameResult& result,
                                                      const Face& face,
                                                      int columns,
                                                      int rows);

/// The same of a finger without calibration: depth is NaN everywhere.
[[nodiscard]] std::optional<FaceSurface> bare_surface(const FrameResult& result,
                                                      const Face& face,
                                                      int columns,
                                                      int rows);

/// Columns and rows for about `vertices` vertices that are as square as the face's picture allows,
/// no nearer to each other than the frame's mesh_step_px, but at the default of 1.
[[nodiscard]] cv::Size grid_for(const FrameResult& result, int vertices);

}  // namespace alltact
