#include "core/simulation/mechanics/half_space_contact.h"

#include "core/simulation/mechanics/hertz.h"
#include "core/simulation/mechanics/shore.h"

#include <cmath>
#include <numbers>

namespace alltact {

namespace {

constexpr double kPoisson = 0.5;

// Displacement under a traction sqrt(1 - r^2 / a^2) along x, times the shear modulus.
Eigen::Vector2d tangential_mm(const Eigen::Vector2d& at, double a) {
  const double r2 = at.squaredNorm(), r = std::sqrt(r2), pi = std::numbers::pi;
  if (r <= a) {
    const double x = at.x(), y = at.y();
    return pi / (32 * a) *
           Eigen::Vector2d(
               4 * (2 - kPoisson) * a * a - (4 - 3 * kPoisson) * x * x - (4 - kPoisson) * y * y,
               2 * kPoisson * x * y);
  }
  const double q = a / r, angle = std::asin(q), root = std::sqrt((1 - q) * (1 + q));
  const double even = (2 - kPoisson) * ((2 * a * a - r2) * angle + a * r * root);
  const double turning = 0.5 * kPoisson * (r2 * angle + (2 * a * a - r2) * root * q);
  const double c = at.x() / r, s = at.y() / r;
  return Eigen::Vector2d(even + turning * (c - s) * (c + s), turning * 2 * s * c) / (8 * a);
}

}  // namespace

Eigen::Vector2d limited_by_friction(const Eigen::Vector2d& tangential_N,
                                    double normal_N,
                                    double friction) {
  const double requested = tangential_N.norm(), held = friction * normal_N;
  return requested > held ? Eigen::Vector2d(tangential_N * (held / requested)) : tangential_N;
}

Result<HalfSpaceContact> HalfSpaceContact::create(double modulus_MPa,
                                                  double radius_mm,
                                                  double normal_N,
                                                  const Eigen::Vector2d& tangential_N,
                                                  double friction) {
  for (const double given : {modulus_MPa, radius_mm, normal_N, friction})
    if (!(given > 0 && std::isfinite(given)))
      return Error{en::say("{:g} is no modulus, radius, force or friction of a contact", given),
                   "",
                   en::say("numbers above 0")};
  if (!tangential_N.allFinite())
    return Error{en::say("the tangential force is not a number"), "", en::say("newtons")};
  HalfSpaceContact contact;
  contact.modulus_MPa_ = modulus_MPa;
  contact.radius_mm_ = radius_mm;
  const double plane = modulus_MPa / (1 - kPoisson * kPoisson);
  const double a = std::cbrt(0.75 * normal_N * radius_mm / plane);
  if (a > kMaxContactShare * radius_mm) {
    const double max_value = std::pow(kMaxContactShare, 3) * radius_mm * radius_mm * plane / 0.75;
    return Error{en::say("{:g} N press the ball further into the body than is known", normal_N),
                 "",
                 en::say("up to {:.3g} N, a larger ball or a harder body", max_value)};
  }
  contact.contact_mm_ = a;
  contact.slip_traction_MPa_ = friction * 1.5 * normal_N / (std::numbers::pi * a * a);
  const double part = std::min(1.0, tangential_N.norm() / (friction * normal_N));
  contact.stick_mm_ = a * std::cbrt(1 - part);
  if (part > 0) contact.direction_ = tangential_N.normalized();
  return contact;
}

Eigen::Vector3d HalfSpaceContact::displacement_mm(const Eigen::Vector2d& at_mm) const {
  const double a = contact_mm_, r = at_mm.norm();
  const double share = r <= a ? 1 - 0.5 * r * r / (a * a) : hertz_tail(a / r);
  Eigen::Vector3d result(0, 0, indentation_mm() * share);
  if (direction_.isZero()) return result;
  const Eigen::Vector2d aside(-direction_.y(), direction_.x());
  const Eigen::Vector2d at(at_mm.dot(direction_), at_mm.dot(aside));
  Eigen::Vector2d moved = tangential_mm(at, a);
  if (stick_mm_ > 0) moved -= stick_mm_ / a * tangential_mm(at, stick_mm_);
  moved *= slip_traction_MPa_ / shear_modulus(modulus_MPa_);
  result.head<2>() = moved.x() * direction_ + moved.y() * aside;
  return result;
}

}  // namespace alltact
