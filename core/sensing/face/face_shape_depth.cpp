// Distance of the face, computed from its edges: 1/z as a curve over the columns.
#include "core/numerics/chebyshev.h"
#include "core/numerics/least_squares.h"
#include "core/numerics/robust_polynomial.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kMaxWindowSteps = 60;  // each reduces the error of z by a factor of 5 or more

}  // namespace

// Without distortion a column's rays share their x. Then y and 1/z are polynomials of the column
// with the degree of the edges. Values at as many Chebyshev nodes as coefficients determine them
// exactly.
bool FaceShape::set_edges(const RobustPolynomial& upper, const RobustPolynomial& lower) {
  const Eigen::Index n = upper.coefficients.size();
  upper_y_ = lower_y_ = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double angle = M_PI * (static_cast<double>(j) + 0.5) / static_cast<double>(n);
    const double t = std::cos(angle), u = scale_.middle_px + scale_.half_px * t;
    const auto a = camera_.unproject({u, upper.value(t)}),
               b = camera_.unproject({u, lower.value(t)});
    if (!a || !b) return false;
    for (Eigen::Index k = 0; k < n; ++k) {
      const double part =
          (k == 0 ? 1.0 : 2.0) / static_cast<double>(n) * std::cos(static_cast<double>(k) * angle);
      upper_y_[k] += part * a->direction.y();
      lower_y_[k] += part * b->direction.y();
    }
  }
  inverse_z_ = (lower_y_ - upper_y_) / face_.width_mm;
  compute_across();
  return inverse_z_.allFinite();
}

bool FaceShape::fit_inverse_depth(double first, double last, int degree) {
  // Samples the fitted edges at Chebyshev nodes.
  const Eigen::Index n = degree + 1;
  const int samples = 8 * static_cast<int>(n);
  std::vector<Ray> uppers, lowers;
  for (int i = 0; i < samples; ++i) {
    const double node = -std::cos(M_PI * (i + 0.5) / samples);
    const double u = 0.5 * (first + last) + 0.5 * (last - first) * node;
    const auto& left = columns_[static_cast<std::size_t>(u)];
    const auto& right = columns_[std::min(static_cast<std::size_t>(u) + 1, columns_.size() - 1)];
    const double part = u - std::floor(u);
    const auto a = camera_.unproject({u, left.upper_v + part * (right.upper_v - left.upper_v)});
    const auto b = camera_.unproject({u, left.lower_v + part * (right.lower_v - left.lower_v)});
    if (!a || !b) continue;
    uppers.push_back(*a), lowers.push_back(*b);
  }
  if (uppers.size() < static_cast<std::size_t>(2 * n)) return false;
  // Behind a window the apparent direction of a point depends on its distance.
  const int rounds = camera_.is_central() ? 1 : kMaxWindowSteps;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd before = inverse_z_;
    if (!fit_to_rays(uppers, lowers, n)) return false;
    if (before.size() > 0 && (inverse_z_ - before).norm() < 1e-15) break;
  }
  compute_across();
  return inverse_z_.allFinite();
}

bool FaceShape::fit_to_rays(const std::vector<Ray>& uppers,
                            const std::vector<Ray>& lowers,
                            Eigen::Index n) {
  const auto used = static_cast<Eigen::Index>(uppers.size());
  Eigen::VectorXd upper_x(used), upper_y(used), lower_x(used), lower_y(used);
  for (Eigen::Index i = 0; i < used; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Vector2d a = seen_from(uppers[k], inverse_z_of(uppers[k])),
                          b = seen_from(lowers[k], inverse_z_of(lowers[k]));
    upper_x[i] = a.x(), upper_y[i] = a.y();
    lower_x[i] = b.x(), lower_y[i] = b.y();
  }
  const auto curve = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    Eigen::MatrixXd design(used, n);
    for (Eigen::Index i = 0; i < used; ++i)
      design.row(i) = chebyshev_row(scale_.at(column_of(x[i])), n);
    return least_squares(design, y);
  };
  upper_y_ = curve(upper_x, upper_y);
  lower_y_ = curve(lower_x, lower_y);
  inverse_z_ = (lower_y_ - upper_y_) / face_.width_mm;
  return inverse_z_.allFinite();
}

// 0 before the first fit: the point of the ray is then assumed to be far away.
double FaceShape::inverse_z_of(const Ray& ray) const {
  if (inverse_z_.size() == 0) return 0.0;
  double inverse_z = inverse_z_at(ray.direction.head<2>());
  if (camera_.is_central()) return inverse_z;
  for (int step = 0; step < kMaxWindowSteps; ++step) {
    const double before = inverse_z;
    inverse_z = inverse_z_at(seen_from(ray, inverse_z));
    if (std::abs(inverse_z - before) <= 1e-15) break;
  }
  return inverse_z;
}

void FaceShape::compute_across() {
  inverse_z_slope_ = chebyshev_derivative(inverse_z_);
  if (twist_) {
    inverse_z_by_y_slope_ = chebyshev_derivative(inverse_z_by_y_);
    inverse_z_by_y2_slope_ = chebyshev_derivative(inverse_z_by_y2_);
  }
  across_.clear();
  by_column_.clear();
  if (!camera_.is_linear() || !camera_.is_perspective()) return;
  if (twist_)
    by_column_.resize(columns_.size());
  else
    across_.resize(columns_.size());
  const CameraParameters& lens = camera_.parameters();
  const auto along = [&](const Eigen::VectorXd& series) {
    std::vector<double> values(columns_.size(), 0.0);
    if (series.size() > 0)
      chebyshev_values(series, scale_.at(0.0), 1.0 / scale_.half_px, width_px(), values.data());
    return values;
  };
  const double per_x = lens.fx_px / scale_.half_px;
  const auto a = along(inverse_z_), a_slope = along(inverse_z_slope_);
  const auto b = along(inverse_z_by_y_), b_slope = along(inverse_z_by_y_slope_);
  const auto d = along(inverse_z_by_y2_), d_slope = along(inverse_z_by_y2_slope_);
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    if (!columns_[u].valid) continue;
    InverseDepth inverse{
        a[u], b[u], d[u], per_x * a_slope[u], per_x * b_slope[u], per_x * d_slope[u]};
    if (twist_)
      by_column_[u] = inverse;
    else if (const auto here = across_from(x_of_column(static_cast<double>(u)), 0.0, inverse))
      across_[u] = *here;
  }
}

}  // namespace alltact
