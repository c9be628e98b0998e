// A Fin Ray finger as an elastic body of four modes.
#pragma once

#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/simulation/face_curve.h"
#include "core/simulation/mechanics/point_force.h"
#include "core/simulation/mechanics/rubber.h"

#include <span>

#include <Eigen/Core>

namespace alltact {

/// Two walls of equal thickness along the finger, one behind the view face and one at the back,
/// joined by ribs. The body tapers evenly from base to tip.
struct FinRayGeometry {
  double length_mm = 0, width_mm = 0;
  double layer_mm = 0;  ///< the soft layer before the view face, which carries no bending
  double wall_mm = 0;
  double base_depth_mm = 0, tip_depth_mm = 0;  ///< from the view face to the back face
  /// Fraction of the shear between the walls that the ribs carry. 0: the walls slide past each
  /// other like two leaves of a spring. 1: they bend as one, like the skins of a sandwich. One push
  /// with a known force determines it.
  double coupling = 0;

  [[nodiscard]] double depth_mm(double s_mm) const {
    return base_depth_mm + (tip_depth_mm - base_depth_mm) * s_mm / length_mm;
  }
};

/// q1 and q2 (bend), sway in mm, and the twist of the tip in rad, as FaceCurve has them.
using BodyModes = Eigen::Vector4d;

/// Background. FaceCurve bends without stretching, by t^2 and t^3 - t^2 (t = s / L), leans aside by
/// t^2 and twists evenly. In these modes the curvature w'', the walls' curvatures in their own
/// plane y'' and the twist per length phi' are linear in q, so that the energy is q' K q / 2 with
///   K = integral of E I w_i'' w_j'' + E (b W^3 / 12) sum over the walls of y_i'' y_j''
///       + (4/3) E I phi_i' phi_j',
///   I(s) = 2 W (b^3 / 12 + coupling * b D^2 / 4),
/// b the wall's thickness, W the width, D(s) = depth - b the distance of the walls' middles. 4 I is
/// the torsion constant of plates and of sandwiches, G = E / 3; the back wall, at depth D behind
/// the front one, shifts by D phi where the section twists. (S. Timoshenko and S. Woinowsky-
/// Krieger, Theory of Plates and Shells; J. R. Vinson, The Behavior of Sandwich Structures.)
///
/// Left out: shear of the layer and of the walls, ribs that bend, the clear filling between the
/// ribs, local buckling. Two modes bend a little less than the beam does: a tapered body's tip
/// under a force there by up to 5 %, an even one's not at all.
class FinRayBody {
 public:
  /// Modulus in MPa. Error: a length or the modulus is not above 0, the walls overlap, or the
  /// coupling is not from 0 to 1.
  static Result<FinRayBody> create(const FinRayGeometry& geometry, double modulus_MPa);

  [[nodiscard]] const FinRayGeometry& geometry() const { return geometry_; }
  [[nodiscard]] double modulus_MPa() const { return modulus_MPa_; }
  /// Symmetric and positive definite; N/mm for lengths, N mm for the twist.
  [[nodiscard]] const Eigen::Matrix4d& stiffness() const { return stiffness_; }
  [[nodiscard]] double energy_Nmm(const BodyModes& q) const { return 0.5 * q.dot(stiffness_ * q); }

 private:
  FinRayBody(const FinRayGeometry& geometry, double modulus_MPa);

  FinRayGeometry geometry_;
  double modulus_MPa_;
  Eigen::Matrix4d stiffness_;
};

/// A body on a face that is already bent, under forces.
class PushedFinger {
 public:
  /// Limits of the model: rotation of the face anywhere, rad; twist of the tip, rad; lateral shift
  /// as a share of the length.
  static constexpr double kMaxTurn = 1.2, kMaxTwist = 1.2, kMaxSway = 0.4;

  /// `rest`: the face without the forces, as long as the body. It must outlive this object and need
  /// not be integrated.
  PushedFinger(const FinRayBody& body, const FaceCurve& rest) : body_(body), rest_(rest) {}

  /// A surface point when the body is deformed by q.
  [[nodiscard]] SurfaceFrame surface(const PointForce& at, const BodyModes& q) const;

  /// Generalised force on the modes: sum of force . d(point)/dq, at q.
  [[nodiscard]] BodyModes generalised_force(std::span<const PointForce> forces,
                                            const BodyModes& q) const;

  struct Equilibrium {
    BodyModes q = BodyModes::Zero();
    /// Fraction of the forces that is carried; below 1 they exceed the limits above.
    double share = 1;
  };
  /// The q with K (q - before) = weight * generalised force at q, reached from `before` with
  /// growing forces. (1, 0) is the elastic body at rest; KelvinChain uses other values.
  [[nodiscard]] Equilibrium equilibrium(std::span<const PointForce> forces, double weight = 1,
                                        const BodyModes& before = BodyModes::Zero()) const;

 private:
  const FinRayBody& body_;
  const FaceCurve& rest_;
};

// The rubber of a finger, as a scene gives it.

struct ElasticFinger {
  double modulus_MPa = 0;
  double wall_mm = 0, base_depth_mm = 0, tip_depth_mm = 0, coupling = 0;  ///< as in FinRayGeometry
  KelvinChain chain;

  /// Error: these parameters do not make a body of that face.
  [[nodiscard]] Result<FinRayBody> body(const Face& face, double length_mm) const;
};

}  // namespace alltact
