// The face of one frame as a grid of points that is the same whatever the frame.
#pragma once

#include "core/sensing/pipeline.h"

#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Vertices evenly over the face in the picture: columns between its first and last, rows between
/// its edges. All pictures here have the grid's size; millimetres in the camera frame, z > 0.
struct FaceSurface {
  cv::Mat untouched_mm;  ///< CV_32FC3, finite: the outer side as it would be if nothing pressed
  cv::Mat depth_mm;      ///< CV_32FC1 along z, NaN where there is none
  cv::Mat pixel;         ///< CV_32FC2: where each vertex lies in the picture (u, v)
  [[nodiscard]] int columns() const { return untouched_mm.cols; }
  [[nodiscard]] int rows() const { return untouched_mm.rows; }
};

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
