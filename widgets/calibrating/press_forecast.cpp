#include "widgets/calibrating/press_forecast.h"

namespace alltact {

PressForecast::PressForecast(const PressCollection& collection,
                             const CalibrationRun& run,
                             QObject* parent)
    : QObject(parent), collection_(collection), run_(run) {
  delay_.setSingleShot(true);
  delay_.setInterval(kDelay_ms);
  connect(&delay_, &QTimer::timeout, this, &PressForecast::begin);
  connect(&collection_, &PressCollection::changed, this, &PressForecast::follow);
  connect(&run_, &CalibrationRun::changed, this, &PressForecast::follow);
  connect(&work_, &BackgroundWork::finished, this, &PressForecast::follow);
}

void PressForecast::set_watched(bool is_watched) {
  is_watched_ = is_watched;
  if (!is_watched) {
    delay_.stop();
    work_.stop();
  }
  follow();
}

PressForecast::Presses PressForecast::present() const {
  Presses presses;
  presses.press_set = run_.next_inputs().press_set;
  for (const CollectedPress& press : collection_.presses())
    if (press.analysis.measured) presses.measured.push_back(press.analysis.measured);
  return presses;
}

bool PressForecast::is_needed() const {
  if (!collection_.is_ready() || collection_.analyser() == nullptr || run_.is_running() ||
      run_.state() == CalibrationState::kCurrent)
    return false;
  return std::any_of(
      collection_.presses().begin(), collection_.presses().end(), [this](const auto& press) {
        return collection_.is_usable(press) && collection_.has_ball(press);
      });
}

void PressForecast::follow() {
  if (folder_ != collection_.folder()) last_.reset();
  folder_ = collection_.folder();
  const bool is_needed_now = is_needed();
  if (!is_needed_now || present() != requested_) {
    const bool was_known = result_ || problem_;
    result_.reset();
    problem_.reset();
    requested_ = {};
    work_.stop();
    if (was_known) Q_EMIT changed();
  }
  if (!is_needed_now) return delay_.stop();
  if (is_watched_ && requested_ == Presses() && !collection_.is_analysing() && !work_.is_running())
    delay_.start();  // restarts with every change
}

void PressForecast::begin() {
  if (work_.is_running() || !is_needed() || collection_.is_analysing()) return;
  requested_ = present();
  work_.start([this,
               requested = requested_,
               inputs = run_.next_inputs(),
               finger = collection_.analyser()->finger()](const Job& job) {
    std::vector<ReferencedPress> presses;
    for (const auto& press : requested.measured) presses.push_back(*press);
    auto made = std::make_shared<Result<FingerCalibration>>(
        forecast_calibration(finger, presses, inputs, job));
    return std::function<void()>([this, requested, made, is_stopped = job.stop_requested()] {
      if (requested != requested_) return;
      if (is_stopped) return void(requested_ = {});
      if (*made)
        result_ = last_ = std::make_shared<const FingerCalibration>(std::move(**made));
      else
        problem_ = made->error();
      Q_EMIT changed();
    });
  });
  Q_EMIT changed();
}

const FingerCalibration* PressForecast::baseline() const {
  return run_.result() ? run_.result().get() : last_.get();
}

}  // namespace alltact
