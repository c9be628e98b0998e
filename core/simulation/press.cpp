#include "core/simulation/press.h"

#include <algorithm>
#include <cmath>

namespace alltact {

namespace {

// Two presses: the deeper counts; beside a press (0) another one's bulge shows.
float combined(float a, float b) {
  if (a == 0.0F) return b;
  return b == 0.0F ? a : std::max(a, b);
}

// Depth along z over one LUF point. In the contact it is the ball's own surface above (x, y);
// around it the profile is met by going down along z, which also moves the point towards the
// axis or away from it where the face is inclined.
double ball_depth(const BallPress& press, const Eigen::Vector3d& luf) {
  const Eigen::Vector3d from_centre = luf - press.centre_mm;
  const double a = from_centre.dot(press.place.along);
  const double y = from_centre.y();
  const double tilt = press.place.along.z(), upright = press.place.normal.z();
  const double across2 = y * y;
  const double reach = press.reach_mm();
  if (std::abs(y) > reach || std::abs(a) > reach + 2 * press.place.depth_mm) return 0;

  const double contact = press.contact_radius_mm;
  if (contact > 0) {
    const double h2 =
        press.radius_mm * press.radius_mm - from_centre.x() * from_centre.x() - across2;
    if (h2 > 0) {
      const double d = from_centre.z() + std::sqrt(h2);
      const double along = a - d * tilt;
      if (d > 0 && along * along + across2 <= contact * contact) return d;
    }
  }
  if (press.profile_mm.empty()) return 0;
  double d = press.profile_at(std::hypot(a, y)) / upright;
  for (int i = 0; i < 6; ++i) {
    const double along = a - d * tilt;
    const double r = std::sqrt(along * along + across2);
    const double h = press.profile_at(r);
    const double h_r = (press.profile_at(r + BallPress::kStep_mm) - h) / BallPress::kStep_mm;
    const double slope = upright + (r > 0 ? h_r * along / r * tilt : 0.0);
    const double step = (d * upright - h) / std::max(slope, 0.2);
    d -= step;
    if (std::abs(step) < 1e-9) break;
  }
  return d;
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
  return place.normal_depth_mm() - r_mm * r_mm / (radius_mm + root);
}

BallPress make_ball_press(const PressPlace& place, double radius_mm) {
  BallPress press;
  press.place = place;
  press.radius_mm = radius_mm;
  press.centre_mm = place.luf_mm - Eigen::Vector3d(0, 0, place.depth_mm) + radius_mm * place.normal;
  const double depth = place.normal_depth_mm();
  press.contact_radius_mm = radius_mm;
  press.rim_mm = std::sqrt(depth * (2 * radius_mm - depth));
  return press;
}

double ReliefPress::reach_mm() const {
  return 0.5 * step_mm * std::hypot(depth_mm.cols, depth_mm.rows);
}

void press_row(const BallPress& press, const FaceRow& face, int first, int last, float* depth_mm) {
  for (int u = first; u < last; ++u) {
    if (face.coverage[u] <= 0) continue;
    const Eigen::Vector3d luf(face.x_mm[u], face.y_mm[u], double{face.z_mm[u]} + face.luf_mm[u]);
    depth_mm[u] = combined(depth_mm[u], static_cast<float>(ball_depth(press, luf)));
  }
}

void press_row(
    const ReliefPress& press, const FaceRow& face, int first, int last, float* depth_mm) {
  const double c = std::cos(press.rotation_rad), s = std::sin(press.rotation_rad);
  const cv::Mat_<float>& grid = press.depth_mm;
  for (int u = first; u < last; ++u) {
    if (face.coverage[u] <= 0) continue;
    const double along = double{face.s_mm[u]} - press.place.s_mm;
    const double across = double{face.y_mm[u]} - face.shift_mm[u] - press.place.y_mm;
    const double column = (c * along + s * across) / press.step_mm + 0.5 * (grid.cols - 1);
    const double row = (c * across - s * along) / press.step_mm + 0.5 * (grid.rows - 1);
    if (!(column >= 0 && row >= 0 && column < grid.cols - 1 && row < grid.rows - 1)) continue;
    const int i = static_cast<int>(column), j = static_cast<int>(row);
    const double tx = column - i, ty = row - j;
    const double upper = grid(j, i) + tx * (double{grid(j, i + 1)} - grid(j, i));
    const double lower = grid(j + 1, i) + tx * (double{grid(j + 1, i + 1)} - grid(j + 1, i));
    const double normal_depth = upper + ty * (lower - upper);
    depth_mm[u] = combined(depth_mm[u], static_cast<float>(normal_depth / press.place.normal.z()));
  }
}

}  // namespace alltact
