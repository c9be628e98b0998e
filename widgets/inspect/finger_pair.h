// A second finger next to the first: its recording synchronised with the first, the poses of both
// in the gripper, and the distance between their faces.
#pragma once

#include "core/geometry/surface_distance.h"
#include "core/io/disk_queue.h"
#include "core/recording/time_match.h"
#include "widgets/background_work.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspection.h"

#include <QObject>
#include <array>
#include <map>

namespace alltact {

/// A finger's name and pose in the gripper, from its file.
struct FingerMount {
  std::string name;
  std::optional<RigidTransform> gripper_from_camera;
};

/// Two frames, each of one finger.
struct FramePair {
  std::shared_ptr<const InspectedFrame> first, second;  ///< both with a surface
  bool operator==(const FramePair&) const = default;
};

/// Belongs to the window's thread; reads, writes and measures on background threads.
class FingerPair : public QObject {
  Q_OBJECT
 public:
  /// `first` outlives it.
  explicit FingerPair(const Inspection& first, QObject* parent = nullptr);
  ~FingerPair() override;

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
  /// The present frames; null where one of them has no face.
  [[nodiscard]] std::optional<FramePair> frames() const;
  [[nodiscard]] const MatchedFrame& partner() const { return partner_; }
  /// Shortest distance between the faces of frames(), gripper frame; none while it is being
  /// measured.
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
  [[nodiscard]] RigidTransform pose(bool is_second) const;

  const Inspection& first_;
  Inspection inspection_;
  std::optional<SecondFinger> second_;
  std::array<std::filesystem::path, 2> folders_;
  std::map<std::filesystem::path, FingerMount> mounts_;
  std::optional<Error> read_problem_;
  MatchedFrame partner_;
  struct Measured {
    FramePair frames;
    std::array<RigidTransform, 2> poses;
    std::optional<NearestPoints> gap;
  };
  std::optional<Measured> measured_;
  std::shared_ptr<DiskQueue> disk_ = std::make_shared<DiskQueue>();
  BackgroundWork reading_, measuring_;
};

}  // namespace alltact
