// The middle line of a view face: straight, or an inextensible curve given by its slope angle.
#pragma once

#include "core/simulation/mechanics/point_force.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Parametrised by arc length s in the x-z plane, from the base (s = 0) to the tip. Undeformed, it
/// is the straight line, without nodes and without summation error. Effects add to the slope angle
/// and to the lateral shift at the nodes; integrate() computes the curve. Between nodes everything
/// is a cubic Hermite curve. It is exact for quadratic slope angles and within 1e-11 mm for fingers
/// of this size. Beyond the ends the curve continues straight.
class FaceCurve {
 public:
  static constexpr int kCells = 256;

  struct Node {
    double theta = 0;     ///< slope angle, rad: dx/ds = cos, dz/ds = sin
    double theta_s = 0;   ///< its derivative along s, rad/mm
    double shift_mm = 0;  ///< of the middle line in y
    double shift_s = 0;   ///< its derivative along s
    double twist = 0;     ///< angle of the section about the tangent, rad: +y moves away from z = 0
    double twist_s = 0;   ///< its derivative along s
    double x_mm = 0, z_mm = 0;
    double x_s = 1, z_s = 0;  ///< cos and sin of theta, after integrate()
  };

  FaceCurve(const Eigen::Vector3d& base_mm, double incline_rad, double length_mm);

  [[nodiscard]] double length_mm() const { return length_mm_; }
  [[nodiscard]] double s_mm(int node) const { return node * cell_mm_; }
  /// kCells + 1 of them; empty for an undeformed face.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// True: the slope changes by at most 0.1 rad within each cell.
  [[nodiscard]] bool has_small_turns() const { return has_small_turns_; }
  /// Mutable access: the face becomes a curve.
  [[nodiscard]] Node& node(int i);
  [[nodiscard]] bool is_straight() const { return !is_bent_; }

  /// Adds the deflection q1 t^2 + q2 (t^3 - t^2) along the undeformed face's normal, t = s /
  /// length. The slope angle changes by its derivative.
  void bend(double q1_mm, double q2_mm);

  /// Shifts the middle line in y by sway t^2, t = s / length; a straight face stays straight.
  void sway(double sway_mm);

  /// Rotates the section at s by tip_rad s / length about the curve; the middle line does not move.
  void twist(double tip_rad);
  [[nodiscard]] bool is_twisted() const { return is_twisted_; }

  /// Unit vector across the face at a node, towards +y: cos(twist) y + sin(twist) n. n = (-z_s, 0,
  /// x_s) is the untwisted normal, away from the camera. normal() is that of the twisted section.
  [[nodiscard]] static Eigen::Vector3d across(const Node& p);
  [[nodiscard]] static Eigen::Vector3d normal(const Node& p);

  /// Loads on the finger, until the body responds to them.
  std::vector<FaceLoad> loads;
  /// Deflection under the loads: q1, q2 and sway in mm, twist in rad.
  std::optional<Eigen::Vector4d> response;

  /// Integrates the slope angle (three-point Gauss in each cell). Required before the functions
  /// below.
  void integrate();

  /// Where lines cross it, line by line; s_mm is NaN where one does not.
  struct Intersections {
    std::vector<double> s_mm, x_mm, z_mm, x_s, z_s, shift_mm;
  };
  /// intersect() and at() of the lines x = origin_x_mm[i] + z * direction_x[i]: the same points
  /// within 1e-12 mm, many at a time. For neighbouring lines, as the columns of an image.
  [[nodiscard]] Intersections intersect_all(const std::vector<double>& origin_x_mm,
                                            const std::vector<double>& direction_x) const;

  /// The curve at arc length s; any s is allowed.
  [[nodiscard]] Node at(double s_mm) const;

  /// The s where the curve crosses the line x = origin_x + z * direction_x; NaN when it does not
  /// with z > 0. Lines that graze the face (cos - direction_x sin <= 0.02) do not cross it.
  [[nodiscard]] double intersect(double origin_x_mm, double direction_x) const;

 private:
  void make_nodes();
  void find_unique_directions();
  [[nodiscard]] Node along_line(double s_mm) const;
  [[nodiscard]] double z_at(double s_mm) const;
  [[nodiscard]] std::vector<int> cells_hit(const std::vector<double>& origin_x_mm,
                                           const std::vector<double>& direction_x) const;

  double length_mm_, cell_mm_;
  Node base_;
  bool is_bent_ = false, is_twisted_ = false;
  bool has_small_turns_ = true;  // within every cell
  // Lines with a direction between these two cross the curve at most once, and their distances from
  // the nodes change sign at most once.
  double unique_low_ = 0, unique_high_ = 0;
  std::vector<Node> nodes_;  // empty for an undeformed face
};

// Interpolation between the nodes of a curve.

/// Cubic Hermite interpolation on a cell of width h, t in [0, 1]: values f and derivatives d at its
/// ends.
inline double hermite(double f0, double d0, double f1, double d1, double h, double t) {
  const double u = 1 - t;
  return u * u * (f0 * (1 + 2 * t) + h * d0 * t) + t * t * (f1 * (3 - 2 * t) - h * d1 * u);
}

/// Cosine and sine of an angle `by` beyond one with known cosine and sine, |by| <= kSeriesTurn: the
/// series, within 3e-17, and the addition theorems.
inline constexpr double kSeriesTurn = 0.1;
struct TurnedDirection {
  double cos, sin;
};
inline TurnedDirection turned(double cos, double sin, double by) {
  const double by2 = by * by;
  const double s =
      by - by * by2 * (1.0 / 6 - by2 * (1.0 / 120 - by2 * (1.0 / 5040 - by2 / 362880)));
  const double c = by2 * (1.0 / 2 - by2 * (1.0 / 24 - by2 * (1.0 / 720 - by2 / 40320)));  // 1 - cos
  return {cos - (cos * c + sin * s), sin - (sin * c - cos * s)};
}

}  // namespace alltact
