// Controls a camera without blocking the window: a thread of its own makes every system call.
#pragma once

#include "core/base/worker.h"
#include "core/devices/v4l2_camera.h"

#include <memory>
#include <optional>
#include <vector>

namespace alltact {

struct CameraControllerStatus {
  bool has_camera = false;
  std::vector<CameraControl> controls;  ///< of the last poll, about once a second
  bool is_locked = false;
  std::optional<Error> problem;  ///< of the last refused change
};

/// Any thread may call any function; none waits for the camera.
class CameraController {
 public:
  CameraController();
  ~CameraController();
  CameraController(const CameraController&) = delete;
  CameraController& operator=(const CameraController&) = delete;

  /// Sets the camera to control, null for none. A new camera first gets the values `requested`, and
  /// the lock where that is on.
  void attach(std::shared_ptr<V4l2Camera> camera, const std::vector<ControlValue>& requested);
  void set(const ControlValue& control);
  void set_lock(bool is_locked);
  [[nodiscard]] CameraControllerStatus status() const;

 private:
  struct State;
  std::shared_ptr<State> state_;  // the thread may be inside a slow driver when this ends
  Worker worker_;
};

}  // namespace alltact
