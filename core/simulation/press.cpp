#include "core/simulation/press.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

// Combines two presses: the larger depth wins; where one has depth 0, the other's bulge shows.
float combined(float a, float b) {
  if (a == 0.0F) return b;
  return b == 0.0F ? a : std::max(a, b);
}

// Depth along z over one LUF point. Within the contact it is the ball's own surface above (x, y).
// Around it the profile is intersected along z. On an inclined face this also moves the point
// towards the axis or away from it.
double ball_depth(const BallPress& press, const Eigen::Vector3d& luf) {
  const Eigen::Vector3d from_centre = luf - press.centre_mm;
  const double a = from_centre.dot(press.pose.along), y = from_centre.dot(press.pose.across);
  const double tilt = press.pose.along.z(), tilt_across = press.pose.across.z();
  const double upright = press.pose.normal.z();
  const double reach = press.reach_mm() + 2 * press.pose.depth_mm * std::abs(tilt_across);
  if (std::abs(y) > reach || std::abs(a) > reach + 2 * press.pose.depth_mm) return 0;

  const double contact = press.contact_radius_mm;
  if (contact > 0) {
    const double h2 = press.radius_mm * press.radius_mm - from_centre.x() * from_centre.x() -
                      from_centre.y() * from_centre.y();
    if (h2 > 0) {
      const double d = from_centre.z() + std::sqrt(h2);
      const double along = a - d * tilt, across = y - d * tilt_across;
      if (d > 0 && along * along + across * across <= contact * contact) return d;
    }
  }
  if (press.profile_mm.empty()) return 0;
  double d = press.profile_at(std::hypot(a, y)) / upright;
  for (int i = 0; i < 6; ++i) {
    const double along = a - d * tilt, across = y - d * tilt_across;
    const double r = std::sqrt(along * along + across * across);
    const double h = press.profile_at(r);
    const double h_r = (press.profile_at(r + BallPress::kStep_mm) - h) / BallPress::kStep_mm;
    const double slope = upright + (r > 0 ? h_r * (along * tilt + across * tilt_across) / r : 0.0);
    const double step = (d * upright - h) / std::max(slope, 0.2);
    d -= step;
    if (std::abs(step) < 1e-9) break;
  }
  return d;
}

Eigen::Vector3d luf_of(const FaceRow& face, int u) {
  return {face.x_mm[u], face.y_mm[u], double{face.z_mm[u]} + face.luf_mm[u]};
}

double body_depth(const BodyPress& press, const Eigen::Vector3d& luf) {
  const double lowest = press.posed(luf.x(), luf.y(), luf.z());
  return std::isfinite(lowest) ? luf.z() - lowest : 0.0;
}

// Column and row of the grid over a point of the face.
Eigen::Vector2d grid_position(const SampledPress& press, const FaceRow& face, int u) {
  const double c = std::cos(press.rotation_rad), s = std::sin(press.rotation_rad);
  const double along = double{face.s_mm[u]} - press.pose.s_mm;
  const double across = double{face.y_mm[u]} - face.shift_mm[u] - press.pose.y_mm;
  return {(c * along + s * across) / press.step_mm + 0.5 * (press.depth_mm.cols - 1),
          (c * across - s * along) / press.step_mm + 0.5 * (press.depth_mm.rows - 1)};
}

}  // namespace

double BallPress::profile_at(double r_mm) const {
  const double at = r_mm / kStep_mm;
  const auto i = static_cast<std::size_t>(at);
  if (i + 1 >= profile_mm.size()) return 0;
  const double t = at - static_cast<double>(i);
  return profile_mm[i] + t * (double{profile_mm[i + 1]} - double{profile_mm[i]});
}

double BallPress::ball_profile(double r_mm) const {
  // R - sqrt(R^2 - r^2) without its cancellation.
  const double root = std::sqrt(std::max(0.0, radius_mm * radius_mm - r_mm * r_mm));
  return pose.normal_depth_mm() - r_mm * r_mm / (radius_mm + root);
}

ContactTruth contact_truth(const PressPose& pose) {
  ContactTruth truth;
  truth.along_mm = pose.s_mm;
  truth.across_mm = pose.y_mm;
  truth.depth_mm = pose.depth_mm;
  truth.point_mm = pose.luf_mm;
  truth.direction = -pose.normal;
  return truth;
}

BallPress make_ball_press(const PressPose& pose, double radius_mm) {
  BallPress press;
  press.pose = pose;
  press.radius_mm = radius_mm;
  press.centre_mm = pose.luf_mm - Eigen::Vector3d(0, 0, pose.depth_mm) + radius_mm * pose.normal;
  const double depth = pose.normal_depth_mm();
  press.contact_radius_mm = radius_mm;
  press.rim_mm = std::sqrt(depth * (2 * radius_mm - depth));
  return press;
}

double BodyPress::reach_mm() const { return body->reach_mm(); }

double SampledPress::reach_mm() const {
  return 0.5 * step_mm * std::hypot(depth_mm.cols, depth_mm.rows);
}

void press_row(const BallPress& press, const FaceRow& face, int first, int last, float* depth_mm) {
  for (int u = first; u < last; ++u)
    if (face.coverage[u] > 0)
      depth_mm[u] = combined(depth_mm[u], static_cast<float>(ball_depth(press, luf_of(face, u))));
}

void press_row(const BodyPress& press, const FaceRow& face, int first, int last, float* depth_mm) {
  for (int u = first; u < last; ++u)
    if (face.coverage[u] > 0)
      depth_mm[u] = combined(depth_mm[u], static_cast<float>(body_depth(press, luf_of(face, u))));
}

void press_row(const SampledPress& press, const FaceRow& face, int first, int last,
               float* depth_mm) {
  const cv::Mat_<float>& grid = press.depth_mm;
  for (int u = first; u < last; ++u) {
    if (face.coverage[u] <= 0) continue;
    const Eigen::Vector2d at = grid_position(press, face, u);
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < grid.cols - 1 && at.y() < grid.rows - 1)) continue;
    const int i = static_cast<int>(at.x()), j = static_cast<int>(at.y());
    const double tx = at.x() - i, ty = at.y() - j;
    const double upper = grid(j, i) + tx * (double{grid(j, i + 1)} - grid(j, i));
    const double lower = grid(j + 1, i) + tx * (double{grid(j + 1, i + 1)} - grid(j + 1, i));
    depth_mm[u] = combined(depth_mm[u], static_cast<float>(upper + ty * (lower - upper)));
  }
}

bool is_in_contact(const BallPress& press, const FaceRow& face, int u) {
  const Eigen::Vector3d luf = luf_of(face, u);
  const double depth = ball_depth(press, luf);
  const Eigen::Vector3d from_centre = luf - Eigen::Vector3d(0, 0, depth) - press.centre_mm;
  const double from_axis =
      std::hypot(from_centre.dot(press.pose.along), from_centre.dot(press.pose.across));
  return depth > 0 && from_axis <= press.rim_mm;
}

bool is_in_contact(const BodyPress& press, const FaceRow& face, int u) {
  return body_depth(press, luf_of(face, u)) > 0;
}

bool is_in_contact(const SampledPress& press, const FaceRow& face, int u) {
  const Eigen::Vector2d at = grid_position(press, face, u);
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
  return i >= 0 && j >= 0 && i < press.in_contact.cols && j < press.in_contact.rows &&
         press.in_contact(j, i) > 0;
}

namespace {

constexpr double kMinPressUpright = 0.08;
constexpr int kHalvings = 44;
constexpr int kSupportSteps = 256;

// Searches along the line over (x, y), by the height above the object's lowest plane.
double lowest_z_mm(const HeightField& body, const Eigen::Isometry3d& object_from_camera,
                   const Eigen::Vector3d& at_mm) {
  const Eigen::Vector3d up = object_from_camera.linear().col(2);  // the camera's z
  if (up.z() < kMinPressUpright) return HeightField::kNothing_mm;
  const double below_mm = at_mm.z();
  const Eigen::Vector3d top = object_from_camera * at_mm;
  const double highest = top.z();
  if (!(highest > 0)) return HeightField::kNothing_mm;
  const Eigen::Vector2d drift = up.head<2>() / up.z();
  // Positive inside the body.
  const auto inside = [&](double height) {
    const Eigen::Vector2d at = top.head<2>() + (height - highest) * drift;
    return height - body.gap_mm(at.x(), at.y());
  };
  const auto z_at = [&](double height) { return below_mm + (height - highest) / up.z(); };
  const double travel = highest * drift.norm();
  if (travel < 1e-9) {
    const double gap = body.gap_mm(top.x(), top.y());
    return gap < highest ? z_at(gap) : HeightField::kNothing_mm;
  }
  if (inside(0) >= 0) return z_at(0);
  const int steps = static_cast<int>(travel / body.finest_mm()) + 1;
  double outside = 0;
  for (int i = 1; i <= steps; ++i) {
    double within = highest * i / steps;
    if (!(inside(within) > 0)) {
      outside = within;
      continue;
    }
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (outside + within);
      (inside(middle) > 0 ? within : outside) = middle;
    }
    return z_at(within);
  }
  return HeightField::kNothing_mm;
}

}  // namespace

PosedBody HeightField::posed(const Eigen::Isometry3d& camera_from_object) const {
  return [this, object_from_camera = camera_from_object.inverse()](double x_mm, double y_mm,
                                                                   double below_mm) {
    return lowest_z_mm(*this, object_from_camera, {x_mm, y_mm, below_mm});
  };
}

double HeightField::min_along_mm(const Eigen::Vector3d& direction) const {
  if (direction.head<2>().norm() < 1e-12) return 0;
  const Eigen::Vector2d half = half_size_mm();
  double min_value = kNothing_mm;
  for (int i = 0; i <= kSupportSteps; ++i)
    for (int k = 0; k <= kSupportSteps; ++k) {
      const double x = half.x() * (2.0 * i / kSupportSteps - 1);
      const double y = half.y() * (2.0 * k / kSupportSteps - 1);
      const double gap = gap_mm(x, y);
      if (std::isfinite(gap))
        min_value = std::min(min_value, direction.dot(Eigen::Vector3d(x, y, gap)));
    }
  return std::isfinite(min_value) ? min_value : 0;
}

}  // namespace alltact
