// The running source with its recording, the finger and the camera's controls, as one object of the
// window's thread. No call blocks.
#pragma once

#include "calibration/live/live_finger.h"
#include "core/live/camera_controller.h"
#include "core/live/source_runner.h"
#include "core/open/open_source.h"
#include "widgets/live/touch_history.h"

#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>

namespace alltact {

/// Status for the window, except the image.
struct LiveStatus {
  SourceStatus source;
  RecordingStatus recording;
  FingerStatus finger;
  CameraControllerStatus controller;
  double shown_per_s = 0;        ///< views taken over the last second
  std::optional<double> age_ms;  ///< age of the last view when it was taken
  Message remark;                ///< the camera's latest, for ten seconds; then empty
};

class LiveSession : public QObject {
  Q_OBJECT
 public:
  explicit LiveSession(SourceOpener opener = &alltact::open_source, QObject* parent = nullptr);
  ~LiveSession() override;

  void open_source(const std::vector<std::filesystem::path>& inputs,
                   const std::vector<ControlValue>& controls = {});
  void close_source();
  /// An empty folder closes the finger; a simulated source then shows the finger of its scene.
  void open_finger(const std::filesystem::path& folder);
  /// `feed`: see SourceRunner.
  void start_recording(const std::filesystem::path& file, const RecorderSettings& settings = {},
                       std::shared_ptr<RecordingFeed> feed = nullptr);
  void stop_recording() { runner_->stop_recording(); }
  void set_layers(RequestedLayers layers) { live_finger_->set_layers(layers); }
  void set_depth_top_mm(double top_mm) { live_finger_->set_depth_top_mm(top_mm); }
  /// A camera that is still being opened gets it when it is ready.
  void set_control(const ControlValue& control);
  /// Light setting stored with every frame from now on; see SourceRunner.
  void set_light(const std::optional<DimmerSetting>& light) { runner_->set_light(light); }
  void set_lock(bool is_locked) { controller_.set_lock(is_locked); }

  /// Zero of the open finger's forces; none: as measured.
  void set_force_zero(const std::optional<SessionZero>& zero);

  /// The newest view; null before the first.
  [[nodiscard]] const std::shared_ptr<const LiveView>& view() const { return view_; }
  [[nodiscard]] const LiveStatus& status() const { return status_; }
  /// Capture time of its frame, ns of the monotonic clock; empty where its source has no times.
  [[nodiscard]] std::optional<std::int64_t> view_ns() const { return view_ns_; }
  [[nodiscard]] const SourceOpener& opener() const { return opener_; }
  /// Times of a frame, smoothed over several frames to be readable.
  [[nodiscard]] const StepTimes& times_ms() const { return times_ms_; }
  /// Of the open finger, from the views taken.
  [[nodiscard]] const TouchHistory& touch_history() const { return touch_history_; }
  /// The zero that was set, as long as it is of the open finger and its force model.
  [[nodiscard]] std::optional<SessionZero> force_zero() const;
  /// Ages of the last views when they were taken, ms; at most the last thousand.
  [[nodiscard]] const std::deque<double>& ages_ms() const { return ages_ms_; }

 Q_SIGNALS:
  /// There is a newer view. Never queued twice: a slow receiver gets fewer views.
  void view_ready();
  /// status() was updated: several times a second, and at once after a call of this object.
  void status_ready();

 private:
  void take_view();
  void refresh();
  void follow_scene();
  void follow_remarks();
  void follow_touch();

  SourceOpener opener_;
  FrameHub hub_;
  std::atomic<bool> is_view_pending_{false};
  std::unique_ptr<LiveFinger> live_finger_;
  std::unique_ptr<SourceRunner> runner_;
  CameraController controller_;
  std::vector<std::filesystem::path> inputs_;  // of the requested source; empty for none
  std::vector<ControlValue> requested_controls_;
  std::filesystem::path folder_;
  std::shared_ptr<const LiveView> view_;
  std::optional<std::int64_t> view_ns_;
  LiveStatus status_;
  RecordingStatus last_recording_;  // of a source that was closed since
  std::deque<std::int64_t> taken_ns_;
  std::deque<double> ages_ms_;
  StepTimes times_ms_;
  TouchHistory touch_history_;
  std::optional<SessionZero> force_zero_;
  std::vector<Message> remarks_;
  std::int64_t remarked_ns_ = 0;
  QTimer timer_;
};

}  // namespace alltact
