#include "core/sources/v4l2/v4l2_camera.h"

namespace alltact {

CameraSource::CameraSource(std::shared_ptr<V4l2Camera> camera, std::size_t capacity)
    : camera_(std::move(camera)), queue_(camera_->frames().subscribe(capacity)) {}

double CameraSource::frames_per_s() const {
  const double rate = camera_->settings().format.frames_per_second();
  return rate > 0 ? rate : Source::frames_per_s();
}

Result<FramePtr> CameraSource::next() {
  if (auto item = queue_->next(std::chrono::seconds(1))) return std::move(*item);
  const auto status = camera_->status();
  if (status.trouble) return *status.trouble;
  return Error{en::say("the camera has sent no picture for a second"),
               camera_->settings().identity,
               en::say("look after the cable and the USB port")};
}

}  // namespace alltact
