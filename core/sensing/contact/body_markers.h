// The finger as a beam that is clamped at its base: its middle line, and the positions of the
// markers in it.
#pragma once

#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Motion of the finger, mm. With t from 0 at the base to 1 at the tip its middle line bends by q1
/// t^2 + q2 (t^3 - t^2), as loads near the tip and near the base bend it. It sways by q3 t^2; its
/// sections rotate with it.
using BeamModes = Eigen::Vector3d;

/// A point of the middle line, in the x-z plane and in y, and its slope there.
struct LinePose {
  double x = 0, z = 0, y = 0, theta = 0;
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();  ///< from the line's own points alone
};

inline constexpr int kBeamCells = 24;  ///< along the finger
/// The middle line in even steps of its length, from base to tip.
using MiddleLine = std::array<LinePose, kBeamCells + 1>;

/// Length of the face from its base to its tip, as FaceShape::length_at counts; 0 where unknown.
[[nodiscard]] double base_to_tip_mm(const FaceShape& shape);

/// A marker's position in the finger.
struct BodyPosition {
  bool is_known = false;
  double cells = 0;    ///< along the finger, from 0 to kBeamCells
  double side_mm = 0;  ///< from the middle line, in y
  double off_mm = 0;   ///< behind the face
};

/// The markers in the finger, and their image positions when it moves. Their distance behind the
/// face is fitted per row as a line along the finger, because markers that are seen edge on do not
/// determine it.
class BodyMarkers {
 public:
  /// nullopt: a flat sensor, or a face of which too little is seen. The shape must outlive it.
  [[nodiscard]] static std::optional<BodyMarkers> create(const Markers& markers,
                                                         const FaceShape& shape);

  [[nodiscard]] const std::vector<BodyPosition>& positions() const { return positions_; }
  [[nodiscard]] double length_mm() const { return length_mm_; }
  /// Unit vector, camera frame: mean over the markers, weighted by their share of the tip's
  /// displacement.
  [[nodiscard]] Eigen::Vector3d towards_back() const;

  /// Image positions (u0, v0, u1, ...) of all markers before the modes moved the finger to its
  /// current shape; 0 for markers without a position.
  [[nodiscard]] Eigen::VectorXd pixels_before(const BeamModes& q_mm) const;
  /// Derivative of these with respect to each mode at `q_mm`, px/mm.
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3> motions_px(const BeamModes& q_mm) const;
  /// Derivative of the current positions with respect to a twist about the finger's length that
  /// grows evenly along it, px per rad at the tip.
  [[nodiscard]] Eigen::VectorXd twist_px() const;

 private:
  BodyMarkers(const FaceShape& shape, double length_mm) : shape_(&shape), length_mm_(length_mm) {}
  void find_setback(const Markers& markers);
  [[nodiscard]] double foot_cells(double x, double z) const;
  void locate(const Marker& marker, BodyPosition& position) const;
  [[nodiscard]] Eigen::Vector3d point_of(const BodyPosition& position,
                                         const MiddleLine& line) const;
  [[nodiscard]] double off_at(double cells) const {
    return setback_mm_[0] + setback_mm_[1] * (cells / kBeamCells - 0.5);
  }

  const FaceShape* shape_;
  double length_mm_;
  MiddleLine line_;
  std::vector<BodyPosition> positions_;
  Eigen::Vector2d setback_mm_ = Eigen::Vector2d::Zero();
};

}  // namespace alltact
