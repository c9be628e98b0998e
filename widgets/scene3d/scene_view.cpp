#include "widgets/scene3d/scene_view.h"

#include <cmath>
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
  Eigen::AlignedBox3d box;  // in the view's own axes
  for (const Eigen::Vector3d& p : subject.points)
    box.extend(Eigen::Vector3d(p.dot(right), p.dot(up), p.dot(back)));
  const Eigen::Vector3d centre = box.center();
  const double aspect =
      window_px[0] > 0 && window_px[1] > 0 ? static_cast<double>(window_px[0]) / window_px[1] : 1.6;
  constexpr double kFilled = 0.92;
  const double slope = std::tan(0.5 * kAngle_deg * kDegree);
  double away = 1;
  for (const Eigen::Vector3d& p : subject.points) {
    const double x = std::abs(p.dot(right) - centre.x()) / (slope * aspect * used_width * kFilled);
    const double y = std::abs(p.dot(up) - centre.y()) / (slope * kFilled);
    away = std::max(away, std::max(x, y) + p.dot(back) - centre.z());
  }
  const double aside = away * slope * aspect * (1 - used_width);
  const Eigen::Vector3d at = (centre.x() + aside) * right + centre.y() * up + centre.z() * back;
  const Eigen::Vector3d eye = at + away * back;
  look_as({eye, at, up});
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
