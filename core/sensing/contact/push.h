// Measures how far and from which side the finger is pushed, from the markers alone. From when on
// this is a contact: see finger_contact.h.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct Push {
  Eigen::Vector2d offset_px =
      Eigen::Vector2d::Zero();  ///< o': sum over markers of position - rest position
  Eigen::Matrix2d offset_covariance_px2 = Eigen::Matrix2d::Zero();
  /// Only of an offset above ContactSettings::threshold_px: unit offset in the image plane, its
  /// standard deviation, and the face whose inward normal is nearest. Contact is +u (towards the
  /// tip), back -u, upper +v, lower -v.
  std::optional<Eigen::Vector3d> direction;
  std::optional<double> sd_deg;  ///< of offset_covariance_px2 across the direction, over |o'|
  std::optional<PushedFace> face;
};

/// Covariance (4n x 4n) of the markers' displacements from rest. `now_px2` is that of their current
/// positions (MarkerModel::covariance_px2); without it each has its own sd_px. The covariance of
/// the rest layout, one frame of the recording, is added. Each marker has the same sd there as now;
/// a marker that is not seen now has the mean of the seen ones.
[[nodiscard]] Eigen::MatrixXd displacement_covariance_px2(
    const Markers& markers, const std::optional<Eigen::MatrixXd>& now_px2 = std::nullopt);

/// `displacement_cov_px2`: the above; empty: without now_px2. Returns no direction and offset 0
/// where the markers are not those of the settings, or one has no position.
[[nodiscard]] Push push_of(const Markers& markers, const ContactSettings& settings,
                           bool base_at_low_u, const Eigen::MatrixXd& displacement_cov_px2 = {});

// The finger as a beam that is clamped at its base: its middle line, and the positions of the
// markers in it.

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

// Estimates the deflection of a finger from its markers and their rest positions.

/// Displacement of the finger's tip, in its own section: towards its back (as a push on the contact
/// face moves it) and towards +y (as one on the upper face does), mm.
struct TipDisplacement {
  Eigen::Vector2d displacement_mm = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_mm2 = Eigen::Matrix2d::Zero();
  Eigen::Vector3d towards_back = Eigen::Vector3d::Zero();  ///< unit, camera frame, near the tip
  BeamModes modes_mm = BeamModes::Zero();                  ///< motion from rest
};

/// Finds the motion after which the markers, moved back, lie at their rest positions. The finger is
/// a beam that is clamped at its base, does not stretch, and moves in BeamModes. The current shape
/// of the face gives the curve to unbend and the distance of the markers behind the face.
/// Generalised least squares over the markers with `displacement_cov_px2`, by Gauss-Newton. q2,
/// which does not move the tip, has a prior from bodies of all stiffnesses.
/// A millimetre has the same weight in both directions, unlike in the image. The covariance holds
/// the markers' noise and an error of modes and face of 0.005 of the displacement. The stiffness
/// ratio between the directions is unknown: the result is the direction of motion, not of the
/// force. nullopt: a flat sensor, markers that are not those of `rest`, or too few for both
/// directions.
[[nodiscard]] std::optional<TipDisplacement> tip_displacement(
    const Markers& markers, const std::vector<Eigen::Vector2d>& rest, const FaceShape& shape,
    const Eigen::MatrixXd& displacement_cov_px2);

// Estimates how far from its base the finger is pushed on its back, from the markers alone.
//
// BACKGROUND
// On the contact face the indentation shows the position of a contact. On the back only the
// markers' motion does: the nearer to the base the push, the more of the bend lies near the base. A
// beam that is clamped there moves in BeamModes by q = K^-1 f, with the stiffness EI(t)
//   K = integral of EI w_i'' w_j'',  f = (t^2, t^3 - t^2) of a push at t,
// so that q2 / q1 determines t: about -1.3 at a quarter of the length, -0.8 in the middle, -0.2 at
// the tip. How EI falls towards the tip was not measured. Two walls that ribs join have
//   EI = 1 - falls + falls D^2,  D the walls' distance, which falls to about a quarter,
// with falls from two thirds (ribs that carry a hundredth of the shear) to nearly 1 (all of it).
// Several values are taken as equally likely. Near 0.6 of the length all agree; a third of the
// length from there they differ by a tenth of it. A drag along the finger of up to 0.15 of the
// force is marginalised likewise. The likelihood of each position is that of the markers' motion,
// over all of these parameters. The results are the mean and the standard deviation. They hold for
// such a body, not for one that is cut out, clamped elsewhere, or leans on something else too.
//
// NOT THE SIDES
// A push on a side has no observable position along it. Three methods were tried:
// - Walls bend evenly in their own plane. Their q2 / q1 goes from -0.8 at a quarter of the length
//   to -0.5 at the tip. Half a millimetre of model error changes it by as much, and the depth of
//   the push behind the face by half of that.
// - Twist over sway is the push's distance behind the face divided by its position along, of which
//   the first is equally unknown.
// - Soft material yields locally around the contact (Boussinesq: 0.02 mm at 8 mm from 1 N on rubber
//   of Shore 40 A), which would determine the position to 10 mm. The residual of sway and twist
//   after beam and shape is larger: on simulated fingers the position was 45 mm off, at 0.2 to 1 N.

/// Position along the face from the origin of its length (FaceShape::length_at).
struct AlongFinger {
  double mm = 0, sd_mm = 0;
};

/// A position with a greater sd than this share of the finger's length is not reported. Equally
/// likely positions over all of the length have 0.26 of it.
inline constexpr double kMaxAlongSd = 0.13;

/// For a push on the back. `displacement`: tip_displacement() of the same markers, `rest`, shape
/// and covariance. nullopt: the push is too small to determine its position, or bends the finger
/// beyond the range of modes and shape.
[[nodiscard]] std::optional<AlongFinger> push_along_back(
    const Markers& markers, const std::vector<Eigen::Vector2d>& rest, const FaceShape& shape,
    const Eigen::MatrixXd& displacement_cov_px2, const TipDisplacement& displacement);

}  // namespace alltact
