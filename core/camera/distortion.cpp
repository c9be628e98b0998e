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

double horner_slope(std::span<const double> powers, double x) {
  double sum = 0;
  for (std::size_t i = powers.size(); i-- > 1;) sum = sum * x + static_cast<double>(i) * powers[i];
  return sum;
}

std::vector<double> product(std::span<const double> a, std::span<const double> b) {
  std::vector<double> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

/// even(x^2) - (linear x + cubic x^3) factor(x^2), in powers of x.
std::vector<double> interleaved(std::span<const double> even, double linear, double cubic,
                                std::span<const double> factor) {
  std::vector<double> result(std::max(2 * even.size(), 2 * factor.size() + 2));
  for (std::size_t i = 0; i < even.size(); ++i) result[2 * i] = even[i];
  for (std::size_t i = 0; i < factor.size(); ++i) {
    result[2 * i + 1] -= linear * factor[i];
    result[2 * i + 3] -= cubic * factor[i];
  }
  while (result.size() > 1 && result.back() == 0) result.pop_back();
  return result;
}

/// Returns x in [0, limit) with value(x) = target, where it grows from 0; nullopt beyond its end.
/// Newton's method, with bisection where that would leave the bracket.
template <class Value, class Slope>
std::optional<double> invert_growing(const Value& value, const Slope& slope, double target,
                                     double limit) {
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
  std::array<double, kMaxCoefficients> k{};
  std::copy(coefficients.begin(), coefficients.end(), k.begin());
  radial_ = {1, k[0], k[1], k[4]};
  divisor_ = {1, k[5], k[6], k[7]};
  is_rational_ = k[5] != 0 || k[6] != 0 || k[7] != 0;
  q_ = {k[3], k[2]};
  s_ = {k[8], k[10]};
  t_ = {k[9], k[11]};
}

double BrownDistortion::valid_radius() const {
  const double linear = 6 * q_.norm() + 2 * s_.norm(), cubic = 4 * t_.norm();
  // (r f)' D^2 = N D + 2 r^2 (N' D - N D'), for f = N / D, with N' and D' by r^2.
  const std::vector<double> both = product(radial_, divisor_),
                            squared = product(divisor_, divisor_);
  std::vector<double> slope = both;
  for (std::size_t i = 0; i < radial_.size(); ++i)
    for (std::size_t j = 0; j < divisor_.size(); ++j)
      slope[i + j] +=
          2 * (static_cast<double>(i) - static_cast<double>(j)) * radial_[i] * divisor_[j];
  const std::vector<double> divisor = interleaved(divisor_, 0, 0, divisor_);
  const double limit = first_root(divisor, kLimit);
  return std::min(first_root(interleaved(slope, linear, cubic, squared), limit),
                  first_root(interleaved(radial_, linear, cubic, divisor_), limit));
}

double BrownDistortion::factor(double r2) const {
  const double radial = horner(radial_, r2);
  return is_rational_ ? radial / horner(divisor_, r2) : radial;
}

double BrownDistortion::factor_slope(double r2) const {
  const double slope = horner_slope(radial_, r2);
  if (!is_rational_) return slope;
  const double divisor = horner(divisor_, r2);
  return (slope - factor(r2) * horner_slope(divisor_, r2)) / divisor;
}

Eigen::Vector2d BrownDistortion::distort(const Eigen::Vector2d& point) const {
  const double r2 = point.squaredNorm();
  return point * (factor(r2) + 2 * q_.dot(point)) + (q_ + s_ + t_ * r2) * r2;
}

Eigen::Matrix2d BrownDistortion::jacobian(const Eigen::Vector2d& point) const {
  const double r2 = point.squaredNorm();
  return (factor(r2) + 2 * q_.dot(point)) * Eigen::Matrix2d::Identity() +
         2 * factor_slope(r2) * point * point.transpose() +
         2 * (q_ * point.transpose() + point * q_.transpose()) +
         2 * (s_ + 2 * r2 * t_) * point.transpose();
}

std::optional<Eigen::Vector2d> BrownDistortion::undistort(const Eigen::Vector2d& point,
                                                          double valid_radius) const {
  const double distance = point.norm();
  if (distance == 0) return Eigen::Vector2d(0, 0);
  const auto radius =
      invert_growing([this](double r) { return r * factor(r * r); },
                     [this](double r) { return factor(r * r) + 2 * r * r * factor_slope(r * r); },
                     distance, valid_radius);
  if (q_.isZero(0) && s_.isZero(0) && t_.isZero(0)) {
    if (!radius) return std::nullopt;
    return point * (*radius / distance);
  }
  // The radial inverse is the start; Newton in two dimensions adds the small other parts. Steps are
  // halved until the residual falls: the Jacobian is invertible on the disc.
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
  // A quotient of large polynomials has more rounding.
  const double rounding = (is_rational_ ? 1e-12 : 1e-14) * (1 + distance);
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

double FisheyeDistortion::slope(double angle) const {
  double sum = 0;
  for (std::size_t i = radial_.size(); i-- > 0;)
    sum = sum * angle * angle + static_cast<double>(2 * i + 1) * radial_[i];
  return sum;
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
  const Eigen::Vector2d outward = point / radius;
  const Eigen::Matrix2d along = outward * outward.transpose();
  return slope(angle) / (1 + radius * radius) * along +
         distance(angle) / radius * (Eigen::Matrix2d::Identity() - along);
}

std::optional<Eigen::Vector2d> FisheyeDistortion::undistort(const Eigen::Vector2d& point,
                                                            double valid_angle) const {
  const double seen = point.norm();
  if (seen == 0) return Eigen::Vector2d(0, 0);
  const auto angle = invert_growing([this](double a) { return distance(a); },
                                    [this](double a) { return slope(a); }, seen, valid_angle);
  if (!angle) return std::nullopt;
  return point * (std::tan(*angle) / seen);
}

}  // namespace alltact
