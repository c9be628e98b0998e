#include "core/live/camera_controller.h"

#include <chrono>
#include <deque>
#include <mutex>

namespace alltact {
namespace {

constexpr std::chrono::milliseconds kControlPoll{1000};
constexpr std::chrono::seconds kReportTime{10};  // duration of the message about a refused change

}  // namespace

struct CameraController::State {
  mutable std::mutex mutex;
  std::condition_variable_any changed;
  std::shared_ptr<V4l2Camera> camera;
  bool is_lock_requested = true;
  bool is_lock_changed = false;  // to be sent to the camera...
  bool is_lock_urgent = false;   // ...and at once
  std::deque<ControlValue> changes;
  CameraControllerStatus status;
  std::chrono::steady_clock::time_point reported_since;

  void run(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      const auto working = camera;
      if (working) serve(*working, lock);
      // Changes without a camera wait for one.
      const auto is_due = [&] {
        return camera != working || (camera && (!changes.empty() || is_lock_urgent));
      };
      if (working)
        changed.wait_for(lock, stop, kControlPoll, is_due);
      else
        changed.wait(lock, stop, is_due);
    }
  }

  void serve(V4l2Camera& working, std::unique_lock<std::mutex>& lock) {
    const auto todo = std::exchange(changes, {});
    const bool change_lock = std::exchange(is_lock_changed, false);
    is_lock_urgent = false;
    const bool lock_requested = is_lock_requested;
    lock.unlock();
    std::optional<Error> problem;
    bool is_lock_failed = false, is_locked = false;
    std::optional<Result<std::vector<CameraControl>>> controls;
    const Status ran = guarded([&] {
      for (const ControlValue& change : todo)
        if (const Status set = working.set_control(change); !set) problem = set.error();
      // Unplugged: tried again at the next poll.
      if (change_lock && lock_requested) is_lock_failed = !working.lock().ok();
      if (change_lock && !lock_requested) working.unlock();
      is_locked = !working.locked().empty();
      controls = working.controls();
    });
    if (!ran) problem = ran.error();
    lock.lock();
    if (camera.get() != &working) return;
    if (controls && *controls) status.controls = std::move(**controls);
    status.is_locked = is_locked;
    is_lock_changed = is_lock_changed || is_lock_failed;
    if (problem) {
      status.problem = problem;
      reported_since = std::chrono::steady_clock::now();
    } else if (!todo.empty() || std::chrono::steady_clock::now() > reported_since + kReportTime) {
      status.problem.reset();
    }
  }
};

CameraController::CameraController()
    : state_(std::make_shared<State>()),
      worker_([state = state_](const std::stop_token& stop) { state->run(stop); }) {}

CameraController::~CameraController() {
  attach(nullptr, {});
  worker_.end_later();
}

void CameraController::attach(std::shared_ptr<V4l2Camera> camera,
                              const std::vector<ControlValue>& requested) {
  const std::lock_guard lock(state_->mutex);
  if (camera == state_->camera) return;
  state_->camera = std::move(camera);
  state_->status = {};
  state_->status.has_camera = state_->camera != nullptr;
  state_->changes.assign(requested.begin(), requested.end());
  state_->is_lock_changed = state_->is_lock_requested;
  state_->changed.notify_all();
}

void CameraController::set(const ControlValue& control) {
  const std::lock_guard lock(state_->mutex);
  std::erase_if(state_->changes, [&](const ControlValue& old) { return old.id == control.id; });
  state_->changes.push_back(control);
  state_->changed.notify_all();
}

void CameraController::set_lock(bool is_locked) {
  const std::lock_guard lock(state_->mutex);
  if (state_->is_lock_requested == is_locked) return;
  state_->is_lock_requested = is_locked;
  state_->is_lock_changed = state_->is_lock_urgent = true;
  state_->changed.notify_all();
}

CameraControllerStatus CameraController::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

}  // namespace alltact
