// The geometry of one frame: the face, what presses into it, the dots on the side faces.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/simulation/face_curve.h"
#include "core/simulation/illumination.h"
#include "core/simulation/mechanics/ball_contact.h"
#include "core/simulation/mechanics/point_force.h"
#include "core/simulation/press.h"
#include "core/simulation/row_view.h"
#include "core/simulation/simulated_frame.h"

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

// Displacement of a side face, with its dots, under a push.

struct SideDrag {
  int side = -1;         ///< -1: upper (small v), +1: lower
  SurfaceFrame surface;  ///< at the contact's centre
  HalfSpaceContact contact;
};

/// Displacement of a side face's point under all pushes on that face; camera frame, mm.
[[nodiscard]] inline Eigen::Vector3d side_displacement_mm(const std::vector<SideDrag>& drags,
                                                          int side,
                                                          const Eigen::Vector3d& point_mm) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const SideDrag& drag : drags) {
    if (drag.side != side) continue;
    const SurfaceFrame& at = drag.surface;
    const Eigen::Vector3d from = point_mm - at.point_mm;
    const Eigen::Vector3d moved =
        drag.contact.displacement_mm({from.dot(at.along), from.dot(at.across)});
    sum += moved.x() * at.along + moved.y() * at.across + moved.z() * at.into;
  }
  return sum;
}

/// A dot engraved on a side face, as it appears in the image.
struct MarkerDisc {
  int side;                   ///< -1: upper (small v), +1: lower
  Eigen::Vector2d centre_px;  ///< of its image
  bool visible;
  double albedo;
  cv::Point corner;          ///< top left pixel of `coverage`
  cv::Mat_<float> coverage;  ///< fraction of each pixel that the dot covers
};

/// Changes the layer's thickness `luf_mm` along z in the face's columns.
using LayerChange = std::function<void(const FaceRow& face, RowScratch& scratch, float* luf_mm)>;

/// The view face of one frame for a given camera, and the additions of effects.
class FrameGeometry {
 public:
  /// Fin Ray: an integrated curve. Flat: nullopt, the plane face.plane_z_mm.
  FrameGeometry(const PixelRays& rays, const Face& face, std::optional<FaceCurve> curve);

  [[nodiscard]] const PixelRays& rays() const { return rays_; }
  [[nodiscard]] const Face& face() const { return face_; }
  /// nullptr for a flat sensor.
  [[nodiscard]] const FaceCurve* curve() const { return curve_ ? &*curve_ : nullptr; }

  /// A point of the body by its position along and across the view face and its depth behind it
  /// (towards the camera). Also the directions along the face and away from the camera there.
  struct BodyPoint {
    Eigen::Vector3d point_mm, along, normal;
  };
  [[nodiscard]] BodyPoint body_point(double s_mm, double across_mm, double behind_mm) const;

  /// The LUF (undeformed outer side) over a position of the view face.
  [[nodiscard]] Eigen::Vector3d luf_point_mm(double s_mm, double across_mm) const;

  /// The pose of a press; for a flat sensor s is x and y is y.
  [[nodiscard]] PressPose press_pose(double s_mm, double y_mm, double depth_mm) const;

  /// Maximum thickness of the undeformed layer along z over the image.
  [[nodiscard]] double max_thickness_mm() const;

  std::vector<std::variant<BallPress, BodyPress, SampledPress>> presses;
  std::vector<ContactTruth> contacts;  ///< objects that press on the finger
  std::vector<SideDrag> drags;         ///< drags on the side faces
  std::vector<MarkerDisc> discs;       ///< by number
  std::vector<LayerChange> layer_changes;
  Illumination illumination;

  /// False: rows are intersected ray by ray, because the face is twisted or behind a window.
  [[nodiscard]] bool is_column_wise() const;
  /// Fills row.face, the press depth and the view face's surface.
  void fill(RowView& row) const;

 private:
  struct Columns {
    AlignedFloats x, z, sin, cos, luf, shift, s, end, per_mm, normal_z, zero;
    void resize(std::size_t n);
  };
  void set_columns(const std::vector<double>& origin_x, const std::vector<double>& direction_x);
  void set_column(std::size_t i, double direction_x, double s_mm, const FaceCurve::Node& point);
  void find_bands();
  void fill_linear(RowView& row, float* light) const;
  void fill_by_table(RowView& row, float* light) const;
  [[nodiscard]] Surface fill_by_columns(RowView& row) const;
  [[nodiscard]] Surface fill_by_rays(RowView& row) const;
  void fill_presses(RowView& row) const;

  const PixelRays& rays_;
  Face face_;
  std::optional<FaceCurve> curve_;
  // By column, or by direction for a camera with distortion. Empty where the column alone does not
  // determine the intersection: see is_column_wise().
  Columns columns_;
  double table_first_ = 0, table_per_direction_ = 0;
  static constexpr int kBlock = 16;
  std::vector<int> row_first_, row_last_;  // columns that the face may cover, by row
};

// Rigid presses as grids, for effects of the layer.

/// Samples the press's depth on a grid of face positions, 0.05 mm apart, or coarser so that the
/// body spans at most 600 steps.
[[nodiscard]] SampledPress sample_press(const BodyPress& press, const FrameGeometry& geometry);

/// All rigid presses of a frame.
void sample_bodies(FrameGeometry& geometry);

/// Adds `steps` without a press on every side of the grid.
void pad_grid(SampledPress& press, int steps);

}  // namespace alltact
