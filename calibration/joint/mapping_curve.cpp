#include "calibration/joint/mapping_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ceres/jet.h>

namespace alltact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmall = 1e-3;  // below, three terms of a series are exact to 1e-13

double scalar_of(double value) { return value; }
template <class T, int N>
double scalar_of(const ceres::Jet<T, N>& value) {
  return value.a;
}

/// cosh(sqrt z), sinh(sqrt z) / sqrt z and atanh(sqrt z) / sqrt z. They are smooth through zero;
/// below it they are the circular functions.
template <class T>
T cosh_root(const T& z) {
  using std::cos, std::cosh, std::sqrt;
  if (std::abs(scalar_of(z)) < kSmall)
    return 1.0 + z * (0.5 + z * (1.0 / 24.0 + z * (1.0 / 720.0)));
  return scalar_of(z) > 0.0 ? cosh(sqrt(z)) : cos(sqrt(-z));
}
template <class T>
T sinh_root(const T& z) {
  using std::sin, std::sinh, std::sqrt;
  if (std::abs(scalar_of(z)) < kSmall)
    return 1.0 + z * (1.0 / 6.0 + z * (1.0 / 120.0 + z * (1.0 / 5040.0)));
  if (scalar_of(z) > 0.0) return sinh(sqrt(z)) / sqrt(z);
  return sin(sqrt(-z)) / sqrt(-z);
}
template <class T>
T atanh_root(const T& z) {
  using std::atan, std::log, std::sqrt;
  if (std::abs(scalar_of(z)) < kSmall)
    return 1.0 + z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z * (1.0 / 9.0))));
  if (scalar_of(z) < 0.0) {
    const T root = sqrt(-z);
    return T(2.0) * atan(root / (1.0 + sqrt(1.0 - z))) / root;
  }
  const T root = sqrt(z);
  return 0.5 * log((1.0 + root) / (1.0 - root)) / root;
}

/// A Kubelka-Munk layer over black, of thickness `thickness_mm` when untouched. s is its
/// scattering, k absorption over scattering, A = 1 + k, B^2 = k (k + 2) and t the remaining
/// fraction of the layer: R(t) = sinh(B s t) / (A sinh(B s t) + B cosh(B s t)) and x = 1 - R(t) /
/// R(1).
template <class T>
struct AbsorbingLayer {
  T thickness_mm, s, a, b2, full;  // R(1) / s

  AbsorbingLayer(const T& slope_mm, const T& scattering, const T& absorption)
      : thickness_mm(slope_mm / (1.0 + scattering)),
        s(scattering),
        a(1.0 + absorption),
        b2(absorption * (absorption + 2.0)),
        full(part(T(1.0))) {}
  /// R(t) / s
  T part(const T& t) const {
    const T z = b2 * s * s * t * t;
    const T sinh = t * sinh_root(z);
    return sinh / (a * s * sinh + cosh_root(z));
  }
  [[nodiscard]] bool is_possible() const {
    const double scattering = scalar_of(s), r = scalar_of(full);
    return scalar_of(thickness_mm) > 0.0 && scattering > -0.9 && scalar_of(a) > 0.5 &&
           scalar_of(a) < 4.0 && r > 0.0 && scalar_of(a) * scattering * r < 1.0;
  }
  T depth_mm(const T& x) const {
    const T u = (1.0 - x) * full;
    const T n = u / (1.0 - a * s * u);
    const T z = b2 * s * s * n * n;
    if (!(scalar_of(z) < 1.0)) return T(kNaN);
    return thickness_mm * (1.0 - n * atanh_root(z));
  }
  T slope_mm(const T& x) const {
    const T u = (1.0 - x) * full;
    return thickness_mm * full / (1.0 - 2.0 * a * s * u + s * s * u * u);
  }
};

}  // namespace

Message CurveFamily::name() const {
  const Message curve = kind != MappingKind::kMoebius
                            ? en::say("polynomial of degree {}", coefficients)
                        : absorbs() ? en::say("Kubelka-Munk curve")
                                    : en::say("Moebius curve");
  return varies ? en::say("{} that varies over the face", curve) : curve;
}

double MappingCurve::evaluate(const double* values, double x, const Eigen::Vector2d& unit_position,
                              double* gradient) const {
  const double depth = curve(values, x, gradient);
  if (!family_.varies) return depth;
  const double* part = values + family_.coefficients;
  const double factor = 1.0 + part[0] * unit_position.x() + part[1] * unit_position.y();
  if (gradient != nullptr) {
    for (int k = 0; k < family_.coefficients; ++k) gradient[k] *= factor;
    gradient[family_.coefficients] = depth * unit_position.x();
    gradient[family_.coefficients + 1] = depth * unit_position.y();
  }
  return depth * factor;
}

double MappingCurve::curve(const double* values, double x, double* gradient) const {
  const double at = std::max(x, 0.0);  // below zero: slope at zero times x
  if (family_.absorbs()) {
    using Jet = ceres::Jet<double, 3>;
    const AbsorbingLayer<Jet> layer(Jet(values[0], 0), Jet(values[1], 1), Jet(values[2], 2));
    if (!layer.is_possible()) return kNaN;
    const Jet depth = x > 0.0 ? layer.depth_mm(Jet(x)) : layer.slope_mm(Jet(0.0)) * x;
    if (gradient != nullptr) std::copy_n(depth.v.data(), 3, gradient);
    return depth.a;
  }
  if (family_.kind == MappingKind::kMoebius) {
    const double below = 1.0 + values[1] * at;
    if (!(below > 1e-3)) return kNaN;
    if (gradient != nullptr) {
      gradient[0] = x / below;
      gradient[1] = -values[0] * x * at / (below * below);
    }
    return values[0] * x / below;
  }
  const double t = 2.0 * at / x_max_ - 1.0;
  double before = 0.0;
  double now = 1.0;
  double sum = 0.0;
  for (int k = 0; k < family_.coefficients; ++k) {
    sum += values[k] * now;
    if (gradient != nullptr) gradient[k] = x * now;
    const double next = k == 0 ? t : 2.0 * t * now - before;
    before = now;
    now = next;
  }
  return x * sum;
}

MappingCurve::Inverse MappingCurve::inverse(const double* values, double depth_mm,
                                            const Eigen::Vector2d& unit_position, double near,
                                            double* gradient) const {
  const double* part = values + family_.coefficients;
  const double factor =
      family_.varies ? 1.0 + part[0] * unit_position.x() + part[1] * unit_position.y() : 1.0;
  const double depth = depth_mm / factor;
  double x = kNaN;
  if (!(depth > 0.0)) {
    x = depth / slope(values, 0.0);
  } else if (family_.absorbs()) {
    const AbsorbingLayer<double> layer(values[0], values[1], values[2]);
    const double left = 1.0 - depth / layer.thickness_mm;
    if (layer.is_possible() && left > 0.0) x = 1.0 - layer.part(left) / layer.full;
  } else if (family_.kind == MappingKind::kMoebius) {
    const double below = values[0] - values[1] * depth;
    if (below > 1e-3 * values[0]) x = depth / below;
  } else {
    x = polynomial_inverse(values, depth, near);
  }
  const Inverse found{x, factor * slope(values, x)};
  if (gradient != nullptr) {
    if (!std::isfinite(evaluate(values, x, unit_position, gradient))) return {kNaN, kNaN};
    for (int k = 0; k < family_.numbers(); ++k) gradient[k] /= -found.slope_mm;
  }
  if (!std::isfinite(found.x) || !(found.slope_mm > 0.0)) return {kNaN, kNaN};
  return found;
}

double MappingCurve::polynomial_inverse(const double* values, double depth, double near) const {
  constexpr int kMaxSteps = 40;
  double x = std::clamp(near, 0.0, x_max_);
  for (int i = 0; i < kMaxSteps; ++i) {
    const double rise = slope(values, x);
    if (!(rise > 0.0)) return kNaN;
    const double step = std::clamp((depth - curve(values, x, nullptr)) / rise, -0.5, 0.5);
    x = std::max(x + step, 0.0);
    if (std::abs(step) < 1e-13) return x;
  }
  return kNaN;
}

double MappingCurve::slope(const double* values, double x) const {
  const double at = std::max(x, 0.0);
  if (family_.absorbs())
    return AbsorbingLayer<double>(values[0], values[1], values[2]).slope_mm(at);
  if (family_.kind == MappingKind::kMoebius) {
    const double below = 1.0 + values[1] * at;
    return values[0] / (below * below);
  }
  // d/dx of x p(t): p + x p' 2 / x_max, with T_k' = k U_{k-1}.
  const double t = 2.0 * at / x_max_ - 1.0;
  double before = 0.0, now = 1.0;      // T_{k-1}, T_k
  double u_before = 0.0, u_now = 1.0;  // U_{k-2}, U_{k-1} once k >= 1
  double sum = 0.0, derivative = 0.0;
  for (int k = 0; k < family_.coefficients; ++k) {
    sum += values[k] * now;
    if (k >= 1) {
      derivative += values[k] * k * u_now;
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
