#include "core/geometry/ball.h"

#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

/// Two unit vectors orthogonal to `axis` and to each other.
std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& axis) {
  const Eigen::Vector3d first = axis.unitOrthogonal();
  return {first, axis.normalized().cross(first)};
}

}  // namespace

std::optional<RayHit> intersect_ball(const Ray& ray, const Eigen::Vector3d& centre_mm,
                                     double radius_mm) {
  const Eigen::Vector3d& u = ray.direction;
  const Eigen::Vector3d c = centre_mm - ray.origin_mm;
  const double a = u.squaredNorm();
  if (!(a > 0.0) || !(radius_mm > 0.0)) return std::nullopt;
  const double b = c.dot(u);
  // |c x u| / |u| is the distance of the centre from the line. The cross product retains digits
  // that c - (b/a) u would lose.
  const double from_line = c.cross(u).norm() / std::sqrt(a);
  const double discriminant = a * (radius_mm - from_line) * (radius_mm + from_line);
  if (!(discriminant >= 0.0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const double q = b >= 0.0 ? b + root : b - root;
  const double length = c.norm();
  const double product = (length - radius_mm) * (length + radius_mm);
  const double one = q / a;
  const double other = q != 0.0 ? product / q : 0.0;
  return b >= 0.0 ? RayHit{other, one} : RayHit{one, other};
}

double angle_between(const Eigen::Vector3d& p, const Eigen::Vector3d& c) {
  return std::atan2((p - c).cross(c).norm(), p.dot(c));
}

double sine_between(const Eigen::Vector3d& p, const Eigen::Vector3d& c) {
  return (p - c).cross(c).norm() / (p.norm() * c.norm());
}

std::vector<Eigen::Vector3d> ball_horizon_mm(bool perspective, const Eigen::Vector3d& centre_mm,
                                             double radius_mm, int count) {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d middle = centre_mm;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double horizon_mm = radius_mm;
  if (perspective) {
    const double distance = centre_mm.norm();
    if (!(distance > radius_mm)) return points;
    // The plane of tangency lies R^2 / |c| nearer than the centre.
    const double ratio = radius_mm / distance;
    axis = centre_mm / distance;
    middle = centre_mm - axis * (radius_mm * ratio);
    horizon_mm = radius_mm * std::sqrt((1.0 - ratio) * (1.0 + ratio));
  }
  const auto [first, second] = across(axis);
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    points.emplace_back(middle + horizon_mm * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

namespace {

/// Distance by which the line of sight through a pixel misses the ball.
std::optional<double> clearance_mm(const Camera& camera, const Eigen::Vector2d& pixel,
                                   const Eigen::Vector3d& centre_mm, double radius_mm) {
  const auto ray = camera.unproject(pixel);
  if (!ray) return std::nullopt;
  return (centre_mm - ray->origin_mm).cross(ray->direction).norm() / ray->direction.norm() -
         radius_mm;
}

/// Moves a pixel near the outline along the line through `middle` until its line of sight is
/// tangent to the ball. Rays behind a window do not start in one point, so the horizon of any point
/// only approximates the true one.
Eigen::Vector2d grazing_pixel(const Camera& camera, const Eigen::Vector2d& middle,
                              Eigen::Vector2d pixel, const Eigen::Vector3d& centre_mm,
                              double radius_mm) {
  const Eigen::Vector2d outward = (pixel - middle).normalized();
  double step = 0.1;
  auto here = clearance_mm(camera, pixel, centre_mm, radius_mm);
  for (int i = 0; here && i < 8 && std::abs(step) > 1e-9; ++i) {  // secant method
    const auto there = clearance_mm(camera, pixel + step * outward, centre_mm, radius_mm);
    if (!there || *there == *here) break;
    pixel += step * outward;
    step *= -*there / (*there - *here);
    here = there;
  }
  return pixel;
}

}  // namespace

std::vector<Eigen::Vector2d> ball_outline_px(const Camera& camera, const Eigen::Vector3d& centre_mm,
                                             double radius_mm, int count) {
  std::vector<Eigen::Vector2d> outline;
  for (const Eigen::Vector3d& point :
       ball_horizon_mm(camera.is_perspective(), centre_mm, radius_mm, count))
    if (const auto pixel = camera.project(point)) outline.push_back(*pixel);
  const auto middle = camera.project(centre_mm);
  if (camera.is_perspective() && !camera.is_central() && middle)
    for (Eigen::Vector2d& pixel : outline)
      pixel = grazing_pixel(camera, *middle, pixel, centre_mm, radius_mm);
  return outline;
}

std::optional<OutlineEllipse> ball_ellipse(const Eigen::Vector3d& centre_mm, double radius_mm) {
  const double x = std::hypot(centre_mm.x(), centre_mm.y());
  const double z = centre_mm.z();
  const double distance = std::hypot(x, z);
  // D |c|^2 = z^2 - R^2, with D = cos^2(theta) - sin^2(alpha).
  const double d = (z - radius_mm) * (z + radius_mm);
  if (!(z > 0.0) || !(d > 0.0) || !(radius_mm > 0.0)) return std::nullopt;
  const double cone = std::sqrt((distance - radius_mm) * (distance + radius_mm));
  OutlineEllipse ellipse;
  ellipse.centre = centre_mm.head<2>() * (z / d);
  ellipse.long_axis = radius_mm * cone / d;
  ellipse.short_axis = radius_mm / std::sqrt(d);
  return ellipse;
}

std::optional<Eigen::Vector3d> fit_ball_to_outline(const std::vector<Eigen::Vector3d>& directions,
                                                   double radius_mm) {
  const auto n = static_cast<Eigen::Index>(directions.size());
  if (n < 3 || !(radius_mm > 0.0)) return std::nullopt;
  Eigen::MatrixXd units(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
    units.row(i) = directions[static_cast<std::size_t>(i)].normalized();
  if (!units.allFinite()) return std::nullopt;

  // Unit vectors of a cone end in one plane u . w = 1, w = axis / cos(alpha).
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(units);
  if (qr.rank() < 3) return std::nullopt;
  Eigen::Vector3d axis = qr.solve(ones);
  if (!axis.allFinite() || !(axis.norm() > 0.0)) return std::nullopt;
  axis.normalize();
  double alpha = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    alpha += angle_between(units.row(i).transpose(), axis) / static_cast<double>(n);
  if (!(alpha > 0.0) || !(alpha < M_PI_2)) return std::nullopt;

  // Gauss-Newton on angle - alpha in (axis, alpha): the model is close to linear from here.
  for (int iteration = 0; iteration < 50; ++iteration) {
    const auto [first, second] = across(axis);
    Eigen::MatrixXd jacobian(n, 3);
    Eigen::VectorXd residual(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector3d u = units.row(i).transpose();
      const double angle = angle_between(u, axis);
      const double sine = std::max(std::sin(angle), 1e-12);
      residual[i] = angle - alpha;
      jacobian.row(i) << -u.dot(first) / sine, -u.dot(second) / sine, -1.0;
    }
    const Eigen::Vector3d step = jacobian.colPivHouseholderQr().solve(-residual);
    if (!step.allFinite()) return std::nullopt;
    axis = (axis + step[0] * first + step[1] * second).normalized();
    alpha += step[2];
    if (!(alpha > 0.0) || !(alpha < M_PI_2)) return std::nullopt;
    if (step.norm() < 1e-15) break;
  }
  return Eigen::Vector3d(axis * (radius_mm / std::sin(alpha)));
}

}  // namespace alltact
