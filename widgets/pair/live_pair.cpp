#include "widgets/pair/live_pair.h"

namespace alltact {

LivePair::LivePair(LiveSession& first, QObject* parent) : QObject(parent), first_(first) {
  connect(&first_, &LiveSession::view_ready, this, [this] { add(0); });
  connect(&loading_, &BackgroundWork::finished, this, [this] {
    measure();
    Q_EMIT changed();
  });
  connect(&measuring_, &BackgroundWork::finished, this, [this] {
    measure();
    Q_EMIT changed();
  });
}

void LivePair::open(const std::optional<SecondCamera>& second) {
  if (opened_ == second) return;
  const std::optional<SecondCamera> before = std::exchange(opened_, second);
  reading_.reset();
  reading_problem_.reset();
  request_.reset();
  const bool is_other =
      !before || !second || before->finger != second->finger || before->source != second->source;
  if (is_other) {
    pairing_.forget();
    pair_.reset();
  }
  if (!second_ && second) {
    second_ = std::make_unique<LiveSession>(first_.opener());
    connect(second_.get(), &LiveSession::view_ready, this, [this] { add(1); });
    connect(second_.get(), &LiveSession::status_ready, this, &LivePair::changed);
  }
  if (is_other && second_) {
    second_->set_lock(true);  // brightness is the measured quantity
    second_->open_finger(second ? second->finger : std::filesystem::path());
    if (second)
      second_->open_source(second->source);
    else
      second_->close_source();
  }
  load_gripper();
  measure();
  Q_EMIT changed();
}

void LivePair::add(std::size_t which) {
  if (!opened_ || !second_) return;
  const LiveSession& session = which == 0 ? first_ : *second_;
  auto shown = pairing_.add(which, session.view(), session.view_ns());
  if (!shown) return;
  pair_ = std::move(*shown);
  Q_EMIT pair_ready();
  measure();
}

void LivePair::load_gripper() {
  const std::filesystem::path requested = opened_ ? opened_->gripper : std::filesystem::path();
  if (requested == gripper_of_) return;
  gripper_.reset();
  gripper_problem_.reset();
  gripper_of_ = requested;
  if (requested.empty()) return loading_.stop();
  loading_.restart([this, requested](const Job&) {
    auto loaded = OpenGripper::load(requested);
    return std::function<void()>([this, requested, loaded = std::move(loaded)] {
      if (requested != gripper_of_) return;
      if (loaded)
        gripper_ = std::make_shared<const OpenGripper>(*loaded);
      else
        gripper_problem_ = loaded.error();
    });
  });
}

std::optional<double> LivePair::motor_turns() const {
  if (!gripper_ || !opened_) return std::nullopt;
  const GripperMotor& motor = gripper_->gripper.motor;
  return opened_->motor_turns.value_or(0.5 * (motor.first_turns + motor.last_turns));
}

void LivePair::measure() {
  const auto turns = motor_turns();
  if (!turns || !pair_ || !pair_->is_in_time || measuring_.is_running()) return;
  const Request request{pair_->views, *turns};
  if (request_ == request) return;
  const auto &own = first_.status().finger, &other = second_->status().finger;
  if (!own.finger || !other.finger) return;
  const std::array<PairedFinger, 2> fingers{
      {{own.folder, own.finger->face}, {other.folder, other.finger->face}}};
  request_ = request;
  measuring_.start([this, gripper = gripper_, turns = *turns, pair = *pair_, fingers](const Job&) {
    auto reading = read_pair(*gripper, turns, pair, fingers);
    return std::function<void()>([this, reading = std::move(reading)] { take(reading); });
  });
}

/// A reading requested before another finger was opened is dropped.
void LivePair::take(const Result<PairReading>& reading) {
  reading_problem_.reset();
  if (!reading) {
    reading_.reset();
    reading_problem_ = reading.error();
  } else if (motor_turns() == reading->motor_turns && pair_) {
    reading_ = *reading;
  }
}

std::optional<Error> LivePair::problem() const {
  if (!opened_ || !second_) return std::nullopt;
  const LiveStatus& status = second_->status();
  if (status.source.problem) return status.source.problem;
  if (status.finger.problem) return status.finger.problem;
  if (gripper_problem_) return gripper_problem_;
  return reading_problem_;
}

}  // namespace alltact
