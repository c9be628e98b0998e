// The face of one frame as a grid of points with the same layout for every frame.
#pragma once

#include "core/sensing/frame_result.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
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
[[nodiscard]] std::optional<FaceSurface> face_surface(const FrameResult& result, const Face& face,
                                                      int columns, int rows);

/// The same for a finger without calibration: depth is NaN everywhere.
[[nodiscard]] std::optional<FaceSurface> uncalibrated_surface(const FrameResult& result,
                                                              const Face& face, int columns,
                                                              int rows);

/// Columns and rows for about `vertices` vertices, as square as the face's image allows. They are
/// at least the frame's mesh_step_px apart, unless that is the default of 1.
[[nodiscard]] cv::Size grid_for(const FrameResult& result, int vertices);

// Image pixels, positions in a face's grid, and ray intersections with it.

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

// The finger's body behind its face as far as it is known, and a stand-in for the rest. Inside this
// folder and its tests only.

/// Cross-sections of a Fin Ray from its base to its tip; mm, in the camera's frame.
///
/// Known: the face with its bend, sway and twist, and the side faces. These stand straight behind
/// its edges as far as the dots engraved in them lie. Not known, and drawn plainly: the back and
/// the base. The back is, at the base, as deep as the camera sits behind the face. From there it
/// thins evenly to the tip, but is nowhere less deep than the dots. The base is a plain block.
struct FingerBody {
  /// Corners in order round the section, looking from the base to the tip or from the tip to the
  /// base: face at row 0, face at the last row, and behind these the back.
  using Section = std::array<Eigen::Vector3d, 4>;
  std::vector<Section> sections;  ///< empty: no body
  /// The base's block: its two ends, the second one where the face begins.
  std::array<Section, 2> base;
  /// All corners, for fitting the view.
  [[nodiscard]] std::vector<Eigen::Vector3d> corners() const;
};

/// Empty for a flat sensor.
[[nodiscard]] FingerBody body_of(const FaceSurface& surface);

}  // namespace alltact
