#include "widgets/live/live_session.h"

#include "core/base/letters.h"
#include "core/open/open_source.h"
#include "core/sources/file_source.h"

#include <QMetaObject>
#include <cmath>

namespace alltact {
namespace {

constexpr int kStatusInterval_ms = 200;
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::size_t kMaxAges = 1000;
constexpr double kNewShare = 0.2;  // weight of a frame in the smoothed times

void smooth(StepTimes& shown, const StepTimes& next) {
  for (const auto step : {&StepTimes::prepare, &StepTimes::edges, &StepTimes::global,
                          &StepTimes::markers, &StepTimes::reference, &StepTimes::local,
                          &StepTimes::contact, &StepTimes::force, &StepTimes::total})
    shown.*step += kNewShare * (next.*step - shown.*step);
}

bool is_scene(const std::vector<std::filesystem::path>& inputs) {
  return inputs.size() == 1 && (lowered_extension(inputs.front()) == ".yaml" ||
                                lowered_extension(inputs.front()) == ".yml");
}

}  // namespace

LiveSession::LiveSession(SourceOpener opener, QObject* parent)
    : QObject(parent), opener_(std::move(opener)) {
  // On the measuring thread. At most one event is queued.
  const auto notify = [this] {
    if (is_view_pending_.exchange(true)) return;
    QMetaObject::invokeMethod(
        this, [this] { take_view(); }, Qt::QueuedConnection);
  };
  live_finger_ = std::make_unique<LiveFinger>(hub_, notify);
  runner_ = std::make_unique<SourceRunner>(hub_, opener_);
  connect(&timer_, &QTimer::timeout, this, &LiveSession::refresh);
  timer_.start(kStatusInterval_ms);
}

LiveSession::~LiveSession() {
  runner_.reset();
  live_finger_.reset();
}

void LiveSession::open_source(const std::vector<std::filesystem::path>& inputs,
                              const std::vector<ControlValue>& controls) {
  inputs_ = inputs;
  requested_controls_ = controls;
  if (status_.recording.state != RecordingState::kNone) last_recording_ = status_.recording;
  runner_->open(inputs);
  view_.reset();
  touch_history_.forget();
  refresh();
  if (folder_.empty()) follow_scene();
}

void LiveSession::close_source() {
  inputs_.clear();
  runner_->close();
  view_.reset();
  touch_history_.forget();
  refresh();
  if (folder_.empty()) follow_scene();
}

void LiveSession::open_finger(const std::filesystem::path& folder) {
  folder_ = folder;
  if (folder.empty()) {
    follow_scene();
  } else {
    live_finger_->open(folder);
  }
  refresh();
}

void LiveSession::follow_scene() {
  if (is_scene(inputs_))
    live_finger_->open_scene(inputs_.front());
  else
    live_finger_->open({});
}

void LiveSession::start_recording(const std::filesystem::path& file,
                                  const RecorderSettings& settings,
                                  std::shared_ptr<RecordingFeed> feed) {
  runner_->start_recording(file, settings, std::move(feed));
  refresh();
}

void LiveSession::set_control(const ControlValue& control) {
  std::erase_if(requested_controls_, [&](const ControlValue& old) { return old.id == control.id; });
  requested_controls_.push_back(control);
  controller_.set(control);
}

void LiveSession::take_view() {
  is_view_pending_ = false;
  auto view = live_finger_->take();
  if (!view || inputs_.empty()) return;  // measured after the source was closed
  // A finger's first view may precede the status that reports the finger.
  if (live_finger_->status().state != status_.finger.state) refresh();
  view_ = std::move(view);
  smooth(times_ms_, view_->result.times_ms);
  follow_touch();
  const std::int64_t now_ns = monotonic_ns();
  taken_ns_.push_back(now_ns);
  while (taken_ns_.front() < now_ns - kSecond_ns) taken_ns_.pop_front();
  status_.age_ms.reset();
  if (const FramePtr& frame = view_->result.frame) status_.age_ms = runner_->age_ms(*frame, now_ns);
  view_ns_.reset();
  if (status_.age_ms) {
    view_ns_ = now_ns - std::llround(1e6 * *status_.age_ms);
    ages_ms_.push_back(*status_.age_ms);
    if (ages_ms_.size() > kMaxAges) ages_ms_.pop_front();
  }
  Q_EMIT view_ready();
}

void LiveSession::refresh() {
  status_.source = runner_->status();
  status_.recording = runner_->recording();
  if (status_.recording.state == RecordingState::kNone) status_.recording = last_recording_;
  const std::uint64_t before = status_.finger.opened;
  status_.finger = live_finger_->status();
  // The history is of another finger, or of its former version.
  if (status_.finger.opened != before) touch_history_.forget();
  controller_.attach(runner_->camera(), requested_controls_);
  status_.controller = controller_.status();
  follow_remarks();
  const std::int64_t now_ns = monotonic_ns();
  while (!taken_ns_.empty() && taken_ns_.front() < now_ns - kSecond_ns) taken_ns_.pop_front();
  status_.shown_per_s = 0;
  if (taken_ns_.size() > 1)
    status_.shown_per_s = static_cast<double>(taken_ns_.size() - 1) * 1e9 /
                          static_cast<double>(taken_ns_.back() - taken_ns_.front());
  Q_EMIT status_ready();
}

void LiveSession::follow_touch() {
  // While a finger loads, and for a view or two after, the former finger measures.
  if (view_->opened != status_.finger.opened) return;
  const FramePtr& frame = view_->result.frame;
  const auto taken_s = frame ? time_s(*frame) : std::nullopt;
  touch_history_.add(view_->result, taken_s.value_or(1e-9 * static_cast<double>(monotonic_ns())));
}

void LiveSession::set_force_zero(const std::optional<SessionZero>& zero) {
  force_zero_ = zero;
  Q_EMIT status_ready();
}

std::optional<SessionZero> LiveSession::force_zero() const {
  const auto& finger = status_.finger.finger;
  if (!force_zero_ || !finger || force_zero_->finger != status_.finger.folder ||
      force_zero_->model != finger->force_model)
    return std::nullopt;
  return force_zero_;
}

void LiveSession::follow_remarks() {
  constexpr std::int64_t kShown_ns = 10 * kSecond_ns;
  const auto remarks =
      status_.source.camera ? status_.source.camera->remarks : status_.source.remarks;
  if (remarks != remarks_ && !remarks.empty()) remarked_ns_ = monotonic_ns();
  remarks_ = remarks;
  const bool is_shown = !remarks_.empty() && monotonic_ns() < remarked_ns_ + kShown_ns;
  status_.remark = is_shown ? remarks_.back() : Message();
}

}  // namespace alltact
