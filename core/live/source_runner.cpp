#include "core/live/source_runner.h"

#include "core/devices/led_dimmer.h"
#include "core/sources/source.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <thread>

namespace alltact {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::int64_t kSecond_ns = 1'000'000'000;
// A source slower than its own times falls behind permanently, although its frames are not old. The
// smallest delay in this window therefore determines the offset of its clock.
constexpr std::int64_t kClockWindow_ns = kSecond_ns / 2;
constexpr std::chrono::milliseconds kFaultPause{20};  // a source that fails at once must not spin

}  // namespace

std::int64_t monotonic_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
      .count();
}

double monotonic_s() { return 1e-9 * static_cast<double>(monotonic_ns()); }

// One source from opening to its end. The thread shares it, so that it may outlive the runner.
struct SourceRunner::Run {
  FrameHub* hub = nullptr;  // under publish_mutex; null once the runner has gone
  std::mutex publish_mutex;
  SourceOpener opener;
  std::vector<std::filesystem::path> inputs;
  std::uint64_t seed = 1;
  Job job{[this](double, const Message& what) {
    const std::lock_guard lock(mutex);
    status.opening = what;
  }};

  mutable std::mutex mutex;
  std::condition_variable ended;
  bool is_ended = false;
  SourceStatus status;
  struct Arrival {
    std::int64_t arrived_ns;
    std::optional<std::int64_t> taken_ns;  // by the source's clock
  };
  std::deque<Arrival> arrivals;  // of the last second
  std::shared_ptr<V4l2Camera> camera;
  std::optional<std::uint64_t> last_sequence;
  std::optional<LightStamp> light;
  // A frame's time plus this is the monotonic clock; empty before the first frame with a time.
  std::optional<std::int64_t> clock_offset_ns;
  struct ClockOffset {
    std::int64_t arrived_ns, offset_ns;
  };
  std::deque<ClockOffset> offsets;  // of the last kClockWindow_ns, ascending

  // The recording. The recorder itself may be used from any thread.
  std::optional<RecorderSettings> requested_recording;  // to recording.file
  std::atomic<bool> is_stop_requested{false};
  std::shared_ptr<Recorder> recorder;
  std::shared_ptr<RecordingFeed> feed;  // of the recording; null: nobody follows it
  RecordingStatus recording;
  std::optional<double> first_recorded_s;
  double period_s = 0;
  int finishers = 0;

  static Worker start(const std::shared_ptr<Run>& run, std::shared_ptr<Run> before) {
    return Worker([run, before = std::move(before)]() mutable {
      if (before) before->wait_for_end(std::nullopt);
      before.reset();
      if (const Status ran = guarded([&] { run->work(run); }); !ran) {
        run->finish_recorder(run, "the program failed");
        run->fail(ran.error());
      }
      const std::lock_guard lock(run->mutex);
      if (run->feed) std::exchange(run->feed, nullptr)->end(false);
      run->is_ended = true;
      run->ended.notify_all();
    });
  }

  static void request_stop(const std::shared_ptr<Run>& self) {
    self->job.request_stop();
    std::shared_ptr<V4l2Camera> running;
    {
      const std::lock_guard lock(self->mutex);
      running = std::exchange(self->camera, nullptr);
      if (running) ++self->finishers;
    }
    // On another thread: it joins the capturing thread, which may be inside a slow driver.
    if (running)
      Worker([self, camera = std::move(running)]() mutable {
        static_cast<void>(guarded([&] {
          camera->stop();
          camera.reset();
        }));
        const std::lock_guard lock(self->mutex);
        --self->finishers;
        self->ended.notify_all();
      }).end_later();
  }

  /// False: it still runs.
  bool wait_for_end(std::optional<std::chrono::milliseconds> timeout) {
    std::unique_lock lock(mutex);
    const auto is_over = [&] { return is_ended && finishers == 0; };
    if (timeout) return ended.wait_for(lock, *timeout, is_over);
    ended.wait(lock, is_over);
    return true;
  }

  void work(const std::shared_ptr<Run>& self) {
    SourceOptions options;
    options.pace = Pace::kRecorded;
    options.seed = seed;
    options.job = &job;
    auto source =
        job.stop_requested() ? Error{en::say("stopped"), "", ""} : opener(inputs, options);
    if (!source) return fail(source.error());
    begin(**source);
    while (!job.stop_requested()) {
      serve_recording(self, **source);
      auto frame = guarded([&] { return (*source)->next(); });
      if (!frame) {
        {
          const std::lock_guard lock(mutex);
          status.problem = frame.error();
        }
        std::this_thread::sleep_for(kFaultPause);
      } else if (*frame) {
        on_frame(std::move(*frame), (*source)->is_live());
        pace_untimed(**source);
      } else {
        break;
      }
    }
    end(self);
  }

  void fail(const Error& error) {
    const std::lock_guard lock(mutex);
    status.state = job.stop_requested() ? SourceState::kClosed : SourceState::kFailed;
    if (!job.stop_requested()) status.problem = error;
  }

  void begin(Source& source) {
    const std::lock_guard lock(mutex);
    status.state = SourceState::kRunning;
    status.is_live = source.is_live();
    status.is_continuous = source.is_continuous();
    status.remarks = source.remarks();
    if (auto* from_camera = dynamic_cast<CameraSource*>(&source)) {
      camera = from_camera->shared_camera();
      clock_offset_ns = 0;
    }
    period_s = 1 / source.frames_per_s();
  }

  void on_frame(FramePtr frame, bool is_live) {
    const std::int64_t now_ns = monotonic_ns();
    std::shared_ptr<Recorder> into;
    std::shared_ptr<RecordingFeed> follower;
    {
      const std::lock_guard lock(mutex);
      count(*frame, now_ns);
      if (light) frame = (*light)(frame);
      into = recorder;
      follower = feed;
    }
    if (into && record(*into, frame, is_live) && follower) follower->add(frame);
    const std::lock_guard lock(publish_mutex);
    if (hub != nullptr) hub->publish(std::move(frame));
  }

  void count(const Frame& frame, std::int64_t now_ns) {
    status.problem.reset();
    ++status.delivered;
    if (last_sequence && frame.sequence > *last_sequence + 1)
      status.missing += frame.sequence - *last_sequence - 1;
    last_sequence = frame.sequence;
    arrivals.push_back({now_ns, frame.time_ns});
    while (arrivals.front().arrived_ns < now_ns - kSecond_ns) arrivals.pop_front();
    if (!frame.time_ns || camera) return;
    const std::int64_t offset = now_ns - *frame.time_ns;
    while (!offsets.empty() && offsets.back().offset_ns >= offset) offsets.pop_back();
    offsets.push_back({now_ns, offset});
    while (offsets.front().arrived_ns < now_ns - kClockWindow_ns) offsets.pop_front();
    clock_offset_ns = offsets.front().offset_ns;
  }

  void measure_rate(SourceStatus& into) const {
    constexpr double kCatchingUp = 1.2;  // unsteady delivery stays below
    if (arrivals.size() < 2 || arrivals.back().arrived_ns <= monotonic_ns() - kSecond_ns) return;
    const auto &first = arrivals.front(), &last = arrivals.back();
    const auto rate = [&](std::int64_t span_ns) {
      return static_cast<double>(arrivals.size() - 1) * 1e9 / static_cast<double>(span_ns);
    };
    into.frames_per_s = rate(last.arrived_ns - first.arrived_ns);
    if (!first.taken_ns || !last.taken_ns || *last.taken_ns <= *first.taken_ns) return;
    const double taken_per_s = rate(*last.taken_ns - *first.taken_ns);
    into.is_catching_up = into.frames_per_s > kCatchingUp * taken_per_s;
    into.frames_per_s = std::min(into.frames_per_s, taken_per_s);
  }

  /// False: the frame is lost.
  bool record(Recorder& into, const FramePtr& frame, bool is_live) {
    const bool is_taken = is_live ? into.add(frame) : into.add_waiting(frame);
    const std::lock_guard lock(mutex);
    if (!is_taken && into.problem()) is_stop_requested = true;
    if (!is_taken) return false;
    const double taken_s = time_s(*frame).value_or(0.0);
    if (!first_recorded_s) first_recorded_s = taken_s;
    recording.seconds = taken_s - *first_recorded_s + period_s;
    return true;
  }

  /// Images have no times: they come at a camera's rate.
  void pace_untimed(Source& source) const {
    if (source.is_live() || source.is_continuous()) {
      const std::lock_guard lock(mutex);
      if (clock_offset_ns) return;
    }
    wait_frame_period(source.frames_per_s(), [&] { return job.stop_requested(); });
  }

  void serve_recording(const std::shared_ptr<Run>& self, const Source& source) {
    std::optional<RecorderSettings> requested;
    std::filesystem::path file;
    {
      const std::lock_guard lock(mutex);
      requested = std::exchange(requested_recording, std::nullopt);
      file = recording.file;
    }
    if (requested) start_recorder(file, *requested, source);
    if (is_stop_requested) finish_recorder(self, "stopped by hand");
  }

  void start_recorder(const std::filesystem::path& file, const RecorderSettings& settings,
                      const Source& source) {
    auto started = Recorder::start(file, settings, source.frames_per_s(), inputs.front().string());
    const std::lock_guard lock(mutex);
    if (!started) {
      recording.state = RecordingState::kDone;
      recording.problem = started.error();
      if (feed) std::exchange(feed, nullptr)->end(false);
      return;
    }
    if (feed) feed->begin(source.frames_per_s(), settings.codec);
    first_recorded_s.reset();
    recorder = std::move(*started);
  }

  /// On another thread, because writing the queue may take a while.
  void finish_recorder(const std::shared_ptr<Run>& self, const char* why) {
    std::shared_ptr<Recorder> done;
    std::shared_ptr<RecordingFeed> follower;
    {
      const std::lock_guard lock(mutex);
      is_stop_requested = false;
      follower = std::exchange(feed, nullptr);
      if (!recorder) {
        if (follower) follower->end(false);
        return;
      }
      done = std::exchange(recorder, nullptr);
      recording.state = RecordingState::kFinishing;
      ++finishers;
    }
    Worker([self, done, follower, why] {
      const Status finished = guarded([&] { return done->finish(why); });
      const RecorderCounts counts = done->counts();
      if (follower) follower->end(finished && counts.recorded == follower->extent().frames);
      const std::lock_guard lock(self->mutex);
      self->recording.state = RecordingState::kDone;
      self->recording.counts = counts;
      if (!finished) self->recording.problem = finished.error();
      --self->finishers;
      self->ended.notify_all();
    }).end_later();
  }

  void end(const std::shared_ptr<Run>& self) {
    finish_recorder(self, job.stop_requested() ? "stopped by hand" : "the source ended");
    const std::lock_guard lock(mutex);
    camera.reset();
    status.camera.reset();
    status.state = job.stop_requested() ? SourceState::kClosed : SourceState::kEnded;
  }
};

SourceRunner::SourceRunner(FrameHub& hub, SourceOpener opener)
    : hub_(hub), opener_(std::move(opener)) {}

SourceRunner::~SourceRunner() {
  const auto run = run_;
  close();
  if (run) run->wait_for_end(kStopTimeout);
  worker_.end_later();
}

void SourceRunner::open(std::vector<std::filesystem::path> inputs, std::uint64_t seed) {
  auto run = std::make_shared<Run>();
  run->hub = &hub_;
  run->opener = opener_;
  run->inputs = std::move(inputs);
  run->seed = seed;
  run->status.inputs = run->inputs;
  run->status.state = SourceState::kOpening;
  std::shared_ptr<Run> before;
  {
    const std::lock_guard lock(mutex_);
    if (light_) run->light.emplace(*light_);
    before = std::exchange(run_, run);
  }
  if (before) {
    Run::request_stop(before);
    const std::lock_guard lock(before->publish_mutex);
    before->hub = nullptr;
  }
  const std::lock_guard lock(mutex_);
  worker_.end_later();
  worker_ = Run::start(run, before);
}

void SourceRunner::close() {
  const std::lock_guard lock(mutex_);
  if (!run_) return;
  Run::request_stop(run_);
  const std::lock_guard publish_lock(run_->publish_mutex);
  run_->hub = nullptr;
}

void SourceRunner::set_light(const std::optional<DimmerSetting>& light) {
  const std::lock_guard lock(mutex_);
  light_ = light;
  if (!run_) return;
  const std::lock_guard run_lock(run_->mutex);
  run_->light.reset();
  if (light) run_->light.emplace(*light);
}

void SourceRunner::start_recording(const std::filesystem::path& file,
                                   const RecorderSettings& settings,
                                   std::shared_ptr<RecordingFeed> feed) {
  const std::lock_guard lock(mutex_);
  const auto refuse = [&] {
    if (feed) feed->end(false);
  };
  if (!run_) return refuse();
  const std::lock_guard run_lock(run_->mutex);
  const RecordingState state = run_->recording.state;
  if (state == RecordingState::kRunning || state == RecordingState::kFinishing) return refuse();
  run_->recording = {};
  run_->feed = std::move(feed);
  run_->recording.state = RecordingState::kRunning;
  run_->recording.file = file;
  run_->requested_recording = settings;
  run_->is_stop_requested = false;  // a stop from now on is one of this recording
}

void SourceRunner::stop_recording() {
  const std::lock_guard lock(mutex_);
  if (run_) run_->is_stop_requested = true;
}

SourceStatus SourceRunner::status() const {
  const std::lock_guard lock(mutex_);
  if (!run_) return {};
  const std::lock_guard run_lock(run_->mutex);
  SourceStatus status = run_->status;
  run_->measure_rate(status);
  if (run_->camera) {
    status.camera = run_->camera->status();
    if (status.camera->trouble) status.problem = status.camera->trouble;
  }
  return status;
}

RecordingStatus SourceRunner::recording() const {
  const std::lock_guard lock(mutex_);
  if (!run_) return {};
  const std::lock_guard run_lock(run_->mutex);
  RecordingStatus recording = run_->recording;
  if (run_->recorder) recording.counts = run_->recorder->counts();
  return recording;
}

std::shared_ptr<V4l2Camera> SourceRunner::camera() const {
  const std::lock_guard lock(mutex_);
  if (!run_) return nullptr;
  const std::lock_guard run_lock(run_->mutex);
  return run_->camera;
}

std::optional<double> SourceRunner::age_ms(const Frame& frame, std::int64_t now_ns) const {
  const std::lock_guard lock(mutex_);
  if (!run_ || !frame.time_ns) return std::nullopt;
  const std::lock_guard run_lock(run_->mutex);
  if (!run_->clock_offset_ns) return std::nullopt;
  return std::max(0.0,
                  static_cast<double>(now_ns - *frame.time_ns - *run_->clock_offset_ns) * 1e-6);
}

}  // namespace alltact
