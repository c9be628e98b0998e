#include "calibration/mapping_curve.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace alltact {

std::string CurveFamily::name() const {
  const std::string curve = kind == MappingKind::kMoebius
                                ? "Moebius curve"
                                : fmt::format("polynomial of degree {}", coefficients);
  return varies ? curve + " that varies over the face" : curve;
}

double MappingCurve::evaluate(const double* values,
                              double x,
                              const Eigen::Vector2d& place,
                              double* gradient) const {
  const double depth = curve(values, x, gradient);
  if (!family_.varies) return depth;
  const double* part = values + family_.coefficients;
  const double factor = 1.0 + part[0] * place.x() + part[1] * place.y();
  if (gradient != nullptr) {
    for (int k = 0; k < family_.coefficients; ++k) gradient[k] *= factor;
    gradient[family_.coefficients] = depth * place.x();
    gradient[family_.coefficients + 1] = depth * place.y();
  }
  return depth * factor;
}

double MappingCurve::curve(const double* values, double x, double* gradient) const {
  const double at = std::max(x, 0.0);  // below zero: slope at zero times x
  if (family_.kind == MappingKind::kMoebius) {
    const double below = 1.0 + values[1] * at;
    if (!(below > 1e-3)) return std::numeric_limits<double>::quiet_NaN();
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

double MappingCurve::slope_mm(double x) const {
  const double at = std::max(x, 0.0);
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

}  // namespace alltact
