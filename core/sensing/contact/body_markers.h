// The finger as a beam that is held at its base: its middle line, and where in it the markers sit.
#pragma once

#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// How far the finger moved, mm. With t from 0 at the base to 1 at the tip its middle line bends by
/// q1 t^2 + q2 (t^3 - t^2), as load near the tip or near the base bends it, and shifts aside by
/// q3 t^2; its sections turn with it.
using BeamModes = Eigen::Vector3d;

/// A place of the middle line, in the x-z plane and in y, and its slope there.
struct LinePlace {
  double x = 0, z = 0, y = 0, theta = 0;
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();  ///< of the line's own places alone
};

inline constexpr int kBeamCells = 24;  ///< along the finger
/// The middle line in even steps of its length, from base to tip.
using MiddleLine = std::array<LinePlace, kBeamCells + 1>;

/// Of the face from its base to its tip, as FaceShape::length_at counts; 0 where it is not told.
[[nodiscard]] double whole_length_mm(const FaceShape& shape);

/// A marker's place in the finger.
struct BodyPlace {
  bool is_known = false;
  double cells = 0;    ///< along the finger, from 0 to kBeamCells
  double side_mm = 0;  ///< from the middle line, in y
  double off_mm = 0;   ///< behind the face
};

/// The markers in the finger, and where they lie in the picture when it moves. How far behind the
/// face they stand is told as a row does, by a line along the finger, since one that is seen edge
/// on does not tell it.
class BodyMarkers {
 public:
  /// nullopt: a flat sensor, or a face of which too little is seen. The shape must live as long.
  [[nodiscard]] static std::optional<BodyMarkers> create(const Markers& markers,
                                                         const FaceShape& shape);

  [[nodiscard]] const std::vector<BodyPlace>& places() const { return places_; }
  [[nodiscard]] double length_mm() const { return length_mm_; }
  /// Unit, camera frame, at the places of the markers on average, by their share in the tip's way.
  [[nodiscard]] Eigen::Vector3d towards_back() const;

  /// Picture places (u0, v0, u1, ...) of all markers before the modes moved the finger to where it
  /// is; 0 of those that lie nowhere.
  [[nodiscard]] Eigen::VectorXd seen_before(const BeamModes& q_mm) const;
  /// How these change with each mode about `q_mm`, px/mm.
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3> motions_px(const BeamModes& q_mm) const;
  /// How they change now when sections turn about the finger's length, evenly along it, px for a
  /// turn of 1 rad at the tip.
  [[nodiscard]] Eigen::VectorXd twist_px() const;

 private:
  BodyMarkers(const FaceShape& shape, double length_mm) : shape_(&shape), length_mm_(length_mm) {}
  void find_setback(const Markers& markers);
  [[nodiscard]] double foot_cells(double x, double z) const;
  void place(const Marker& marker, BodyPlace& place) const;
  [[nodiscard]] Eigen::Vector3d point_of(const BodyPlace& place, const MiddleLine& line) const;
  [[nodiscard]] double off_at(double cells) const {
    return setback_mm_[0] + setback_mm_[1] * (cells / kBeamCells - 0.5);
  }

  const FaceShape* shape_;
  double length_mm_;
  MiddleLine line_;
  std::vector<BodyPlace> places_;
  Eigen::Vector2d setback_mm_ = Eigen::Vector2d::Zero();
};

}  // namespace alltact
