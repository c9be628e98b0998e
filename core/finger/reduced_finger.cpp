#include "core/finger/reduced_finger.h"

#include "core/camera/reduced_image.h"

namespace alltact {

FingerSnapshot reduced_finger(const FingerSnapshot& finger, int by) {
  if (by == 1 || finger.reduced_by != 1) return finger;
  const CameraParameters parameters = reduced_camera(finger.finger.camera, by);
  auto camera = Camera::create(parameters);
  if (!camera) return finger;
  FingerSnapshot reduced = finger;
  reduced.reduced_by = by;
  reduced.full_camera = finger.finger.camera;
  reduced.finger.camera = parameters;
  reduced.camera = std::move(camera).value();
  if (auto& contact = reduced.finger.contact) {
    contact->threshold_px /= by;
    for (Eigen::Vector2d& marker : contact->rest_markers)
      marker = {reduced_px(marker.x(), by), reduced_px(marker.y(), by)};
  }
  if (auto& reference = reduced.finger.reference; reference && reference->positions)
    reference->positions->from_u_px = reduced_px(reference->positions->from_u_px, by);
  return reduced;
}

Result<cv::Mat> image_for(const FingerSnapshot& finger,
                          const cv::Mat& raw,
                          const Message& what,
                          const Where& where,
                          const Message& advice) {
  const CameraParameters& camera =
      finger.reduced_by == 1 ? finger.finger.camera : finger.full_camera;
  auto turned = oriented_for(camera, raw, what, where, advice);
  if (!turned) return turned.error();
  return reduced_image(*turned, finger.reduced_by);
}

}  // namespace alltact
