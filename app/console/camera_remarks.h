// What a camera remarks while a command reads it.
#pragma once

#include "app/console/console.h"
#include "core/sources/v4l2/v4l2_camera.h"

#include <memory>

namespace alltact {

/// Each remark once; nothing for sources that are no camera.
class CameraRemarks {
 public:
  explicit CameraRemarks(const Source& source) {
    if (const auto* from_camera = dynamic_cast<const CameraSource*>(&source))
      camera_ = from_camera->shared_camera();
  }
  void tell(Console& console) {
    if (!camera_) return;
    const CameraStatus status = camera_->status();
    const std::uint64_t kept = status.remarked - status.remarks.size();
    for (; told_ < status.remarked; ++told_)
      if (told_ >= kept) console.warn(status.remarks[told_ - kept].english());
  }

 private:
  std::shared_ptr<V4l2Camera> camera_;
  std::uint64_t told_ = 0;
};

}  // namespace alltact
