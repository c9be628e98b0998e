// Checklist before the first recording: each item with its figure and, where that is not good, with
// advice.
#pragma once

#include "calibration/checks/rig_check.h"
#include "calibration/reference/motion_coverage.h"
#include "calibration/reference/reference_recording.h"
#include "core/devices/camera_controls.h"
#include "core/live/recording_feed.h"
#include "core/sensing/frame_result.h"
#include "widgets/background_work.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <QTemporaryDir>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Automatic camera modes are one more line, which names the controls to lock.
class RigCheckBox : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit RigCheckBox(QWidget* parent = nullptr);

  /// `controls`: of the camera; empty where the source is none.
  void show_findings(const std::vector<RigFinding>& findings,
                     const std::vector<CameraControl>& controls);
  /// Unfolds the list when needed, else folds it; the user may change that.
  void set_needed(bool is_needed);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Line {
    Meaning meaning = Meaning::kGood;
    bool is_known = true;
    QString text;
    bool operator==(const Line&) const = default;
  };
  struct Row {
    QLabel *symbol, *text;
  };
  [[nodiscard]] static Line line_of(const RigFinding& finding);
  void show_lines(bool anew);
  void show_fold();

  QToolButton* fold_;
  QWidget* rows_;
  QVBoxLayout* column_;
  std::vector<Row> shown_;
  std::vector<Line> lines_;
  std::vector<RigFinding> findings_;
  std::vector<CameraControl> controls_;
  bool is_needed_ = false;
};

// Coverage of bending, as a plot and as text.

[[nodiscard]] QString bend_direction_text(BendDirection direction);

/// Bend and sway as a field with the poses so far and the present pose, twist as a bar below. A
/// tick or a ring at each direction marks it as reached or not; screen readers get a sentence.
class CoverageView : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit CoverageView(QWidget* parent = nullptr);
  void show_coverage(const BendState& coverage);

  [[nodiscard]] QSize sizeHint() const override { return {280, 330}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 290}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void describe();
  void paint_field(QPainter& painter, const QRectF& field) const;
  void paint_twist(QPainter& painter, const QRectF& bar) const;
  void paint_label(QPainter& painter, const QRectF& room, int flags, BendDirection direction) const;
  void paint_sign(QPainter& painter, QPointF centre, bool is_reached) const;

  BendState coverage_;
};

// Detects bending too quick for the image to be compared with the reference: motion then resembles
// a contact.

/// Call it with every analysed frame. Frames without capture times are timed on arrival.
class QuickBending {
 public:
  /// Marker speed above which bending is quick, in image widths per second.
  static constexpr double kQuick_per_s = 0.08;
  /// Time after quick motion during which the image is not used.
  static constexpr double kSettles_s = 0.4;

  /// Returns false where the speed is unknown: the first frame, no markers, another source.
  bool is_quick(const FrameResult& result);

 private:
  Markers before_;
  double before_s_ = 0;
  double quick_until_s_ = -1;
  std::string source_;
};

// Previews a recording as a finger's reference before it is installed.

/// A recording that was installed in a copy of a finger.
struct JudgedTake {
  Result<ReferenceReport> report;
  std::shared_ptr<const QTemporaryDir> copy;  ///< copy of the finger; removed with its last owner
  std::string finger_yaml;                    ///< finger.yaml as it was copied
  std::filesystem::path finger, video;

  /// Copies the new reference to the finger. False: the finger has changed since, or files other
  /// than a reference are to be stored, so that the recording must be installed directly. For a
  /// background thread.
  [[nodiscard]] Result<bool> install() const;
};

/// The choices of a recording that is still judged, from the window to the judging thread.
class PendingChoices {
 public:
  void put(ReferenceChoices choices);
  /// Waits for them; those of no choice once the job is stopped.
  [[nodiscard]] ReferenceChoices wait(const Job& job) const;

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable is_put_;
  std::optional<ReferenceChoices> choices_;
};

/// Installs the recording in a copy of the finger, so that the report equals that of the
/// installation.
class TakeJudge : public QObject {
  Q_OBJECT
 public:
  explicit TakeJudge(QObject* parent = nullptr);

  /// finger: its folder, which stays unchanged.
  void judge(const std::filesystem::path& finger, const std::filesystem::path& video,
             const ReferenceChoices& choices);
  /// The same of a recording from its first frame on, so that little is left to do at its end.
  /// conclude() must follow it.
  void follow(const std::filesystem::path& finger, std::shared_ptr<RecordingFeed> feed);
  /// The recording is over. False: it is not followed, or did not become complete, so that it must
  /// be judged.
  [[nodiscard]] bool conclude(const std::filesystem::path& finger,
                              const std::filesystem::path& video, ReferenceChoices choices);
  /// Stops the run; a finished report is retained.
  void stop();
  void forget();
  [[nodiscard]] bool is_working() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }
  /// Result for the last judged video; nullptr: not known.
  [[nodiscard]] const std::shared_ptr<const JudgedTake>& judged() const { return judged_; }

 Q_SIGNALS:
  void changed();

 private:
  using Judging =
      std::function<Result<ReferenceReport>(const std::filesystem::path& copy, const Job& job)>;
  void run(const std::filesystem::path& finger, const std::filesystem::path& video,
           Judging judging);

  int number_ = 0;  // of the last request
  std::shared_ptr<const JudgedTake> judged_;
  // Of a recording that is followed and not yet concluded.
  std::filesystem::path followed_finger_;
  std::shared_ptr<RecordingFeed> feed_;
  std::shared_ptr<PendingChoices> pending_;
  BackgroundWork work_, clearing_;
};

}  // namespace alltact
