#include "widgets/calibrating/press_forecast.h"

namespace alltact {

PressForecast::PressForecast(const PressDesk& desk, const CalibrationRun& run, QObject* parent)
    : QObject(parent), desk_(desk), run_(run) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRests_ms);
  connect(&rest_, &QTimer::timeout, this, &PressForecast::begin);
  connect(&desk_, &PressDesk::changed, this, &PressForecast::follow);
  connect(&run_, &CalibrationRun::changed, this, &PressForecast::follow);
  connect(&work_, &BackgroundWork::finished, this, &PressForecast::follow);
}

void PressForecast::set_watched(bool is_watched) {
  is_watched_ = is_watched;
  if (!is_watched) {
    rest_.stop();
    work_.stop();
  }
  follow();
}

PressForecast::Presses PressForecast::present() const {
  Presses presses;
  presses.said = run_.next_inputs().said;
  for (const DeskPress& press : desk_.presses())
    if (press.looked.measured) presses.measured.push_back(press.looked.measured);
  return presses;
}

bool PressForecast::is_wanted() const {
  if (!desk_.is_ready() || desk_.looker() == nullptr || run_.is_running() ||
      run_.state() == CalibrationState::kCurrent)
    return false;
  return std::any_of(desk_.presses().begin(), desk_.presses().end(), [this](const auto& press) {
    return desk_.is_usable(press) && desk_.has_ball(press);
  });
}

void PressForecast::follow() {
  if (folder_ != desk_.folder()) last_.reset();
  folder_ = desk_.folder();
  const bool is_wanted_now = is_wanted();
  if (!is_wanted_now || present() != asked_) {
    const bool was_known = result_ || problem_;
    result_.reset();
    problem_.reset();
    asked_ = {};
    work_.stop();
    if (was_known) Q_EMIT changed();
  }
  if (!is_wanted_now) return rest_.stop();
  if (is_watched_ && asked_ == Presses() && !desk_.is_looking() && !work_.is_running())
    rest_.start();  // anew with every change
}

void PressForecast::begin() {
  if (work_.is_running() || !is_wanted() || desk_.is_looking()) return;
  asked_ = present();
  work_.start(
      [this, asked = asked_, inputs = run_.next_inputs(), finger = desk_.looker()->finger()](
          const Job& job) {
        std::vector<ReferencedPress> presses;
        for (const auto& press : asked.measured) presses.push_back(*press);
        auto made = std::make_shared<Result<FingerCalibration>>(
            forecast_calibration(finger, presses, inputs, job));
        return std::function<void()>([this, asked, made, is_stopped = job.stop_requested()] {
          if (asked != asked_) return;
          if (is_stopped) return void(asked_ = {});
          if (*made)
            result_ = last_ = std::make_shared<const FingerCalibration>(std::move(**made));
          else
            problem_ = made->error();
          Q_EMIT changed();
        });
      });
  Q_EMIT changed();
}

const FingerCalibration* PressForecast::to_compare_with() const {
  return run_.result() ? run_.result().get() : last_.get();
}

}  // namespace alltact
