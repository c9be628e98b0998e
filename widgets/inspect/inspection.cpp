#include "widgets/inspect/inspection.h"

#include "core/base/worker.h"
#include "core/sensing/surface_measurement.h"

#include <QMetaObject>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace alltact {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kScanDelay = std::chrono::milliseconds(700);

}  // namespace

/// State shared by the worker and the window's thread.
struct Inspection::Shared {
  std::mutex mutex;
  std::condition_variable_any wakeup;
  InspectRequest request;
  bool is_requested = false, is_working = false, is_scanning = false, is_at_end = false;
  Clock::time_point last_request_at;
  Job job;  // stopped at the end

  Mailbox<InspectAnswer> answer;
  Mailbox<Inspector::SummaryUpdate> summaries;
  Worker worker;

  /// Changes the request and wakes the worker.
  void change_request(const std::function<void(InspectRequest&)>& change, bool is_enough) {
    const std::lock_guard lock(mutex);
    change(request);
    is_requested =
        (is_requested || is_enough) && (request.live != nullptr || !request.input.empty());
    is_at_end = false;
    wakeup.notify_one();
  }
  /// With the lock held.
  [[nodiscard]] bool may_scan() const {
    return is_scanning && !is_at_end && !request.live && !request.input.empty();
  }
  /// Waits for work. Requests in quick succession, as during playback, are not interrupted by
  /// scanning: that would clear what is tracked over frames.
  void wait(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const auto is_enough = [&] { return is_requested; };
    if (may_scan() && wakeup.wait_until(lock, stop, last_request_at + kScanDelay, is_enough))
      return;
    if (!may_scan()) wakeup.wait(lock, stop, [&] { return is_enough() || may_scan(); });
  }
  /// With the lock held.
  [[nodiscard]] bool is_due() const {
    return may_scan() && Clock::now() >= last_request_at + kScanDelay;
  }
  /// Returns true where the window must be notified.
  bool add(Inspector::SummaryUpdate more) {
    if (more.summaries.empty() && !more.is_from_scratch) return false;
    return summaries.change([&](std::optional<Inspector::SummaryUpdate>& before) {
      if (!before || more.is_from_scratch) {
        more.is_from_scratch = more.is_from_scratch || (before && before->is_from_scratch);
        before = std::move(more);
      } else {
        before->summaries.insert(before->summaries.end(), more.summaries.begin(),
                                 more.summaries.end());
      }
    });
  }
};

Inspection::Inspection(QObject* parent) : QObject(parent), shared_(std::make_shared<Shared>()) {
  Shared* shared = shared_.get();
  shared->worker = Worker([this, shared](const std::stop_token& stop) {
    Inspector inspector;
    const std::stop_callback end_work(stop, [shared] { shared->job.request_stop(); });
    std::unique_lock lock(shared->mutex);
    while (!stop.stop_requested()) {
      shared->wait(lock, stop);
      if (stop.stop_requested()) return;
      const InspectRequest request = shared->request;
      const bool is_requested = std::exchange(shared->is_requested, false);
      if (!is_requested && !shared->is_due()) continue;
      shared->is_working = is_requested;
      lock.unlock();
      std::optional<InspectAnswer> answer;
      bool goes_on = is_requested;
      Inspector::SummaryUpdate update;
      const Status inspected = guarded([&] {
        if (!is_requested) goes_on = inspector.scan_next(shared->job);
        if (is_requested) answer = inspector(request, shared->job);
        update = inspector.update();
      });
      if (!inspected && is_requested) answer = InspectAnswer{{}, {}, inspected.error()};
      if (shared->add(std::move(update)))
        QMetaObject::invokeMethod(this, &Inspection::take_summaries, Qt::QueuedConnection);
      lock.lock();
      shared->is_working = false;
      if (is_requested) shared->last_request_at = Clock::now();
      shared->is_at_end = !goes_on;  // a request may have opened another recording
      if (answer && !shared->answer.put(std::move(*answer)))
        QMetaObject::invokeMethod(this, &Inspection::take, Qt::QueuedConnection);
    }
  });
}

Inspection::~Inspection() {
  shared_->worker.request_stop();
  shared_->worker.join();
}

void Inspection::set_finger(const std::filesystem::path& folder) {
  if (shared_->request.finger == folder) return;
  shared_->change_request([&](InspectRequest& request) { request.finger = folder; },
                          !shared_->request.input.empty());
}

void Inspection::set_other(const ComparisonSpec& other) {
  if (shared_->request.other == other) return;
  shared_->change_request([&](InspectRequest& request) { request.other = other; }, true);
}

void Inspection::set_scanning(bool is_on) {
  const std::lock_guard lock(shared_->mutex);
  shared_->is_scanning = is_on;
  shared_->wakeup.notify_one();
}

void Inspection::open(const std::filesystem::path& input, std::size_t number) {
  recording_.reset();
  frame_.reset();
  problem_.reset();
  summaries_.clear();
  shared_->change_request(
      [&](InspectRequest& request) {
        request.input = input;
        ++request.opened;
        request.number = number;
        request.live.reset();
      },
      true);
  Q_EMIT state_changed();
  Q_EMIT summaries_changed();
}

void Inspection::show_frame(std::size_t number) {
  shared_->change_request([&](InspectRequest& request) { request.number = number; }, true);
}

void Inspection::measure_again() {
  if (!shared_->request.input.empty()) shared_->change_request([](InspectRequest&) {}, true);
}

void Inspection::show_live(std::shared_ptr<const LiveView> view, const Finger& finger) {
  shared_->change_request(
      [&](InspectRequest& request) {
        request.live = std::move(view);
        request.live_finger = finger;
      },
      true);
}

bool Inspection::is_busy() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->is_requested || shared_->is_working;
}

void Inspection::take_summaries() {
  const auto update = shared_->summaries.take();
  if (!update) return;
  if (update->is_from_scratch) summaries_.clear();
  summaries_.insert(summaries_.end(), update->summaries.begin(), update->summaries.end());
  Q_EMIT summaries_changed();
}

void Inspection::take() {
  const auto answer = shared_->answer.take();
  if (!answer) return;
  {
    const std::lock_guard lock(shared_->mutex);
    // The answer may be of a closed recording, or of the live finger.
    if (answer->recording && answer->recording->input != shared_->request.input) return;
    if (!answer->recording && !answer->problem && !shared_->request.live) return;
  }
  recording_ = answer->recording;
  problem_ = answer->problem;
  if (answer->frame || problem_) {  // the former frame is of another request or finger
    frame_ = answer->frame;
    Q_EMIT frame_ready();
  }
  Q_EMIT state_changed();
}

namespace {

constexpr int kVertices = 25000;  // 30 faces per second with software rendering

}  // namespace

InspectAnswer Inspector::operator()(const InspectRequest& request, const Job& job) {
  if (std::exchange(grid_of_, request.finger) != request.finger) grid_ = {};
  InspectAnswer answer;
  auto frame = measured(request, job, answer.recording);
  if (!frame) {
    answer.problem = frame.error();
    return answer;
  }
  answer.problem = frame->other_problem;
  answer.frame = with_surfaces(std::move(*frame));
  return answer;
}

Result<MeasuredFrame> Inspector::measured(const InspectRequest& request, const Job& job,
                                          std::optional<RecordingInfo>& recording) {
  if (request.live)
    return measurer_.complete(request.live->result, *request.live_finger, request.finger,
                              request.other, job);
  if (const Status status = measurer_.open_recording(request.input, job); !status)
    return status.error();
  recording = measurer_.recording();
  if (const Status status = measurer_.load_finger(request.finger, job); !status)
    return status.error();
  auto frame = measurer_.measure(request.number, request.other, job);
  if (frame) {
    note(*frame);
    resend(request.opened);
  }
  return frame;
}

void Inspector::note(const MeasuredFrame& frame) {
  const RecordingInfo recording = measurer_.recording();
  if (summaries_of_ != recording.input || summaries_by_ != measurer_.finger()) {
    summaries_of_ = recording.input;
    summaries_by_ = measurer_.finger();
    summaries_.assign(recording.count, std::nullopt);
    next_ = 0;
    update_ = {true, {}};
  }
  if (frame.number < summaries_.size() && !summaries_[frame.number]) add(summary_of(frame));
}

void Inspector::add(const FrameSummary& summary) {
  summaries_[summary.number] = summary;
  update_.summaries.push_back(summary);
  while (next_ < summaries_.size() && summaries_[next_]) ++next_;
}

/// The window forgets the summaries when it opens a recording, also one that is known here.
void Inspector::resend(std::uint64_t opened) {
  if (std::exchange(opened_, opened) == opened) return;
  update_ = {true, {}};
  for (const auto& summary : summaries_)
    if (summary) update_.summaries.push_back(*summary);
}

bool Inspector::scan_next(const Job& job) {
  if (next_ >= summaries_.size() || !measurer_.is_open() || summaries_by_ != measurer_.finger() ||
      summaries_of_ != measurer_.recording().input)
    return false;
  const auto frame = measurer_.measure(next_, {}, job);
  if (frame)
    note(*frame);
  else  // it cannot be read
    add({next_, {}, {}, {}, false, frame.error().what});
  return true;
}

Inspector::SummaryUpdate Inspector::update() { return std::exchange(update_, {}); }

std::shared_ptr<const InspectedFrame> Inspector::with_surfaces(MeasuredFrame measured) {
  auto shown = std::make_shared<InspectedFrame>();
  InspectedFrame& frame = *shown;
  static_cast<MeasuredFrame&>(frame) = std::move(measured);
  const FrameResult& result = frame.result;
  if (!result.shape || (!result.depth && frame.is_calibrated)) return shown;
  if (grid_.area() == 0) grid_ = grid_for(result, kVertices);
  if (!result.depth) {
    frame.bare = uncalibrated_surface(result, frame.face, grid_.width, grid_.height);
    return shown;
  }
  frame.surface = face_surface(result, frame.face, grid_.width, grid_.height);
  if (!frame.other || !frame.other->depth || !frame.other->shape || !frame.surface) return shown;
  frame.other_surface = face_surface(*frame.other, frame.other_face, grid_.width, grid_.height);
  frame.other_depth_mm.create(frame.surface->depth_mm.size(), CV_32FC1);
  for (int j = 0; j < grid_.height; ++j) {
    for (int i = 0; i < grid_.width; ++i) {
      const auto& pixel = frame.surface->pixel.at<cv::Vec2f>(j, i);
      frame.other_depth_mm.at<float>(j, i) =
          frame.surface->depth_mm.at<float>(j, i) -
          bilinear_value(frame.difference_mm, pixel[0], pixel[1]);
    }
  }
  return shown;
}

}  // namespace alltact
