// A second live finger: its own source, synchronised with the first, and joint readings of both in
// their gripper.
#pragma once

#include "calibration/live/live_finger.h"
#include "core/gripper/gripper.h"
#include "core/gripper/held_object.h"
#include "widgets/background_work.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_session.h"
#include "widgets/widget_base.h"

#include <QComboBox>
#include <QDialog>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QObject>
#include <QPushButton>
#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

// Pairs views of two cameras by capture time.

struct ViewPair {
  std::array<std::shared_ptr<const LiveView>, 2> views;
  /// Capture time of the second minus that of the first; empty where a source has no times, so that
  /// the newest views are paired.
  std::optional<double> later_ms;
  bool is_in_time = true;  ///< false: further apart than half a frame
};

/// Pairs views as they arrive. Two views are of one moment where none is nearer in time and they
/// are at most half a frame of the slower camera apart. Free-running cameras always reach that
/// while every frame is measured. Retains kMaxViews views of each.
class ViewPairing {
 public:
  static constexpr std::size_t kMaxViews = 8;
  /// For this long no pair is shown rather than one that is not in time.
  static constexpr double kTimeout_s = 1.0;

  /// which: 0 or 1. time_ns: of capture, of one clock for both; empty: not known.
  /// Returns the pair to be shown from now on; nullopt: the last one stays.
  [[nodiscard]] std::optional<ViewPair> add(std::size_t which, std::shared_ptr<const LiveView> view,
                                            std::optional<std::int64_t> time_ns);
  void forget() { *this = ViewPairing(); }
  /// Measured frame period of this camera; empty before its second frame.
  [[nodiscard]] std::optional<double> period_ms(std::size_t which) const;

 private:
  struct Timed {
    std::shared_ptr<const LiveView> view;
    std::optional<std::int64_t> time_ns;
  };
  void measure_period(std::size_t which, const Timed& now);

  std::array<std::deque<Timed>, 2> views_;
  std::array<std::optional<double>, 2> period_ms_;
  std::optional<std::array<std::int64_t, 2>> shown_ns_;  // of the last pair in time
  std::optional<std::int64_t> waiting_since_ns_;
};

// Joint readings of two fingers of one gripper at one moment.

/// A gripper with the absolute folders of its fingers.
struct OpenGripper {
  Gripper gripper;
  std::array<std::filesystem::path, 2> folders;

  /// Errors: those of Gripper::load.
  static Result<OpenGripper> load(const std::filesystem::path& path);
  /// Indices of these fingers in the gripper; nullopt: they are not its two.
  [[nodiscard]] std::optional<std::array<std::size_t, 2>> order_of(
      const std::array<std::filesystem::path, 2>& fingers) const;
};

struct PairReading {
  ViewPair of;
  double motor_turns = 0;
  std::optional<FaceGap> gap;      ///< empty where a face has no depth
  std::optional<HeldWidth> width;  ///< empty where a finger has no contact
};

/// A finger in a view of the pair.
struct PairedFinger {
  std::filesystem::path folder;
  Face face;
};

/// Errors: the fingers are not the gripper's; those of Gripper::pose_at. Takes tens of
/// milliseconds: not for the window's thread.
[[nodiscard]] Result<PairReading> read_pair(const OpenGripper& gripper, double motor_turns,
                                            const ViewPair& pair,
                                            const std::array<PairedFinger, 2>& fingers);

/// The second finger and its source.
struct SecondCamera {
  std::filesystem::path finger;               ///< folder
  std::vector<std::filesystem::path> source;  ///< as LiveSession::open_source
  std::filesystem::path gripper;              ///< gripper.yaml or its folder; empty: none
  std::optional<double> motor_turns;          ///< none: the middle of its range
  bool operator==(const SecondCamera&) const = default;
};

/// Belongs to the window's thread; reads the gripper and measures distances on background threads.
class LivePair : public QObject {
  Q_OBJECT
 public:
  /// `first` outlives it; its opener opens the second source.
  explicit LivePair(LiveSession& first, QObject* parent = nullptr);

  /// None closes it.
  void open(const std::optional<SecondCamera>& second);
  [[nodiscard]] const std::optional<SecondCamera>& opened() const { return opened_; }
  /// Null before the first open().
  [[nodiscard]] LiveSession* second() const { return second_.get(); }

  /// Views to be shown; nullopt before both have a view, and while nothing is open.
  [[nodiscard]] const std::optional<ViewPair>& pair() const { return pair_; }
  /// Null without a gripper.
  [[nodiscard]] const OpenGripper* gripper() const { return gripper_.get(); }
  [[nodiscard]] std::optional<double> motor_turns() const;
  /// The latest reading; its pair may be older than pair().
  [[nodiscard]] const std::optional<PairReading>& reading() const { return reading_; }
  /// Why there is no reading, including problems of the second source and finger.
  [[nodiscard]] std::optional<Error> problem() const;

 Q_SIGNALS:
  void pair_ready();
  /// opened(), gripper(), reading() or problem() changed.
  void changed();

 private:
  void add(std::size_t which);
  void load_gripper();
  void measure();
  void take(const Result<PairReading>& reading);

  LiveSession& first_;
  std::unique_ptr<LiveSession> second_;
  std::optional<SecondCamera> opened_;
  ViewPairing pairing_;
  std::optional<ViewPair> pair_;
  std::shared_ptr<const OpenGripper> gripper_;
  std::filesystem::path gripper_of_;  // file of gripper_ or of its problem
  std::optional<Error> gripper_problem_, reading_problem_;
  std::optional<PairReading> reading_;
  struct Request {
    std::array<std::shared_ptr<const LiveView>, 2> views;
    double motor_turns;
    bool operator==(const Request&) const = default;
  };
  std::optional<Request> request_;  // of the running or last measurement
  BackgroundWork loading_, measuring_;
};

// The second live finger, the time difference of both views, and joint readings.

class LivePairBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  /// Both outlive it.
  LivePairBox(const LivePair& pair, const LiveSession& first, QWidget* parent = nullptr);
  void show_pair();

 Q_SIGNALS:
  void open_requested();
  void close_requested();
  void motor_requested(double turns);

 private:
  void name_parts();
  [[nodiscard]] QString names_text() const;
  [[nodiscard]] QString moment_text() const;
  [[nodiscard]] QString reading_text() const;

  const LivePair& pair_;
  const LiveSession& first_;
  QPushButton *open_, *close_;
  QLabel *names_, *moment_, *reading_, *motor_label_;
  NumberField* motor_;
};

/// The finger's name or, while it is being read, its folder's name.
[[nodiscard]] QString finger_name(const FingerStatus& finger);

// Dialog for the second live finger, its camera and the gripper.

class SecondCameraDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// cameras: identifiers that open them.
  SecondCameraDialog(const std::optional<SecondCamera>& now, const QStringList& cameras,
                     QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(const alltact::SecondCamera& second);

 private:
  void name_parts();
  void show_missing();
  [[nodiscard]] SecondCamera entered() const;

  std::optional<SecondCamera> now_;
  QLabel *intro_, *finger_label_, *source_label_, *gripper_label_, *missing_;
  QLineEdit *finger_, *gripper_;
  QComboBox* source_;
  QPushButton *choose_finger_, *choose_source_, *choose_gripper_, *show_, *cancel_;
};

}  // namespace alltact
