#include "tests/hard_cases/exact.h"

// The only file with Boost's numbers, which take long to compile.
#include <boost/multiprecision/cpp_dec_float.hpp>

namespace alltact::exact {
namespace {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                            boost::multiprecision::et_off>;
using Numbers = std::vector<Exact>;

double rounded(const Exact& value) { return value.convert_to<double>(); }

struct Vector {
  Exact x, y, z;

  explicit Vector(const Eigen::Vector3d& v) : x(v.x()), y(v.y()), z(v.z()) {}
  Vector(const Exact& a, const Exact& b, const Exact& c) : x(a), y(b), z(c) {}
  [[nodiscard]] Exact dot(const Vector& o) const { return x * o.x + y * o.y + z * o.z; }
  [[nodiscard]] Vector cross(const Vector& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  [[nodiscard]] Exact norm() const { return sqrt(dot(*this)); }
};

Exact horner(const Numbers& c, const Exact& x) {
  Exact sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * x + c[k];
  return sum;
}

/// Gauss-Jordan elimination on the normal equations: 50 digits leave enough precision.
Numbers fitted(const Eigen::VectorXd& x, const Eigen::VectorXd& y, std::size_t n) {
  std::vector<Numbers> a(n, Numbers(n + 1, Exact(0)));
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Numbers row(n + 1, Exact(1));
    for (std::size_t k = 1; k < n; ++k) row[k] = row[k - 1] * Exact(x[i]);
    row[n] = y[i];
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k <= n; ++k) a[j][k] += row[j] * row[k];
  }
  for (std::size_t j = 0; j < n; ++j) {
    const Exact pivot = a[j][j];
    for (Exact& value : a[j]) value /= pivot;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == j) continue;
      const Exact factor = a[i][j];
      for (std::size_t k = j; k <= n; ++k) a[i][k] -= factor * a[j][k];
    }
  }
  Numbers result;
  for (const Numbers& row : a) result.push_back(row[n]);
  return result;
}

}  // namespace

Angle between(const Eigen::Vector3d& p, const Eigen::Vector3d& c) {
  const Vector a(p), b(c);
  const Exact across = a.cross(b).norm();
  return {rounded(across / (a.norm() * b.norm())), rounded(atan2(across, a.dot(b)))};
}

double near_root(const Eigen::Vector3d& u, const Eigen::Vector3d& c, double radius) {
  const Vector direction(u), centre(c);
  const Exact a = direction.dot(direction), b = direction.dot(centre);
  const Exact product = centre.dot(centre) - Exact(radius) * Exact(radius);
  return rounded(product / (b + sqrt(b * b - a * product)));
}

double outside(const Eigen::Vector3d& u, const Eigen::Vector3d& c, double radius) {
  const Vector direction(u);
  return rounded(Vector(c).cross(direction).norm() / direction.norm() - Exact(radius));
}

double norm(const Eigen::Vector3d& v) { return rounded(Vector(v).norm()); }

std::vector<double> powers(const Eigen::VectorXd& c, double middle, double half) {
  const auto n = static_cast<std::size_t>(c.size());
  const Exact scale = Exact(1) / half, shift = -Exact(middle) / half;
  Numbers sum(n, Exact(0)), before(n, Exact(0)), now(n, Exact(0));
  now[0] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    const Exact twice = k == 0 ? 1 : 2;  // T_1 = t T_0, T_{k+1} = 2 t T_k - T_{k-1}
    Numbers next(n, Exact(0));
    for (std::size_t i = 0; i < n; ++i) {
      sum[i] += Exact(c[static_cast<Eigen::Index>(k)]) * now[i];
      next[i] = twice * shift * now[i];
      if (i > 0) next[i] += twice * scale * now[i - 1];
      if (k > 0) next[i] -= before[i];
    }
    before = std::move(now);
    now = std::move(next);
  }
  std::vector<double> result;
  for (const Exact& power : sum) result.push_back(rounded(power));
  return result;
}

double series(const Eigen::VectorXd& c, double t) {
  Exact before = 0, now = 1, sum = 0;  // T_{k-1}, T_k
  for (std::size_t k = 0; k < static_cast<std::size_t>(c.size()); ++k) {
    sum += Exact(c[static_cast<Eigen::Index>(k)]) * now;
    const Exact next = k == 0 ? Exact(t) : 2 * Exact(t) * now - before;
    before = now;
    now = next;
  }
  return rounded(sum);
}

double polynomial(const Eigen::VectorXd& c, double x) {
  return rounded(horner(Numbers(c.begin(), c.end()), Exact(x)));
}

std::vector<double> fitted_values(const Eigen::VectorXd& x, const Eigen::VectorXd& y, int n) {
  const Numbers coefficients = fitted(x, y, static_cast<std::size_t>(n));
  std::vector<double> values;
  for (const double at : x) values.push_back(rounded(horner(coefficients, Exact(at))));
  return values;
}

double hertz_tail(double q) {
  const Exact r = Exact(1) / q;
  const Exact root = r > 1 ? sqrt(r * r - 1) : Exact(0);
  return rounded(((2 - r * r) * asin(Exact(q)) + root) / acos(Exact(-1)));
}

}  // namespace alltact::exact
