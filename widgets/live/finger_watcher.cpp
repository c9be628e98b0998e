#include "widgets/live/finger_watcher.h"

#include "calibration/finger/measuring_settings.h"
#include "core/simulation/plan.h"

#include <chrono>

namespace alltact {
namespace {

Result<Finger> finger_of_scene(const std::filesystem::path& file) {
  const auto scene = Scene::load(file);
  if (!scene) return scene.error();
  const auto plan = Plan::compile(*scene, 1);
  if (!plan) return plan.error();
  return plan->finger();
}

}  // namespace

struct FingerWatcher::Loading {
  Job job;
};

struct FingerWatcher::State {
  mutable std::mutex mutex;
  FingerStatus status;
  std::shared_ptr<Loading> loading;   // the one that counts
  std::unique_ptr<FingerWatch> next;  // loaded, for the watching thread to take
  std::shared_ptr<const LiveView> view;
  WantedLayers layers;
  double depth_top_mm = 1.0;
};

FingerWatcher::FingerWatcher(const FrameHub& hub, std::function<void()> news)
    : state_(std::make_shared<State>()),
      reader_(hub.reader()),
      news_(std::move(news)),
      thread_([this](const std::stop_token& stop) { watch(stop); }) {}

FingerWatcher::~FingerWatcher() {
  const std::lock_guard lock(state_->mutex);
  if (state_->loading) state_->loading->job.request_stop();
}

void FingerWatcher::open(const std::filesystem::path& folder) {
  load(folder, {});
}

void FingerWatcher::open_scene(const std::filesystem::path& scene) {
  load({}, scene);
}

void FingerWatcher::load(const std::filesystem::path& folder, const std::filesystem::path& scene) {
  const auto state = state_;
  auto loading = std::make_shared<Loading>();
  std::unique_ptr<FingerWatch> unused;
  {
    const std::lock_guard lock(state->mutex);
    if (state->loading) state->loading->job.request_stop();
    state->loading = loading;
    state->status = {};
    state->status.folder = folder;
    if (folder.empty() && scene.empty()) {
      unused = std::exchange(state->next, std::make_unique<FingerWatch>());
      return;
    }
    state->status.state = FingerState::kLoading;
  }
  std::thread([state, loading, folder, scene] {
    FingerStatus status;
    status.folder = folder;
    const auto finger =
        folder.empty() ? finger_of_scene(scene) : Finger::load(folder, &status.warnings);
    std::unique_ptr<FingerWatch> ready = std::make_unique<FingerWatch>();
    if (finger) {
      status.finger = *finger;
      auto watch = FingerWatch::create(folder, *finger, measuring_settings(folder), loading->job);
      if (watch) ready = std::make_unique<FingerWatch>(std::move(*watch));
      if (!watch) status.problem = watch.error();
      status.has_reference = ready->has_reference();
    } else {
      status.problem = finger.error();
    }
    status.state = status.problem ? FingerState::kFailed : FingerState::kReady;
    std::unique_ptr<FingerWatch> unused;
    const std::lock_guard lock(state->mutex);
    if (state->loading != loading) return;
    status.skipped = state->status.skipped;
    state->status = std::move(status);
    unused = std::exchange(state->next, std::move(ready));
  }).detach();
}

void FingerWatcher::watch(const std::stop_token& stop) {
  auto finger = std::make_unique<FingerWatch>();
  FramePtr last;
  while (!stop.stop_requested()) {
    const FramePtr frame = reader_.next(std::chrono::milliseconds(50));
    if (!frame) continue;
    WantedLayers layers;
    auto view = std::make_shared<LiveView>();
    std::unique_ptr<FingerWatch> before;  // freed outside the lock: it may hold a whole recording
    {
      const std::lock_guard lock(state_->mutex);
      if (state_->next) before = std::exchange(finger, std::move(state_->next));
      layers = state_->layers;
      view->depth_top_mm = state_->depth_top_mm;
    }
    const bool is_next = last && last->origin == frame->origin && frame->sequence > last->sequence;
    last = frame;
    view->watched = (*finger)(frame, is_next);
    const FrameResult& result = view->watched.result;
    if (layers.depth && result.depth)
      view->depth_layer = depth_layer(*result.depth, view->depth_top_mm);
    if (layers.faults) view->faults_layer = faults_layer(result.grey, result);
    bool is_news = false;
    std::shared_ptr<const LiveView> missed;
    {
      const std::lock_guard lock(state_->mutex);
      missed = std::exchange(state_->view, std::move(view));
      is_news = missed == nullptr;
      state_->status.skipped = reader_.missed();
    }
    if (is_news) news_();
  }
}

void FingerWatcher::set_layers(WantedLayers layers) {
  const std::lock_guard lock(state_->mutex);
  state_->layers = layers;
}

void FingerWatcher::set_depth_top_mm(double top_mm) {
  const std::lock_guard lock(state_->mutex);
  state_->depth_top_mm = top_mm;
}

std::shared_ptr<const LiveView> FingerWatcher::take() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->view, nullptr);
}

FingerStatus FingerWatcher::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

}  // namespace alltact
