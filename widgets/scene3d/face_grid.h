// Image pixels, positions in a face's grid, and ray intersections with it.
#pragma once

#include "widgets/scene3d/face_surface.h"

#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace alltact {

/// Column and row of the grid, with fractions, at a pixel; the grid's edge for a pixel a little
/// outside; nullopt off the face.
[[nodiscard]] std::optional<cv::Point2d> grid_position_of(const FaceSurface& surface,
                                                          cv::Point2d pixel);

/// A grid's value between four vertices. `grid`: CV_32FC2 or CV_32FC3; the position lies inside it.
[[nodiscard]] cv::Vec2f pixel_between(const cv::Mat& grid, cv::Point2d position);
[[nodiscard]] cv::Vec3f point_between(const cv::Mat& grid, cv::Point2d position);

/// Bounding boxes of a grid's triangles, so that a ray tests few of them.
class GridBoxes {
 public:
  /// drawn_mm: CV_32FC3, finite; shared, and must not change.
  explicit GridBoxes(const cv::Mat& drawn_mm);
  /// First intersection of a ray with the grid's triangles, as column and row with fractions.
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
