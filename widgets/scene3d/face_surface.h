// The face of one frame as a grid of points with the same layout for every frame.
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
  bool is_seen = true;   ///< false: its position is an estimate
};

/// Vertices evenly over the face in the image: columns between its first and last, rows between its
/// edges. All matrices have the grid's size; millimetres in the camera frame, z > 0.
struct FaceSurface {
  cv::Mat untouched_mm;  ///< CV_32FC3, finite: the outer side without contact
  cv::Mat depth_mm;      ///< CV_32FC1 along z, NaN where there is none
  cv::Mat pixel;         ///< CV_32FC2: pixel of each vertex in the image (u, v)
  /// Per column: mm along the face from its base (FaceShape::length_at). Empty: not known.
  std::vector<double> along_mm;
  /// True for a finger, which has side faces behind its face; a flat sensor has none.
  bool has_body = false;
  std::vector<SurfaceMarker> markers;
  [[nodiscard]] int columns() const { return untouched_mm.cols; }
  [[nodiscard]] int rows() const { return untouched_mm.rows; }
};

/// Normal of the outer side as it is drawn by `grid` (CV_32FC3): unit, towards the camera. Column
/// and row of the grid.
[[nodiscard]] Eigen::Vector3d inward_normal(const cv::Mat& grid, int column, int row);

/// nullopt where the frame has no face, or no depth. Depth is interpolated between pixels.
///   columns, rows: at least 2
[[nodiscard]] std::optional<FaceSurface> face_surface(const FrameResult& result,
                                                      const Face& face,
                                                      int columns,
                                                      int rows);

/// The same for a finger without calibration: depth is NaN everywhere.
[[nodiscard]] std::optional<FaceSurface> uncalibrated_surface(const FrameResult& result,
                                                              const Face& face,
                                                              int columns,
                                                              int rows);

/// Columns and rows for about `vertices` vertices, as square as the face's image allows. They are
/// at least the frame's mesh_step_px apart, unless that is the default of 1.
[[nodiscard]] cv::Size grid_for(const FrameResult& result, int vertices);

}  // namespace alltact
