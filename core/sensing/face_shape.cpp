#include "core/sensing/face_shape.h"

#include "core/numerics/chebyshev.h"
#include "core/numerics/least_squares.h"
#include "core/numerics/robust_polynomial.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kMinimumWidthPx = 8.0;  // below, 1/width is biased by percents
constexpr int kLensDegrees = 4;
constexpr int kMostWindowSteps = 60;  // each brings z nearer by a factor of 5 or more

/// Where a ray lies at depth z, over z: as a camera without a window would see the point.
Eigen::Vector2d seen_at(const Ray& ray, double inverse_z) {
  return ray.direction.head<2>() + inverse_z * ray.origin_mm.head<2>();
}

Error no_shape(std::string what) {
  return {std::move(what),
          "the face's edges",
          "a picture in which both long edges of the bright face are visible and lit evenly; check "
          "that the lamps are on and that the lens is clean"};
}

}  // namespace

Result<FaceShape> FaceShape::fit(const FaceEdges& edges,
                                 const Camera& camera,
                                 const Face& face,
                                 int degree,
                                 double z_sd_limit_mm) {
  if (!camera.is_perspective())
    return no_shape("the shape of a Fin Ray needs a perspective camera, not an orthographic one");
  const CameraParameters& lens = camera.parameters();
  const int width = lens.width_px;

  // What the lens bends needs a few coefficients more.
  const int edge_degree = camera.is_linear() ? degree : degree + kLensDegrees;
  const auto upper =
      fit_robust_polynomial(edges.u, edges.upper.v, edges.upper.sd, edges.upper.valid, edge_degree);
  const auto lower =
      fit_robust_polynomial(edges.u, edges.lower.v, edges.lower.sd, edges.lower.valid, edge_degree);
  if (!upper || !lower) {
    return no_shape(fmt::format("the {} edge of the face was seen in too few columns",
                                !upper ? "upper" : "lower"));
  }
  // Nothing is invented beyond the columns where both edges were trusted; up to the picture's own
  // border the last sample's half width counts as seen.
  const double step = edges.u.size() > 1 ? edges.u[1] - edges.u[0] : 1.0;
  double first = std::max(upper->first, lower->first);
  double last = std::min(upper->last, lower->last);
  if (first <= edges.u.front()) first = std::max(0.0, first - step);
  if (last >= edges.u.back()) last = std::min(width - 1.0, last + step);
  if (!(last - first >= 4.0 * step)) return no_shape("the two edges were never seen together");

  FaceShape shape(camera, face);
  shape.columns_.resize(static_cast<std::size_t>(width));
  const std::vector<double> upper_v = upper->values(width), lower_v = lower->values(width);
  for (int u = 0; u < width; ++u) {
    FaceColumn& column = shape.columns_[static_cast<std::size_t>(u)];
    column.upper_v = upper_v[static_cast<std::size_t>(u)];
    column.lower_v = lower_v[static_cast<std::size_t>(u)];
    column.valid = u >= first && u <= last && column.lower_v - column.upper_v >= kMinimumWidthPx;
  }
  if (!shape.fit_inverse_depth(first, last, edge_degree))
    return no_shape("no smooth shape fits them");

  constexpr int kSdStep = 8;  // the error changes slowly along the face
  std::vector<double> width_sd;
  for (int u = kSdStep / 2; u < width + kSdStep; u += kSdStep)
    width_sd.push_back(std::hypot(upper->sd(u), lower->sd(u)));
  int valid = 0;
  for (int u = 0; u < width; ++u) {
    FaceColumn& column = shape.columns_[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    const double z_mm = shape.z_of_column(u);
    const double width_sd_px = width_sd[static_cast<std::size_t>(u / kSdStep)];
    column.valid = z_mm > 0.0 && std::isfinite(z_mm);
    if (!column.valid) continue;
    column.z_mm = z_mm;
    column.z_sd_mm = camera.seen_from_mm(z_mm) * width_sd_px / (column.lower_v - column.upper_v);
    column.valid = column.z_sd_mm <= z_sd_limit_mm;
    valid += column.valid;
  }
  if (valid < 5) return no_shape("the distance of the face is too uncertain in every column");
  shape.finish();
  return shape;
}

bool FaceShape::fit_inverse_depth(double first, double last, int degree) {
  // The edges are smooth curves now. For a lens without distortion 1/z is a polynomial of the same
  // degree in u and this is exact.
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
  // Behind a window where a point seems to be depends on how far it is.
  const int rounds = camera_.is_central() ? 1 : kMostWindowSteps;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd before = inverse_z_;
    if (!fit_to_rays(uppers, lowers, n)) return false;
    if (before.size() > 0 && (inverse_z_ - before).norm() < 1e-15) break;
  }
  know_across();
  return inverse_z_.allFinite();
}

bool FaceShape::fit_to_rays(const std::vector<Ray>& uppers,
                            const std::vector<Ray>& lowers,
                            Eigen::Index n) {
  const auto used = static_cast<Eigen::Index>(uppers.size());
  Eigen::VectorXd upper_x(used), upper_y(used), lower_x(used), lower_y(used);
  for (Eigen::Index i = 0; i < used; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Vector2d a = seen_at(uppers[k], inverse_z_of(uppers[k])),
                          b = seen_at(lowers[k], inverse_z_of(lowers[k]));
    upper_x[i] = a.x(), upper_y[i] = a.y();
    lower_x[i] = b.x(), lower_y[i] = b.y();
  }
  const double low = std::max(upper_x.minCoeff(), lower_x.minCoeff());
  const double high = std::min(upper_x.maxCoeff(), lower_x.maxCoeff());
  if (!(high > low)) return false;
  x_mid_ = 0.5 * (low + high);
  x_half_ = 0.5 * (high - low);

  const auto curve = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    Eigen::MatrixXd design(used, n);
    for (Eigen::Index i = 0; i < used; ++i)
      design.row(i) = chebyshev_row((x[i] - x_mid_) / x_half_, n);
    return least_squares(design, y);
  };
  inverse_z_ = (curve(lower_x, lower_y) - curve(upper_x, upper_y)) / face_.width_mm;
  return inverse_z_.allFinite();
}

// 0 before there is a fit: then the ray is taken where it lies far away.
double FaceShape::inverse_z_of(const Ray& ray) const {
  if (inverse_z_.size() == 0) return 0.0;
  double inverse_z = inverse_z_at(ray.direction.x());
  if (camera_.is_central()) return inverse_z;
  for (int step = 0; step < kMostWindowSteps; ++step) {
    const double before = inverse_z;
    inverse_z = inverse_z_at(seen_at(ray, inverse_z).x());
    if (std::abs(inverse_z - before) <= 1e-15) break;
  }
  return inverse_z;
}

void FaceShape::know_across() {
  inverse_z_slope_ = chebyshev_derivative(inverse_z_) / x_half_;
  if (!camera_.is_linear() || !camera_.is_perspective()) return;
  across_.assign(columns_.size(), Across{0.0, 0.0, 0.0, 0.0, 0.0});
  // x is linear in u.
  const CameraParameters& lens = camera_.parameters();
  const double x_first = -lens.cx_px / lens.fx_px, x_step = 1.0 / lens.fx_px;
  const double t_first = (x_first - x_mid_) / x_half_, t_step = x_step / x_half_;
  const auto n = static_cast<int>(columns_.size());
  std::vector<double> q(columns_.size()), q_slope(columns_.size());
  chebyshev_values(inverse_z_, t_first, t_step, n, q.data());
  chebyshev_values(inverse_z_slope_, t_first, t_step, n, q_slope.data());
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    const double x = x_first + static_cast<double>(u) * x_step;
    if (!columns_[u].valid) continue;
    if (const auto here = across_from(x, q[u], q_slope[u])) across_[u] = *here;
  }
}

double FaceShape::z_of_column(int u) const {
  const auto k = static_cast<std::size_t>(u);
  if (!across_.empty()) return across_[k].z_mm;
  const double middle = 0.5 * (columns_[k].upper_v + columns_[k].lower_v);
  const auto ray = camera_.unproject({static_cast<double>(u), middle});
  const double inverse_z = ray ? inverse_z_of(*ray) : 0.0;
  return inverse_z > 0.0 ? 1.0 / inverse_z : 0.0;
}

double FaceShape::inverse_z_at(double x) const {
  return chebyshev_value(inverse_z_, (x - x_mid_) / x_half_);
}

double FaceShape::inverse_z_slope_at(double x) const {
  return chebyshev_value(inverse_z_slope_, (x - x_mid_) / x_half_);
}

FaceShape FaceShape::plane(const Camera& camera, const Face& face) {
  FaceShape shape(camera, face);
  FaceColumn column;
  column.upper_v = -0.5 - 1e-9;
  column.lower_v = camera.size().height - 0.5 + 1e-9;
  column.z_mm = face.plane_z_mm;
  column.valid = true;
  shape.columns_.assign(static_cast<std::size_t>(camera.size().width), column);
  if (camera.is_perspective()) {
    shape.inverse_z_ = Eigen::VectorXd::Constant(1, 1.0 / face.plane_z_mm);
    shape.know_across();
  }
  shape.whole_picture_ = true;
  shape.finish();
  return shape;
}

void FaceShape::finish() {
  const auto valid = [](const FaceColumn& c) { return c.valid; };
  const auto first = std::find_if(columns_.begin(), columns_.end(), valid);
  const auto last = std::find_if(columns_.rbegin(), columns_.rend(), valid);
  base_at_low_u_ = first->z_mm <= last->z_mm;

  length_mm_.assign(columns_.size(), 0.0);
  std::optional<Eigen::Vector3d> before;
  double length = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t u = base_at_low_u_ ? i : columns_.size() - 1 - i;
    const FaceColumn& column = columns_[u];
    if (column.valid) {
      const auto ray =
          camera_.unproject({static_cast<double>(u), 0.5 * (column.upper_v + column.lower_v)});
      if (ray) {
        const Eigen::Vector3d here = ray->point_at(column.z_mm);
        if (before) length += std::hypot(here.x() - before->x(), here.z() - before->z());
        before = here;
      }
    }
    length_mm_[u] = length;
  }
}

FaceShape::Rows FaceShape::rows(int u, double margin_px) const {
  const FaceColumn& column = columns_[static_cast<std::size_t>(u)];
  if (!column.valid) return {0, -1};
  if (whole_picture_) return {0, camera_.size().height - 1};
  // A pixel is on the face when all of it is: its centre half a pixel inside, and the margin.
  const int first = static_cast<int>(std::ceil(column.upper_v + 0.5 + margin_px));
  const int last = static_cast<int>(std::floor(column.lower_v - 0.5 - margin_px));
  return {std::max(first, 0), std::min(last, camera_.size().height - 1)};
}

std::optional<FaceShape::Local> FaceShape::at(double u, double v) const {
  const auto nearest = static_cast<long>(std::lround(u));
  if (nearest < 0 || nearest >= width_px() || !columns_[static_cast<std::size_t>(nearest)].valid)
    return std::nullopt;
  const auto ray = camera_.unproject({u, v});
  if (!ray) return std::nullopt;

  const CameraParameters& lens = camera_.parameters();
  Local local;
  if (!camera_.is_perspective()) {
    local.view_point_mm = ray->point_at(face_.plane_z_mm);
    local.normal = Eigen::Vector3d::UnitZ();
    local.cos_incline = 1.0;
    local.area_mm2 = local.flat_area_mm2 = lens.mm_per_px * lens.mm_per_px;
    return local;
  }
  // Whole columns of a lens without distortion are known already.
  const auto column = static_cast<std::size_t>(nearest);
  const auto found = !across_.empty() && u == static_cast<double>(nearest)
                         ? std::optional<Across>(across_[column])
                         : across_of(*ray);
  if (!found || !(found->z_mm > 0.0)) return std::nullopt;
  const double z = found->z_mm;
  local.view_point_mm = ray->point_at(z);
  local.normal = {found->normal_x, 0.0, found->normal_z};
  local.cos_incline = found->normal_z;
  const double pixel = ray_area(*ray, u, v, 1.0 / z) * z * z * z;
  local.area_mm2 = pixel * found->length;
  local.flat_area_mm2 = pixel * found->along;
  return local;
}

std::vector<float> FaceShape::along_z_per_normal() const {
  std::vector<float> factors(columns_.size(), 1.0F);
  for (int u = 0; u < width_px(); ++u) {
    const FaceColumn& column = columns_[static_cast<std::size_t>(u)];
    if (const auto local = at(u, 0.5 * (column.upper_v + column.lower_v)))
      factors[static_cast<std::size_t>(u)] = static_cast<float>(1.0 / local->cos_incline);
  }
  return factors;
}

// With q = 1/z a function of x: p = (x, y, 1) / q, so dp/dx is along (q - x q', -y q', -q') and the
// normal across y is along (q', 0, q - x q'): no division by a slope, no cosine.
std::optional<FaceShape::Across> FaceShape::across_from(double x, double q, double q_slope) {
  if (!(q > 0.0)) return std::nullopt;
  const double along = q - x * q_slope;
  const double length = std::hypot(q_slope, along);
  if (!(length > 0.0) || !(along > 0.0)) return std::nullopt;
  return Across{1.0 / q, along, length, q_slope / length, along / length};
}

std::optional<FaceShape::Across> FaceShape::across_of(const Ray& ray) const {
  const double inverse_z = inverse_z_of(ray);
  const double x = seen_at(ray, inverse_z).x();
  return across_from(x, inverse_z, inverse_z_slope_at(x));
}

double FaceShape::ray_area(const Ray& ray, double u, double v, double inverse_z) const {
  const CameraParameters& lens = camera_.parameters();
  if (camera_.is_linear()) return 1.0 / (lens.fx_px * lens.fy_px);
  constexpr double kStep = 0.5;
  const auto right = camera_.unproject({u + kStep, v});
  const auto below = camera_.unproject({u, v + kStep});
  if (!right || !below) return 1.0 / (lens.fx_px * lens.fy_px);
  const Eigen::Vector2d here = seen_at(ray, inverse_z);
  const Eigen::Vector2d du = seen_at(*right, inverse_z) - here;
  const Eigen::Vector2d dv = seen_at(*below, inverse_z) - here;
  return std::abs(du.x() * dv.y() - du.y() * dv.x()) / (kStep * kStep);
}

double FaceShape::length_at(double u) const {
  const double clamped = std::clamp(u, 0.0, static_cast<double>(columns_.size() - 1));
  const auto left = static_cast<std::size_t>(clamped);
  const std::size_t right = std::min(left + 1, columns_.size() - 1);
  const double part = clamped - static_cast<double>(left);
  return length_mm_[left] + part * (length_mm_[right] - length_mm_[left]);
}

Eigen::Vector2d FaceShape::place_mm(double u, double v) const {
  const auto nearest = std::clamp<long>(std::lround(u), 0, width_px() - 1);
  const FaceColumn& column = columns_[static_cast<std::size_t>(nearest)];
  const double across = column.valid ? (v - 0.5 * (column.upper_v + column.lower_v)) *
                                           camera_.mm_per_px_at(column.z_mm)
                                     : 0.0;
  return {length_at(u), across};
}

Eigen::Vector3d untouched_point_mm(const FaceShape::Local& local,
                                   double layer_mm,
                                   MappingAlong along) {
  if (along == MappingAlong::kNormal) return local.view_point_mm + layer_mm * local.normal;
  constexpr double kCosLimit = 0.25881904510252074;  // of 75 degrees
  const double thickness = layer_mm / std::max(local.cos_incline, kCosLimit);
  return local.view_point_mm + Eigen::Vector3d(0.0, 0.0, thickness);
}

}  // namespace alltact
