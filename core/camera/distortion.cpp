#include "core/camera/distortion.h"

#include <Eigen/LU>

namespace alltact {
namespace {

double horner(std::span<const double> powers, double x) {
  double sum = 0;
  for (std::size_t i = powers.size(); i-- > 0;) sum = sum * x + powers[i];
  return sum;
}

std::vector<double> derivative(std::span<const double> powers) {
  std::vector<double> result;
  for (std::size_t i = 1; i < powers.size(); ++i)
    result.push_back(static_cast<double>(i) * powers[i]);
  return result;
}

/// Returns x between low and high where the polynomial changes its sign, to the last bit.
double bisect(std::span<const double> powers, double low, double high) {
  const bool rises = horner(powers, low) < 0;
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return low;
    ((horner(powers, middle) < 0) == rises ? low : high) = middle;
  }
}

/// All x in (low, high) where the polynomial changes its sign, in order. Between two neighbouring
/// ones of its derivative there is at most one.
std::vector<double> sign_changes(std::span<const double> powers, double low, double high) {
  if (powers.size() < 2) return {};
  std::vector<double> roots = sign_changes(derivative(powers), low, high);
  roots.push_back(high);
  std::vector<double> result;
  double begin = low;
  for (double end : roots) {
    if ((horner(powers, begin) < 0) != (horner(powers, end) < 0))
      result.push_back(bisect(powers, begin, end));
    begin = end;
  }
  return result;
}

/// Returns x in [0, limit) with x g(x^2) = target, where x g(x^2) grows; nullopt beyond its end.
/// Newton's method, with bisection where that would leave the bracket.
std::optional<double> invert_radial(std::span<const double> g, double target, double limit) {
  const auto value = [&](double x) { return x * horner(g, x * x); };
  const auto slope = [&](double x) {
    double sum = 0;
    for (std::size_t i = g.size(); i-- > 0;)
      sum = sum * x * x + static_cast<double>(2 * i + 1) * g[i];
    return sum;
  };
  if (!(target < value(limit))) return std::nullopt;
  double low = 0, high = limit;
  double x = std::min(target, 0.5 * limit);
  constexpr int kSteps = 200;  // bisection needs 60, Newton at most 12 in practice
  for (int step = 0; step < kSteps; ++step) {
    const double excess = value(x) - target;
    if (excess == 0) return x;
    (excess > 0 ? high : low) = x;
    double next = x - excess / slope(x);
    if (!(next > low && next < high)) next = low + (high - low) / 2;
    if (next == x || next <= low || next >= high) return x;
    x = next;
  }
  return x;
}

}  // namespace

double first_root(std::span<const double> powers, double limit) {
  const auto roots = sign_changes(powers, 0, limit);
  return roots.empty() ? limit : roots.front();
}

BrownDistortion::BrownDistortion(std::span<const double> coefficients) {
  std::array<double, 5> k{};
  std::copy(coefficients.begin(), coefficients.end(), k.begin());
  radial_ = {1, k[0], k[1], k[4]};
  q_ = {k[3], k[2]};
}

double BrownDistortion::valid_radius() const {
  const double tangential = 6 * q_.norm();
  const auto [one, k1, k2, k3] = radial_;
  const std::array<double, 7> stretch{one, -tangential, 3 * k1, 0, 5 * k2, 0, 7 * k3};
  const std::array<double, 7> scale{one, -tangential, k1, 0, k2, 0, k3};
  return std::min(first_root(stretch, kLimit), first_root(scale, kLimit));
}

Eigen::Vector2d BrownDistortion::distort(const Eigen::Vector2d& point) const {
  const double r2 = point.squaredNorm();
  return point * (horner(radial_, r2) + 2 * q_.dot(point)) + q_ * r2;
}

Eigen::Matrix2d BrownDistortion::jacobian(const Eigen::Vector2d& point) const {
  const double r2 = point.squaredNorm();
  const auto [one, k1, k2, k3] = radial_;
  const double slope = k1 + r2 * (2 * k2 + r2 * 3 * k3);  // of the radial factor in r^2
  return (horner(radial_, r2) + 2 * q_.dot(point)) * Eigen::Matrix2d::Identity() +
         2 * slope * point * point.transpose() +
         2 * (q_ * point.transpose() + point * q_.transpose());
}

std::optional<Eigen::Vector2d> BrownDistortion::undistort(const Eigen::Vector2d& point,
                                                          double valid_radius) const {
  const double distance = point.norm();
  if (distance == 0) return Eigen::Vector2d(0, 0);
  const auto radius = invert_radial(radial_, distance, valid_radius);
  if (q_.isZero(0)) {
    if (!radius) return std::nullopt;
    return point * (*radius / distance);
  }
  // The radial inverse is the start; Newton in two dimensions adds the small tangential part. Steps
  // are halved until the residual falls: the Jacobian is positive definite on the disc.
  Eigen::Vector2d found = point * (radius.value_or(0.999 * valid_radius) / distance);
  Eigen::Vector2d residual = distort(found) - point;
  constexpr int kSteps = 60;
  for (int step = 0; step < kSteps && !residual.isZero(0); ++step) {
    const Eigen::Vector2d newton = jacobian(found).inverse() * residual;
    double part = 1;
    Eigen::Vector2d tried, tried_residual;
    do {
      tried = found - part * newton;
      tried_residual = distort(tried) - point;
      part /= 2;
    } while (part > 1e-3 &&
             !(tried.norm() < valid_radius && tried_residual.norm() < residual.norm()));
    if (!(tried.norm() < valid_radius && tried_residual.norm() < residual.norm())) break;
    found = tried;
    residual = tried_residual;
  }
  const double rounding = 1e-14 * (1 + distance);
  if (!(residual.norm() <= rounding && found.norm() < valid_radius)) return std::nullopt;
  return found;
}

FisheyeDistortion::FisheyeDistortion(std::span<const double> coefficients) : radial_{1} {
  std::copy(coefficients.begin(), coefficients.end(), radial_.begin() + 1);
}

double FisheyeDistortion::valid_angle() const {
  std::array<double, 5> slope{};  // of the distance, in powers of the angle's square
  for (std::size_t i = 0; i < slope.size(); ++i)
    slope[i] = static_cast<double>(2 * i + 1) * radial_[i];
  return std::sqrt(first_root(slope, kLimit * kLimit));
}

double FisheyeDistortion::distance(double angle) const {
  return angle * horner(radial_, angle * angle);
}

Eigen::Vector2d FisheyeDistortion::distort(const Eigen::Vector2d& point) const {
  const double radius = point.norm();
  if (radius == 0) return point;
  return point * (distance(std::atan(radius)) / radius);
}

Eigen::Matrix2d FisheyeDistortion::jacobian(const Eigen::Vector2d& point) const {
  const double radius = point.norm();
  if (radius == 0) return Eigen::Matrix2d::Identity();
  const double angle = std::atan(radius);
  double slope = 0;  // of the distance by the angle
  for (std::size_t i = radial_.size(); i-- > 0;)
    slope = slope * angle * angle + static_cast<double>(2 * i + 1) * radial_[i];
  const Eigen::Vector2d outward = point / radius;
  const Eigen::Matrix2d along = outward * outward.transpose();
  return slope / (1 + radius * radius) * along +
         distance(angle) / radius * (Eigen::Matrix2d::Identity() - along);
}

std::optional<Eigen::Vector2d> FisheyeDistortion::undistort(const Eigen::Vector2d& point,
                                                            double valid_angle) const {
  const double seen = point.norm();
  if (seen == 0) return Eigen::Vector2d(0, 0);
  const auto angle = invert_radial(radial_, seen, valid_angle);
  if (!angle) return std::nullopt;
  return point * (std::tan(*angle) / seen);
}

}  // namespace alltact
