#include "widgets/scene3d/scene_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace alltact {
namespace {

constexpr double kAngle_deg = 25;  // of the view, from top to bottom
constexpr double kDegree = std::numbers::pi / 180;

struct View {
  Eigen::Vector3d from, up;  // from: direction from what is looked at to the eye
};

/// In the camera's frame.
View view_of(Standpoint standpoint, const Eigen::Vector3d& inward) {
  const Eigen::Vector3d tilt(0, -0.6, 0);
  switch (standpoint) {
    case Standpoint::kCamera:
      return {{0, 0, -1}, {0, -1, 0}};
    case Standpoint::kOutside:
      return {tilt - inward, {0, -1, 0}};
    case Standpoint::kSide:
      return {{0, 1, 0}, {0, 0, -1}};
    case Standpoint::kTilted:
      break;
  }
  return {tilt + inward, {0, -1, 0}};
}

}  // namespace

void SceneView::look_at(const Subject& subject,
                        Standpoint standpoint,
                        const int* window_px,
                        double used_width) {
  const View view = view_of(standpoint, subject.inward);
  const Eigen::Vector3d back = subject.scene_from_camera.direction(view.from.normalized());
  const Eigen::Vector3d right =
      subject.scene_from_camera.direction(view.up).cross(back).normalized();
  const Eigen::Vector3d up = back.cross(right);
  const double aspect =
      window_px[0] > 0 && window_px[1] > 0 ? static_cast<double>(window_px[0]) / window_px[1] : 1.6;
  constexpr double kFilled = 0.95;
  const double up_slope = kFilled * std::tan(0.5 * kAngle_deg * kDegree);
  const double left_slope = aspect * up_slope, right_slope = left_slope * (2 * used_width - 1);
  // In the view's own axes a point is in sight of an eye where x - x_eye <= slope (z_eye - z), and
  // likewise to the other sides: so near that on two opposite sides one of them touches the rim.
  constexpr double kFar = std::numeric_limits<double>::lowest();
  double rightmost = kFar, leftmost = kFar, top = kFar, bottom = kFar, nearest = kFar;
  double furthest = -kFar;
  for (const Eigen::Vector3d& p : subject.points) {
    const double x = p.dot(right), y = p.dot(up), z = p.dot(back);
    rightmost = std::max(rightmost, x + right_slope * z);
    leftmost = std::max(leftmost, left_slope * z - x);
    top = std::max(top, y + up_slope * z);
    bottom = std::max(bottom, up_slope * z - y);
    nearest = std::max(nearest, z);
    furthest = std::min(furthest, z);
  }
  if (subject.points.empty()) return;
  const double z_eye = std::max({(rightmost + leftmost) / (right_slope + left_slope),
                                 (top + bottom) / (2 * up_slope),
                                 nearest + 1});
  const double x_eye = 0.5 * (rightmost - leftmost + (left_slope - right_slope) * z_eye);
  const double y_eye = 0.5 * (top - bottom);
  const Eigen::Vector3d eye = x_eye * right + y_eye * up + z_eye * back;
  look_as({eye, eye - (z_eye - 0.5 * (nearest + furthest)) * back, up});
  eye_set_ = eye;
}

bool SceneView::is_as_set() const {
  return eye_set_ && (look().eye - *eye_set_).norm() < 1e-6;
}

void SceneView::turn(double right_deg, double up_deg) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->Azimuth(right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
  keep_in_sight();
}

void SceneView::shift(double right_part, double up_part) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const Look now = look();
  const Eigen::Vector3d up = now.up.normalized();
  const Eigen::Vector3d right = (now.at - now.eye).cross(up).normalized();
  const double height =
      2 * camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * kDegree);
  const Eigen::Vector3d by = -height * (right_part * right + up_part * up);
  const Eigen::Vector3d new_eye = now.eye + by, new_at = now.at + by;
  camera->SetPosition(new_eye.data());
  camera->SetFocalPoint(new_at.data());
  keep_in_sight();
}

void SceneView::come_closer(double factor) {
  renderer_->GetActiveCamera()->Dolly(factor);
  keep_in_sight();
}

void SceneView::look_as(const Look& look) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetViewAngle(kAngle_deg);
  camera->SetPosition(look.eye.data());
  camera->SetFocalPoint(look.at.data());
  camera->SetViewUp(look.up.data());
  eye_set_.reset();
  keep_in_sight();
}

Look SceneView::look() const {
  vtkCamera* camera = renderer_->GetActiveCamera();
  return {Eigen::Vector3d(camera->GetPosition()),
          Eigen::Vector3d(camera->GetFocalPoint()),
          Eigen::Vector3d(camera->GetViewUp())};
}

void SceneView::keep_in_sight() {
  renderer_->ResetCameraClippingRange();
}

}  // namespace alltact
