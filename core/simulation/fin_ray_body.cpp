#include "core/simulation/fin_ray_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace alltact {
namespace {

// Gauss-Legendre on [0, 1]: 16 points integrate such small bends to rounding.
constexpr std::array<double, 8> kBodyGaussPoint{
    0.0950125098376374, 0.2816035507792589, 0.4580167776572274, 0.6178762444026438,
    0.7554044083550030, 0.8656312023878318, 0.9445750230732326, 0.9894009349916499};
constexpr std::array<double, 8> kBodyGaussWeight{
    0.1894506104550685, 0.1826034150449236, 0.1691565193950025, 0.1495959888165767,
    0.1246289712555339, 0.0951585116824928, 0.0622535239386479, 0.0271524594117541};

template <class Add>
void for_gauss_points(const Add& add) {
  for (std::size_t i = 0; i < kBodyGaussPoint.size(); ++i)
    for (const double side : {-1.0, 1.0})
      add(0.5 + 0.5 * side * kBodyGaussPoint[i], 0.5 * kBodyGaussWeight[i]);
}

// The slope angle that q1 = 1 and q2 = 1 add at t, times the length.
Eigen::Vector2d turn_of_bend(double t) { return {2 * t, t * (3 * t - 2)}; }

struct MaterialPoint {
  double across_mm, out_mm;  // from the view face's middle line, in its section
};

MaterialPoint material_point(const FinRayGeometry& g, const PointForce& at) {
  const double depth = g.depth_mm(at.s_mm);
  switch (at.face) {
    case PushedFace::kContact:
      return {at.across_mm, g.layer_mm};
    case PushedFace::kBack:
      return {at.across_mm, -depth};
    case PushedFace::kUpper:
      return {-g.width_mm / 2, at.across_mm - depth / 2};
    case PushedFace::kLower:
      break;
  }
  return {g.width_mm / 2, at.across_mm - depth / 2};
}

// The undeformed face from its base to a section, common to all q.
struct RestPath {
  double s_mm, length_mm;
  Eigen::Vector3d middle_mm;  // x and z of the base, y of the section
  double theta, twist;        // of the section
  std::array<double, 2 * kBodyGaussPoint.size()> path_theta;
  [[nodiscard]] double t() const { return s_mm / length_mm; }
};

RestPath rest_path(const FaceCurve& rest, double s_mm) {
  const FaceCurve::Node base = rest.at(0), here = rest.at(s_mm);
  RestPath path{s_mm,       rest.length_mm(), {base.x_mm, here.shift_mm, base.z_mm},
                here.theta, here.twist,       {}};
  auto* next = path.path_theta.data();
  for_gauss_points([&](double part, double) { *next++ = rest.at(part * s_mm).theta; });
  return path;
}

// A section of the deformed finger, and its derivatives by q1 and q2.
struct DeformedSection {
  Eigen::Vector3d middle_mm, along, across, out;
  Eigen::Matrix<double, 3, 2> middle_q;
  Eigen::Vector2d turn_q;
};

DeformedSection section_at(const RestPath& rest, const BodyModes& q) {
  const double length = rest.length_mm, t = rest.t();
  const Eigen::Vector2d bend = q.head<2>() / length;
  DeformedSection result;
  result.middle_mm = rest.middle_mm + q[2] * t * t * Eigen::Vector3d::UnitY();
  result.middle_q.setZero();
  const auto* theta = rest.path_theta.data();
  for_gauss_points([&](double part, double weight) {
    const Eigen::Vector2d turn = turn_of_bend(part * t);
    const double angle = *theta++ + turn.dot(bend), step = weight * rest.s_mm;
    const Eigen::Vector3d tangent(std::cos(angle), 0, std::sin(angle));
    const Eigen::Vector3d turned(-tangent.z(), 0, tangent.x());
    result.middle_mm += step * tangent;
    result.middle_q += step / length * turned * turn.transpose();
  });
  FaceCurve::Node here;
  const double angle = rest.theta + turn_of_bend(t).dot(bend);
  here.x_s = std::cos(angle);
  here.z_s = std::sin(angle);
  here.twist = rest.twist + q[3] * t;
  result.along = {here.x_s, 0, here.z_s};
  result.across = FaceCurve::across(here);
  result.out = FaceCurve::normal(here);
  result.turn_q = turn_of_bend(t) / length;
  return result;
}

SurfaceFrame frame_of(const DeformedSection& section, const MaterialPoint& at, PushedFace face) {
  SurfaceFrame frame;
  frame.point_mm = section.middle_mm + at.across_mm * section.across + at.out_mm * section.out;
  frame.along = section.along;
  const bool is_side = face == PushedFace::kUpper || face == PushedFace::kLower;
  frame.across = is_side ? section.out : section.across;
  const Eigen::Vector3d outwards = is_side ? section.across : section.out;
  const bool is_positive = face == PushedFace::kContact || face == PushedFace::kLower;
  frame.into = is_positive ? Eigen::Vector3d(-outwards) : outwards;
  return frame;
}

// d(point)/dq. The section's axes rotate about y with theta and about the tangent with the twist.
Eigen::Matrix<double, 3, 4> point_q(const DeformedSection& section, const MaterialPoint& at,
                                    double t) {
  const Eigen::Vector3d untwisted(-section.along.z(), 0, section.along.x());
  const double out_mm =
      at.across_mm * section.across.dot(untwisted) + at.out_mm * section.out.dot(untwisted);
  Eigen::Matrix<double, 3, 4> result;
  result.leftCols<2>() = section.middle_q - out_mm * section.along * section.turn_q.transpose();
  result.col(2) = t * t * Eigen::Vector3d::UnitY();
  result.col(3) = t * (at.across_mm * section.out - at.out_mm * section.across);
  return result;
}

// A force with everything that does not depend on q.
struct PreparedForce {
  PointForce force;
  MaterialPoint at;
  RestPath rest;
};

std::vector<PreparedForce> prepared(std::span<const PointForce> forces,
                                    const FinRayGeometry& geometry, const FaceCurve& rest) {
  std::vector<PreparedForce> result;
  for (const PointForce& force : forces)
    result.push_back({force, material_point(geometry, force), rest_path(rest, force.s_mm)});
  return result;
}

BodyModes sum_of(const std::vector<PreparedForce>& forces, const BodyModes& q) {
  BodyModes sum = BodyModes::Zero();
  for (const PreparedForce& prepared : forces) {
    const DeformedSection section = section_at(prepared.rest, q);
    const SurfaceFrame frame = frame_of(section, prepared.at, prepared.force.face);
    sum += point_q(section, prepared.at, prepared.rest.t()).transpose() *
           frame.vector_N(prepared.force);
  }
  return sum;
}

bool is_within_limits(const BodyModes& q, double length_mm) {
  if (!q.allFinite() || std::abs(q[3]) > PushedFinger::kMaxTwist ||
      std::abs(q[2]) > PushedFinger::kMaxSway * length_mm)
    return false;
  // The slope is a parabola over t; eight samples give its maximum closely enough.
  for (int i = 1; i <= 8; ++i)
    if (std::abs(turn_of_bend(i / 8.0).dot(q.head<2>())) > PushedFinger::kMaxTurn * length_mm)
      return false;
  return true;
}

// Lengths in units of the finger's.
double relative_size(const BodyModes& q, double length_mm) {
  return q.cwiseQuotient(BodyModes(length_mm, length_mm, length_mm, 1)).cwiseAbs().maxCoeff();
}

// Solves K (q - before) = weight * share * forces from q on, by Newton's method with numeric
// derivatives of the forces. False: no solution within the limits; q is unchanged.
bool find_equilibrium(const Eigen::Matrix4d& stiffness, const std::vector<PreparedForce>& forces,
                      double length_mm, double weight, const BodyModes& before, BodyModes& q) {
  BodyModes x = q;
  for (int i = 0; i < 40; ++i) {
    Eigen::Matrix4d slope = stiffness;
    for (int j = 0; j < 4; ++j) {
      BodyModes step = BodyModes::Zero();
      step[j] = 1e-5 * (j < 3 ? length_mm : 1.0);
      slope.col(j) -=
          weight / (2 * step[j]) * (sum_of(forces, x + step) - sum_of(forces, x - step));
    }
    const BodyModes change =
        slope.partialPivLu().solve(stiffness * (x - before) - weight * sum_of(forces, x));
    if (!change.allFinite()) return false;
    const double size = relative_size(change, length_mm);
    x -= change * std::min(1.0, 0.2 / std::max(size, 1e-300));
    if (!is_within_limits(x, length_mm)) return false;
    if (size < 1e-11) {
      q = x;
      return true;
    }
  }
  return false;
}

}  // namespace

FinRayBody::FinRayBody(const FinRayGeometry& g, double modulus_MPa)
    : geometry_(g), modulus_MPa_(modulus_MPa), stiffness_(Eigen::Matrix4d::Zero()) {
  const double length = g.length_mm, b = g.wall_mm;
  const double wall_in_plane = modulus_MPa * b * std::pow(g.width_mm, 3) / 12;
  for_gauss_points([&](double t, double weight) {
    const double distance = g.depth_mm(t * length) - b;
    const double distance_s = (g.tip_depth_mm - g.base_depth_mm) / length;
    const double bending =
        modulus_MPa * 2 * g.width_mm * (b * b * b / 12 + g.coupling * b * distance * distance / 4);
    const Eigen::Vector4d w_ss(2 / (length * length), (6 * t - 2) / (length * length), 0, 0);
    // The back wall shifts by sway t^2 + D(s) phi(s), phi = twist t.
    const Eigen::Vector4d front_ss(0, 0, 2 / (length * length), 0);
    const Eigen::Vector4d back_ss(0, 0, 2 / (length * length), 2 * distance_s / length);
    const Eigen::Vector4d phi_s(0, 0, 0, 1 / length);
    stiffness_ +=
        weight * length *
        (bending * (w_ss * w_ss.transpose() + 4.0 / 3 * phi_s * phi_s.transpose()) +
         wall_in_plane * (front_ss * front_ss.transpose() + back_ss * back_ss.transpose()));
  });
}

Result<FinRayBody> FinRayBody::create(const FinRayGeometry& g, double modulus_MPa) {
  for (const double given : {g.length_mm, g.width_mm, g.layer_mm, g.wall_mm, g.base_depth_mm,
                             g.tip_depth_mm, modulus_MPa})
    if (!(given > 0 && std::isfinite(given)))
      return Error{en::say("a body cannot have a modulus or a length of {:g}", given), "",
                   en::say("numbers above 0")};
  const double min_mm = std::min(g.base_depth_mm, g.tip_depth_mm);
  if (min_mm < 2 * g.wall_mm)
    return Error{
        en::say("two walls of {:g} mm do not fit into a depth of {:g} mm", g.wall_mm, min_mm), "",
        en::say("walls of up to {:g} mm", min_mm / 2)};
  if (!(g.coupling >= 0 && g.coupling <= 1))
    return Error{en::say("a coupling of {:g} is not a fraction", g.coupling), "",
                 en::say("0 to 1")};
  return FinRayBody(g, modulus_MPa);
}

SurfaceFrame PushedFinger::surface(const PointForce& at, const BodyModes& q) const {
  return frame_of(section_at(rest_path(rest_, at.s_mm), q), material_point(body_.geometry(), at),
                  at.face);
}

BodyModes PushedFinger::generalised_force(std::span<const PointForce> forces,
                                          const BodyModes& q) const {
  return sum_of(prepared(forces, body_.geometry(), rest_), q);
}

PushedFinger::Equilibrium PushedFinger::equilibrium(std::span<const PointForce> forces,
                                                    double weight, const BodyModes& before) const {
  // Large forces are applied in increments, so that Newton's method stays on the branch that starts
  // at rest.
  constexpr double kMinStep = 1.0 / 256, kShareOfLarge = 0.25, kSmallTurn = 0.3;
  const double length = rest_.length_mm();
  Equilibrium result{before, 0};
  if (!is_within_limits(before, length)) return result;
  const std::vector<PreparedForce> all = prepared(forces, body_.geometry(), rest_);
  const BodyModes linear = body_.stiffness().ldlt().solve(weight * sum_of(all, before));
  double step = relative_size(linear, length) < kSmallTurn ? 1.0 : kShareOfLarge;
  while (result.share < 1) {
    const double share = std::min(1.0, result.share + step);
    if (find_equilibrium(body_.stiffness(), all, length, weight * share, before, result.q))
      result.share = share;
    else if ((step /= 2) < kMinStep)
      break;
  }
  return result;
}

Result<FinRayBody> ElasticFinger::body(const Face& face, double length_mm) const {
  return FinRayBody::create(
      {length_mm, face.width_mm, face.layer_mm, wall_mm, base_depth_mm, tip_depth_mm, coupling},
      modulus_MPa);
}

}  // namespace alltact
