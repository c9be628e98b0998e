#include "core/live/camera_controller.h"

#include <chrono>

namespace alltact {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{1000};
constexpr std::chrono::seconds kTold{10};  // how long a refused change is told of

}  // namespace

struct CameraController::State {
  mutable std::mutex mutex;
  std::condition_variable news;
  bool is_ending = false;
  std::shared_ptr<V4l2Camera> camera;
  bool is_lock_wanted = true;
  bool is_lock_changed = false;  // to be told to the camera...
  bool is_lock_asked = false;    // ...and at once
  std::deque<ControlValue> changes;
  CameraControllerStatus status;
  std::chrono::steady_clock::time_point told_since;

  void run() {
    std::unique_lock lock(mutex);
    while (!is_ending) {
      const auto working = camera;
      if (working) serve(*working, lock);
      news.wait_for(lock, kBetweenLooks, [&] {
        // What is asked for while there is no camera waits for one.
        return is_ending || camera != working || (camera && (!changes.empty() || is_lock_asked));
      });
    }
  }

  void serve(V4l2Camera& working, std::unique_lock<std::mutex>& lock) {
    const auto todo = std::exchange(changes, {});
    const bool change_lock = std::exchange(is_lock_changed, false);
    is_lock_asked = false;
    const bool want_lock = is_lock_wanted;
    lock.unlock();
    std::optional<Error> problem;
    bool is_lock_failed = false;
    for (const ControlValue& change : todo)
      if (const Status status = working.set_control(change); !status) problem = status.error();
    if (change_lock && want_lock) {
      is_lock_failed = !working.lock().ok();  // unplugged: tried again at the next look
    }
    if (change_lock && !want_lock) working.unlock();
    auto controls = working.controls();
    const bool is_locked = !working.locked().empty();
    lock.lock();
    if (camera.get() != &working) return;
    if (controls) status.controls = std::move(*controls);
    status.is_locked = is_locked;
    is_lock_changed = is_lock_changed || is_lock_failed;
    if (problem) {
      status.problem = problem;
      told_since = std::chrono::steady_clock::now();
    } else if (!todo.empty() || std::chrono::steady_clock::now() > told_since + kTold) {
      status.problem.reset();
    }
  }
};

CameraController::CameraController() : state_(std::make_shared<State>()), stopper_{state_} {
  std::thread([state = state_] { state->run(); }).detach();
}

CameraController::Stopper::~Stopper() {
  const std::lock_guard lock(state->mutex);
  state->is_ending = true;
  state->camera.reset();
  state->news.notify_all();
}

void CameraController::attach(std::shared_ptr<V4l2Camera> camera,
                              const std::vector<ControlValue>& wanted) {
  const std::lock_guard lock(state_->mutex);
  if (camera == state_->camera) return;
  state_->camera = std::move(camera);
  state_->status = {};
  state_->status.has_camera = state_->camera != nullptr;
  state_->changes.assign(wanted.begin(), wanted.end());
  state_->is_lock_changed = state_->is_lock_wanted;
  state_->news.notify_all();
}

void CameraController::set(const ControlValue& control) {
  const std::lock_guard lock(state_->mutex);
  std::erase_if(state_->changes, [&](const ControlValue& old) { return old.id == control.id; });
  state_->changes.push_back(control);
  state_->news.notify_all();
}

void CameraController::set_lock(bool is_locked) {
  const std::lock_guard lock(state_->mutex);
  if (state_->is_lock_wanted == is_locked) return;
  state_->is_lock_wanted = is_locked;
  state_->is_lock_changed = state_->is_lock_asked = true;
  state_->news.notify_all();
}

CameraControllerStatus CameraController::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

}  // namespace alltact
