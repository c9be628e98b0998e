// Pixels of the picture, places in a face's grid, and rays through it.
#pragma once

#include "widgets/scene3d/face_surface.h"

#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace alltact {

/// Column and row of the grid, with fractions, where a pixel lies, or its edge where a pixel
/// lies a little outside; nullopt off the face.
[[nodiscard]] std::optional<cv::Point2d> grid_place_of(const FaceSurface& surface,
                                                       cv::Point2d pixel);

/// A grid's value between four vertices. `grid`: CV_32FC2 or CV_32FC3; place inside it.
[[nodiscard]] cv::Vec2f pixel_between(const cv::Mat& grid, cv::Point2d place);
[[nodiscard]] cv::Vec3f point_between(const cv::Mat& grid, cv::Point2d place);

/// A grid's triangles in boxes, so that a ray looks at few of them.
class GridBoxes {
 public:
  /// drawn_mm: CV_32FC3, finite; shared, and must stay as it is.
  explicit GridBoxes(const cv::Mat& drawn_mm);
  /// Where a ray first meets the grid's triangles, as column and row with fractions.
  [[nodiscard]] std::optional<cv::Point2d> first_hit(const Eigen::Vector3d& from,
                                                     const Eigen::Vector3d& direction) const;

 private:
  struct Box {
    cv::Rect cells;  // four vertices each
    Eigen::AlignedBox3d bounds;
  };
  cv::Mat drawn_mm_;
  std::vector<Box> boxes_;
};

/// The same for one ray.
[[nodiscard]] std::optional<cv::Point2d> first_hit(const cv::Mat& drawn_mm,
                                                   const Eigen::Vector3d& from,
                                                   const Eigen::Vector3d& direction);

}  // namespace alltact
