// Remarks of a camera while a command reads it.
#pragma once

#include "app/console/console.h"
#include "core/sources/v4l2/v4l2_camera.h"

#include <memory>

namespace alltact {

/// Prints each remark once; does nothing for sources that are no camera.
class CameraRemarks {
 public:
  explicit CameraRemarks(const Source& source) {
    if (const auto* from_camera = dynamic_cast<const CameraSource*>(&source))
      camera_ = from_camera->shared_camera();
  }
  void report(Console& console) {
    if (!camera_) return;
    const CameraStatus status = camera_->status();
    const std::uint64_t first_stored = status.remarked - status.remarks.size();
    for (; reported_ < status.remarked; ++reported_)
      if (reported_ >= first_stored)
        console.warn(status.remarks[reported_ - first_stored].english());
  }

 private:
  std::shared_ptr<V4l2Camera> camera_;
  std::uint64_t reported_ = 0;
};

}  // namespace alltact
