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
  Eigen::Vector3d from, up;  // from: direction from the target to the eye
};

/// In the camera's frame.
View view_of(Viewpoint viewpoint, const Eigen::Vector3d& inward) {
  const Eigen::Vector3d tilt(0, -0.6, 0);
  switch (viewpoint) {
    case Viewpoint::kCamera:
      return {{0, 0, -1}, {0, -1, 0}};
    case Viewpoint::kOutside:
      return {tilt - inward, {0, -1, 0}};
    case Viewpoint::kSide:
      return {{0, 1, 0}, {0, 0, -1}};
    case Viewpoint::kTilted:
      break;
  }
  return {tilt + inward, {0, -1, 0}};
}

}  // namespace

void SceneView::look_at(const Subject& subject,
                        Viewpoint viewpoint,
                        const int* window_px,
                        double used_width) {
  const View view = view_of(viewpoint, subject.inward);
  const Eigen::Vector3d back = subject.scene_from_camera.direction(view.from.normalized());
  const Eigen::Vector3d right =
      subject.scene_from_camera.direction(view.up).cross(back).normalized();
  const Eigen::Vector3d up = back.cross(right);
  const double aspect =
      window_px[0] > 0 && window_px[1] > 0 ? static_cast<double>(window_px[0]) / window_px[1] : 1.6;
  constexpr double kFilled = 0.95;
  const double up_slope = kFilled * std::tan(0.5 * kAngle_deg * kDegree);
  const double left_slope = aspect * up_slope, right_slope = left_slope * (2 * used_width - 1);
  // In the view's own axes an eye sees a point where x - x_eye <= slope (z_eye - z), and likewise
  // to the other sides. The eye is as near as possible: on two opposite sides one point lies on the
  // rim.
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
  set_view_pose({eye, eye - (z_eye - 0.5 * (nearest + furthest)) * back, up});
  eye_set_ = eye;
}

bool SceneView::is_unchanged() const {
  return eye_set_ && (pose().eye - *eye_set_).norm() < 1e-6;
}

void SceneView::turn(double right_deg, double up_deg) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->Azimuth(right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
  reset_clipping();
}

void SceneView::shift(double right_part, double up_part) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const ViewPose now = pose();
  const Eigen::Vector3d up = now.up.normalized();
  const Eigen::Vector3d right = (now.at - now.eye).cross(up).normalized();
  const double height =
      2 * camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * kDegree);
  const Eigen::Vector3d by = -height * (right_part * right + up_part * up);
  const Eigen::Vector3d new_eye = now.eye + by, new_at = now.at + by;
  camera->SetPosition(new_eye.data());
  camera->SetFocalPoint(new_at.data());
  reset_clipping();
}

void SceneView::dolly(double factor) {
  renderer_->GetActiveCamera()->Dolly(factor);
  reset_clipping();
}

void SceneView::set_view_pose(const ViewPose& pose) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetViewAngle(kAngle_deg);
  camera->SetPosition(pose.eye.data());
  camera->SetFocalPoint(pose.at.data());
  camera->SetViewUp(pose.up.data());
  eye_set_.reset();
  reset_clipping();
}

ViewPose SceneView::pose() const {
  vtkCamera* camera = renderer_->GetActiveCamera();
  return {Eigen::Vector3d(camera->GetPosition()),
          Eigen::Vector3d(camera->GetFocalPoint()),
          Eigen::Vector3d(camera->GetViewUp())};
}

void SceneView::reset_clipping() {
  renderer_->ResetCameraClippingRange();
}

}  // namespace alltact
