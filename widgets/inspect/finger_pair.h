// A second finger next to the first: its recording synchronised with the first, the poses of both
// in the gripper, and the distance between their faces.
#pragma once

#include "core/base/slow_disk.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/surface_distance.h"
#include "core/sources/file_source.h"
#include "widgets/background_work.h"
#include "widgets/controls/number_field.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/inspect/inspection.h"
#include "widgets/widget_base.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QObject>
#include <QPushButton>
#include <array>
#include <map>
#include <optional>

namespace alltact {

/// A finger's name and pose in the gripper, from its file.
struct FingerMount {
  std::string name;
  std::optional<RigidTransform> gripper_from_camera;
};

/// Belongs to the window's thread; reads, writes and measures on background threads.
class FingerPair : public QObject {
  Q_OBJECT
 public:
  /// `first` outlives it.
  explicit FingerPair(const Inspection& first, QObject* parent = nullptr);

  /// Empty: no finger with a folder.
  void set_first(const std::filesystem::path& finger);
  /// None closes it.
  void open(const std::optional<SecondFinger>& second);
  [[nodiscard]] bool is_open() const { return second_.has_value(); }
  /// The first recording shows another frame now.
  void follow();

  [[nodiscard]] const Inspection& second() const { return inspection_; }
  [[nodiscard]] const std::filesystem::path& folder(bool is_second) const {
    return folders_[is_second ? 1 : 0];
  }
  /// Null while it is being read.
  [[nodiscard]] const FingerMount* mount(bool is_second) const;
  [[nodiscard]] QString name(bool is_second) const;
  /// Both gripper poses are known.
  [[nodiscard]] bool has_both_poses() const;
  /// The present frames, both with a surface, and their gap once it is measured; nullopt where one
  /// of them has no face.
  [[nodiscard]] std::optional<FramePair> frames() const;
  [[nodiscard]] const MatchedFrame& partner() const { return partner_; }
  /// FramePair::gap of frames().
  [[nodiscard]] std::optional<NearestPoints> gap() const;
  /// Why a file could not be read or written.
  [[nodiscard]] std::optional<Error> problem() const;

  /// Writes the pose into the finger's file; changed() reports the end, problem() an error.
  void set_pose(const std::filesystem::path& finger,
                const std::optional<RigidTransform>& gripper_from_camera);

 Q_SIGNALS:
  void changed();

 private:
  void read_mounts();
  void measure();
  [[nodiscard]] bool is_measured(const FramePair& frames) const;

  const Inspection& first_;
  Inspection inspection_;
  std::optional<SecondFinger> second_;
  std::array<std::filesystem::path, 2> folders_;
  std::map<std::filesystem::path, FingerMount> mounts_;
  std::optional<Error> read_problem_;
  MatchedFrame partner_;
  FramePair measured_;  // frames, poses and gap of the last measurement
  std::shared_ptr<DiskQueue> disk_ = std::make_shared<DiskQueue>();
  BackgroundWork reading_, measuring_;
};

// The second finger, how both recordings are synchronised, and the distance between the faces.

class PairBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  /// `pair` outlives it.
  explicit PairBox(const FingerPair& pair, QWidget* parent = nullptr);
  /// is_recording: a recording is open, so that a second one can be opened.
  void show_pair(bool is_recording);
  /// For the layout of another widget: the box is hidden while there is no second finger.
  [[nodiscard]] QPushButton* open_button() const { return open_; }

 Q_SIGNALS:
  void open_requested();
  void close_requested();
  void pose_requested(bool is_second);

 private:
  [[nodiscard]] QString joined_text() const;
  [[nodiscard]] QString gap_text() const;

  const FingerPair& pair_;
  QPushButton *open_, *close_, *pose_first_, *pose_second_;
  QLabel *names_, *joined_, *gap_;
};

// Dialog for the second finger and its recording.

class SecondFingerDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// To be shown in one gripper, or to be compared with.
  enum class Purpose { kGripper = 1, kComparison };
  explicit SecondFingerDialog(const std::optional<SecondFinger>& now, QWidget* parent = nullptr,
                              Purpose purpose = Purpose::kGripper);

 Q_SIGNALS:
  void chosen(const alltact::SecondFinger& second);

 private:
  void show_missing();

  QLabel *intro_, *finger_label_, *recording_label_, *missing_;
  QLineEdit *finger_, *recording_;
  QPushButton *choose_finger_, *choose_video_, *choose_folder_;
  QDialogButtonBox* buttons_;
};

// Dialog for the pose of a finger's camera in the gripper, in millimetres and degrees.

class GripperDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// now: the known pose.
  GripperDialog(const QString& finger, const std::optional<RigidTransform>& now,
                QWidget* parent = nullptr);
  /// The pose in the fields; exactly the initial pose where no field was changed.
  [[nodiscard]] RigidTransform pose() const;

 Q_SIGNALS:
  /// none: the pose is unknown.
  void chosen(const std::optional<alltact::RigidTransform>& gripper_from_camera);

 private:
  QString finger_;
  std::optional<RigidTransform> now_;
  QLabel *intro_, *at_label_, *turn_label_;
  std::array<NumberField*, 3> at_, turn_;
  QPushButton* forget_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
