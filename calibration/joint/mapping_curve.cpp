#include "calibration/joint/mapping_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmall = 1e-3;  // below, four terms of a series are exact to 1e-13

/// tanh(sqrt z) / sqrt z, smooth through zero; below it the circular function.
double tanh_root(double z) {
  if (std::abs(z) < kSmall)
    return 1.0 - z * (1.0 / 3.0 - z * (2.0 / 15.0 - z * (17.0 / 315.0 - z * (62.0 / 2835.0))));
  const double root = std::sqrt(std::abs(z));
  return (z > 0.0 ? std::tanh(root) : std::tan(root)) / root;
}

/// atanh(sqrt z) / sqrt z for z < 1, likewise.
double atanh_root(double z) {
  if (std::abs(z) < kSmall)
    return 1.0 + z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z * (1.0 / 9.0))));
  const double root = std::sqrt(std::abs(z));
  return (z > 0.0 ? std::atanh(root) : std::atan(root)) / root;
}

/// Derivative of atanh_root(z) by z.
double atanh_root_slope(double z, double value) {
  if (std::abs(z) < kSmall)
    return 1.0 / 3.0 + z * (0.4 + z * (3.0 / 7.0 + z * (4.0 / 9.0 + z * (5.0 / 11.0))));
  return (1.0 / (1.0 - z) - value) / (2.0 * z);
}

}  // namespace

CurveAt::AbsorbingLayer::AbsorbingLayer(const double* values)
    : thickness_mm(values[0] / (1.0 + values[1])),
      s(values[1]),
      a(1.0 + values[2]),
      b2(values[2] * (values[2] + 2.0)) {
  // R(1) / s = h / (1 + a s h) with h = tanh(B s) / (B s), and dh/dz = (1 - h - z h^2) / (2 z).
  const double z = b2 * s * s, h = tanh_root(z);
  const double h_by_z =
      std::abs(z) < kSmall ? -1.0 / 3.0 + z * (4.0 / 15.0 - z * (17.0 / 105.0 - z * 248.0 / 2835.0))
                           : (1.0 - h - z * h * h) / (2.0 * z);
  const double below = 1.0 + a * s * h;
  full = h / below;
  full_by_s = (h_by_z * 2.0 * b2 * s - a * h * h) / (below * below);
  full_by_k = (h_by_z * 2.0 * a * s * s - s * h * h) / (below * below);
  // slope at zero = thickness full / q
  const double q = 1.0 - 2.0 * a * s * full + s * s * full * full;
  const double q_by_full = 2.0 * s * (s * full - a);
  zero_slope_mm = thickness_mm * full / q;
  const double by_full = thickness_mm / q - zero_slope_mm / q * q_by_full;
  zero_slope_by_values << full / (q * (1.0 + s)),
      -zero_slope_mm / (1.0 + s) + by_full * full_by_s -
          zero_slope_mm / q * (2.0 * s * full * full - 2.0 * a * full),
      by_full * full_by_k + zero_slope_mm / q * 2.0 * s * full;
}

bool CurveAt::AbsorbingLayer::is_possible() const {
  return thickness_mm > 0.0 && s > -0.9 && a > 0.5 && a < 4.0 && full > 0.0 && a * s * full < 1.0;
}

double CurveAt::AbsorbingLayer::depth_mm(double x, double* gradient) const {
  if (!is_possible()) return kNaN;
  if (!(x > 0.0)) {
    if (gradient != nullptr) Eigen::Map<Eigen::Vector3d>(gradient, 3) = zero_slope_by_values * x;
    return zero_slope_mm * x;
  }
  const double u = (1.0 - x) * full, below = 1.0 - a * s * u;
  const double n = u / below;
  const double z = b2 * s * s * n * n;
  if (!(z < 1.0)) return kNaN;
  const double root = atanh_root(z), left = n * root;  // of the layer
  const double depth = thickness_mm * (1.0 - left);
  if (gradient == nullptr) return depth;
  const double left_by_n = 1.0 / (1.0 - z), left_by_z = n * atanh_root_slope(z, root);
  const double n_by_u = 1.0 / (below * below);
  const double n_by_s = n_by_u * ((1.0 - x) * full_by_s + a * u * u);
  const double n_by_k = n_by_u * ((1.0 - x) * full_by_k + s * u * u);
  const double z_by_s = 2.0 * b2 * s * n * n, z_by_k = 2.0 * a * s * s * n * n;
  gradient[0] = (1.0 - left) / (1.0 + s);
  gradient[1] = -depth / (1.0 + s) - thickness_mm * (left_by_n * n_by_s + left_by_z * z_by_s);
  gradient[2] = -thickness_mm * (left_by_n * n_by_k + left_by_z * z_by_k);
  return depth;
}

double CurveAt::AbsorbingLayer::slope_mm(double x) const {
  const double u = (1.0 - x) * full;
  return thickness_mm * full / (1.0 - 2.0 * a * s * u + s * s * u * u);
}

double CurveAt::AbsorbingLayer::inverse(double depth_mm) const {
  const double left = 1.0 - depth_mm / thickness_mm;
  if (!is_possible() || !(left > 0.0)) return kNaN;
  const double h = left * tanh_root(b2 * s * s * left * left);
  return 1.0 - h / ((a * s * h + 1.0) * full);
}

CurveAt::CurveAt(CurveFamily family, double x_max, const double* values)
    : family_(family), x_max_(x_max), values_(values) {
  if (family.absorbs()) layer_.emplace(values);
}

Message CurveFamily::name() const {
  const Message curve = kind != MappingKind::kMoebius
                            ? en::say("polynomial of degree {}", coefficients)
                        : absorbs() ? en::say("Kubelka-Munk curve")
                                    : en::say("Moebius curve");
  return varies ? en::say("{} that varies over the face", curve) : curve;
}

double CurveAt::depth_mm(double x, const Eigen::Vector2d& unit_position, double* gradient) const {
  const double depth = curve(x, gradient);
  if (!family_.varies) return depth;
  const double* part = values_ + family_.coefficients;
  const double factor = 1.0 + part[0] * unit_position.x() + part[1] * unit_position.y();
  if (gradient != nullptr) {
    for (int k = 0; k < family_.coefficients; ++k) gradient[k] *= factor;
    gradient[family_.coefficients] = depth * unit_position.x();
    gradient[family_.coefficients + 1] = depth * unit_position.y();
  }
  return depth * factor;
}

double CurveAt::curve(double x, double* gradient) const {
  if (layer_) return layer_->depth_mm(x, gradient);
  const double at = std::max(x, 0.0);  // below zero: slope at zero times x
  if (family_.kind == MappingKind::kMoebius) {
    const double below = 1.0 + values_[1] * at;
    if (!(below > 1e-3)) return kNaN;
    if (gradient != nullptr) {
      gradient[0] = x / below;
      gradient[1] = -values_[0] * x * at / (below * below);
    }
    return values_[0] * x / below;
  }
  const double t = 2.0 * at / x_max_ - 1.0;
  double before = 0.0;
  double now = 1.0;
  double sum = 0.0;
  for (int k = 0; k < family_.coefficients; ++k) {
    sum += values_[k] * now;
    if (gradient != nullptr) gradient[k] = x * now;
    const double next = k == 0 ? t : 2.0 * t * now - before;
    before = now;
    now = next;
  }
  return x * sum;
}

CurveAt::Inverse CurveAt::inverse(double depth_mm, const Eigen::Vector2d& unit_position,
                                  double near, double* gradient) const {
  const double* part = values_ + family_.coefficients;
  const double factor =
      family_.varies ? 1.0 + part[0] * unit_position.x() + part[1] * unit_position.y() : 1.0;
  const double depth = depth_mm / factor;
  double x = kNaN;
  if (!(depth > 0.0)) {
    x = depth / slope_mm(0.0);
  } else if (layer_) {
    x = layer_->inverse(depth);
  } else if (family_.kind == MappingKind::kMoebius) {
    const double below = values_[0] - values_[1] * depth;
    if (below > 1e-3 * values_[0]) x = depth / below;
  } else {
    x = polynomial_inverse(depth, near);
  }
  const Inverse found{x, factor * slope_mm(x)};
  if (gradient != nullptr) {
    if (!std::isfinite(this->depth_mm(x, unit_position, gradient))) return {kNaN, kNaN};
    for (int k = 0; k < family_.numbers(); ++k) gradient[k] /= -found.slope_mm;
  }
  if (!std::isfinite(found.x) || !(found.slope_mm > 0.0)) return {kNaN, kNaN};
  return found;
}

double CurveAt::polynomial_inverse(double depth, double near) const {
  constexpr int kMaxSteps = 40;
  double x = std::clamp(near, 0.0, x_max_);
  for (int i = 0; i < kMaxSteps; ++i) {
    const double rise = slope_mm(x);
    if (!(rise > 0.0)) return kNaN;
    const double step = std::clamp((depth - curve(x, nullptr)) / rise, -0.5, 0.5);
    x = std::max(x + step, 0.0);
    if (std::abs(step) < 1e-13) return x;
  }
  return kNaN;
}

double CurveAt::slope_mm(double x) const {
  const double at = std::max(x, 0.0);
  if (layer_) return layer_->slope_mm(at);
  if (family_.kind == MappingKind::kMoebius) {
    const double below = 1.0 + values_[1] * at;
    return values_[0] / (below * below);
  }
  // d/dx of x p(t): p + x p' 2 / x_max, with T_k' = k U_{k-1}.
  const double t = 2.0 * at / x_max_ - 1.0;
  double before = 0.0, now = 1.0;      // T_{k-1}, T_k
  double u_before = 0.0, u_now = 1.0;  // U_{k-2}, U_{k-1} once k >= 1
  double sum = 0.0, derivative = 0.0;
  for (int k = 0; k < family_.coefficients; ++k) {
    sum += values_[k] * now;
    if (k >= 1) {
      derivative += values_[k] * k * u_now;
      const double u_next = 2.0 * t * u_now - u_before;
      u_before = u_now;
      u_now = u_next;
    }
    const double next = k == 0 ? t : 2.0 * t * now - before;
    before = now;
    now = next;
  }
  return sum + at * derivative * 2.0 / x_max_;
}

MappingCurve stored_form(const MappingCurve& curve, Eigen::MatrixXd* by_values) {
  const CurveFamily family = curve.family();
  if (!family.absorbs()) {
    if (by_values != nullptr) by_values->setIdentity(family.numbers(), family.numbers());
    return curve;
  }
  constexpr int kFewest = 4, kMax = 12, kPoints = 200;
  constexpr double kCloseMm = 2e-5;
  const double x_max = curve.x_max();
  for (int n = kFewest;; n += 4) {
    // Chebyshev's sums over the zeros of T_n: exact for all that a polynomial of n numbers can
    // represent.
    MappingCurve stored({MappingKind::kPolynomial, n, family.varies}, x_max);
    Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(stored.values().size(), family.numbers());
    Eigen::VectorXd gradient(family.numbers());
    for (int i = 0; i < n; ++i) {
      const double turn = M_PI * (i + 0.5) / n, x = 0.5 * x_max * (1.0 + std::cos(turn));
      const double read = curve.depth_mm(x, gradient.data()) / x;
      for (int k = 0; k < n; ++k) {
        const double weight = (k == 0 ? 1.0 : 2.0) / n * std::cos(k * turn);
        stored.values()[k] += weight * read;
        derivative.row(k).head<3>() += weight / x * gradient.head<3>().transpose();
      }
    }
    if (family.varies) {
      stored.values().tail<2>() = curve.values().tail<2>();
      derivative.bottomRightCorner<2, 2>().setIdentity();
    }
    double deviation_mm = 0;
    for (int i = 1; i <= kPoints; ++i) {
      const double x = x_max * i / kPoints;
      deviation_mm = std::max(deviation_mm, std::abs(stored.depth_mm(x) - curve.depth_mm(x)));
    }
    if (!(deviation_mm < kCloseMm) && n < kMax) continue;
    if (by_values != nullptr) *by_values = std::move(derivative);
    return stored;
  }
}

MappingCurve curve_of(const MappingParameters& parameters) {
  const bool is_moebius = parameters.kind == MappingKind::kMoebius;
  const bool varies = !parameters.variation.is_none();
  const int coefficients = is_moebius ? 2 : static_cast<int>(parameters.chebyshev.size());
  MappingCurve curve({parameters.kind, coefficients, varies}, parameters.x_max);
  if (is_moebius)
    curve.values().head<2>() << parameters.a_mm, parameters.b;
  else
    curve.values().head(coefficients) =
        Eigen::Map<const Eigen::VectorXd>(parameters.chebyshev.data(), coefficients);
  if (varies) curve.values().tail<2>() = parameters.variation.part;
  return curve;
}

MappingParameters mapping_parameters(const MappingCurve& curve, MappingAlong along,
                                     const PressedArea& part) {
  MappingParameters parameters;
  const MappingCurve stored = stored_form(curve);
  parameters.kind = stored.family().kind;
  parameters.along = along;
  parameters.x_max = stored.x_max();
  if (stored.family().kind == MappingKind::kMoebius) {
    parameters.a_mm = stored.values()[0];
    parameters.b = stored.values()[1];
  } else {
    const auto numbers = stored.values().head(stored.family().coefficients);
    parameters.chebyshev.assign(numbers.begin(), numbers.end());
  }
  if (stored.family().varies)
    parameters.variation = {stored.values().tail<2>(), part.middle_mm, part.half_mm};
  return parameters;
}

bool increases(const MappingCurve& curve, MappingAlong along) {
  return Mapping::create(mapping_parameters(curve, along)).ok();
}

}  // namespace alltact
