#include "calibration/live/live_finger.h"

#include "calibration/finger/measuring_settings.h"
#include "calibration/live/layers.h"
#include "core/finger/force_model.h"
#include "core/simulation/plan.h"

#include <chrono>

namespace alltact {
namespace {

Result<FingerPtr> finger_of_scene(const std::filesystem::path& file) {
  const auto scene = Scene::load(file);
  if (!scene) return scene.error();
  const auto plan = Plan::compile(*scene, 1);
  if (!plan) return plan.error();
  auto finger = FingerSnapshot::of({}, plan->finger());
  if (!finger) return finger.error();
  return std::make_shared<const FingerSnapshot>(std::move(*finger));
}

Result<Pipeline> pipeline_of(const FingerSnapshot& finger, const Job& job) {
  const PipelineSettings settings = measuring_settings(finger.folder);
  if (finger.folder.empty() || !finger.finger.reference)
    return Pipeline::without_reference(finger, settings);
  return Pipeline::create(finger, settings, job);
}

std::optional<Error> force_problem_of(const FingerSnapshot& finger) {
  if (!finger.force) return finger.force_problem;
  const Status belongs = finger.force->belongs_to(finger.finger);
  return belongs ? std::nullopt : std::optional(belongs.error());
}

/// A frame that could not be measured is shown raw.
void measure_into(LiveView& view, Pipeline& pipeline, const FramePtr& frame) {
  auto result = pipeline(frame);
  if (result) {
    view.result = std::move(*result);
    return;
  }
  view.problem = result.error();
  view.result.frame = frame;
  view.result.grey = frame->grey;
}

}  // namespace

struct LiveFinger::Loading {
  Job job;
};

/// A finger's pipeline and the number of its opened finger.
struct LiveFinger::Measuring {
  Pipeline pipeline = Pipeline::without_finger();
  std::uint64_t opened = 0;
};

struct LiveFinger::State {
  mutable std::mutex mutex;
  FingerStatus status;
  std::shared_ptr<Loading> loading;  // the current one
  std::optional<Measuring> next;     // loaded, for the measuring thread to take
  std::shared_ptr<const LiveView> view;
  RequestedLayers layers;
  double depth_top_mm = 1.0;
};

LiveFinger::LiveFinger(const FrameHub& hub, std::function<void()> on_update)
    : state_(std::make_shared<State>()),
      reader_(hub.reader()),
      on_update_(std::move(on_update)),
      thread_([this](const std::stop_token& stop) { measure(stop); }) {}

LiveFinger::~LiveFinger() {
  const std::lock_guard lock(state_->mutex);
  if (state_->loading) state_->loading->job.request_stop();
}

void LiveFinger::open(const std::filesystem::path& folder) {
  load(folder, {});
}

void LiveFinger::open_scene(const std::filesystem::path& scene) {
  load({}, scene);
}

void LiveFinger::load(const std::filesystem::path& folder, const std::filesystem::path& scene) {
  const auto state = state_;
  auto loading = std::make_shared<Loading>();
  std::optional<Measuring> unused;
  std::uint64_t opened = 0;
  {
    const std::lock_guard lock(state->mutex);
    if (state->loading) state->loading->job.request_stop();
    state->loading = loading;
    opened = state->status.opened + 1;
    state->status = {};
    state->status.opened = opened;
    state->status.folder = folder;
    if (folder.empty() && scene.empty()) {
      unused = std::exchange(state->next, Measuring{.opened = opened});
      return;
    }
    state->status.state = FingerState::kLoading;
  }
  std::thread([state, loading, opened, folder, scene] {
    FingerStatus status;
    status.opened = opened;
    status.folder = folder;
    const auto finger = folder.empty() ? finger_of_scene(scene) : open_finger(folder);
    Measuring ready{.opened = opened};
    if (finger) {
      status.finger = (*finger)->finger;
      status.warnings = (*finger)->warnings;
      status.force_problem = force_problem_of(**finger);
      auto pipeline = pipeline_of(**finger, loading->job);
      if (pipeline) ready.pipeline = std::move(*pipeline);
      if (!pipeline) status.problem = pipeline.error();
      status.has_reference = ready.pipeline.has_reference();
    } else {
      status.problem = finger.error();
    }
    status.state = status.problem ? FingerState::kFailed : FingerState::kReady;
    std::optional<Measuring> unused;
    const std::lock_guard lock(state->mutex);
    if (state->loading != loading) return;
    status.skipped = state->status.skipped;
    state->status = std::move(status);
    unused = std::exchange(state->next, std::move(ready));
  }).detach();
}

void LiveFinger::measure(const std::stop_token& stop) {
  Measuring now;
  FramePtr last;
  while (!stop.stop_requested()) {
    FramePtr frame = reader_.next(std::chrono::milliseconds(50));
    // The last frame of a source that has ended is shown; a finger opened later measures it, too.
    if (!frame && has_update_for_last()) frame = last;
    if (!frame) continue;
    RequestedLayers layers;
    auto view = std::make_shared<LiveView>();
    std::optional<Measuring> before;  // freed outside the lock: it may hold a full recording
    {
      const std::lock_guard lock(state_->mutex);
      if (state_->next) {
        before = std::exchange(now, std::move(*state_->next));
        state_->next.reset();
      }
      layers = state_->layers;
      view->depth_top_mm = state_->depth_top_mm;
    }
    const bool is_next = last && last->origin == frame->origin && frame->sequence > last->sequence;
    last = frame;
    if (!is_next) now.pipeline.forget();
    measure_into(*view, now.pipeline, frame);
    view->opened = now.opened;
    const FrameResult& result = view->result;
    if (layers.depth && result.depth)
      view->depth_layer = depth_layer(*result.depth, view->depth_top_mm);
    if (layers.faults) view->faults_layer = faults_layer(result.grey, result);
    bool is_new = false;
    std::shared_ptr<const LiveView> missed;
    {
      const std::lock_guard lock(state_->mutex);
      missed = std::exchange(state_->view, std::move(view));
      is_new = missed == nullptr;
      state_->status.skipped = reader_.missed();
    }
    if (is_new) on_update_();
  }
}

bool LiveFinger::has_update_for_last() const {
  const std::lock_guard lock(state_->mutex);
  return state_->next.has_value();
}

void LiveFinger::set_layers(RequestedLayers layers) {
  const std::lock_guard lock(state_->mutex);
  state_->layers = layers;
}

void LiveFinger::set_depth_top_mm(double top_mm) {
  const std::lock_guard lock(state_->mutex);
  state_->depth_top_mm = top_mm;
}

std::shared_ptr<const LiveView> LiveFinger::take() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->view, nullptr);
}

FingerStatus LiveFinger::status() const {
  const std::lock_guard lock(state_->mutex);
  return state_->status;
}

}  // namespace alltact
