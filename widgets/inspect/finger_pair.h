// A second finger beside the first: its recording, frame by frame in step with the first one's,
// where both sit in the gripper, and how near their faces come.
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

/// What a finger's file says for the gripper.
struct FingerPlace {
  std::string name;
  std::optional<RigidTransform> gripper_from_camera;
};

/// Two frames, each of one finger.
struct FramePair {
  std::shared_ptr<const InspectedFrame> first, second;  ///< both with a surface
  bool operator==(const FramePair&) const = default;
};

/// An object of the window's thread; files are read and written, and distances measured, beside it.
class FingerPair : public QObject {
  Q_OBJECT
 public:
  /// `first` outlives it.
  explicit FingerPair(const Inspection& first, QObject* parent = nullptr);
  ~FingerPair() override;

  /// Empty: no finger of one's own.
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
  [[nodiscard]] const FingerPlace* place(bool is_second) const;
  [[nodiscard]] QString name(bool is_second) const;
  /// Both are known.
  [[nodiscard]] bool is_placed() const;
  /// Whatever is known by now; null where one of them has no face.
  [[nodiscard]] std::optional<FramePair> frames() const;
  [[nodiscard]] const FrameBeside& beside() const { return beside_; }
  /// Of frames(), in the gripper's frame; none while it is being measured.
  [[nodiscard]] std::optional<NearestPoints> gap() const;
  /// Why a file could not be read or written.
  [[nodiscard]] std::optional<Error> problem() const;

  /// Writes it into the finger's file. Told by changed(), or by problem() and changed().
  void set_place(const std::filesystem::path& finger, const std::optional<RigidTransform>& place);

 Q_SIGNALS:
  void changed();

 private:
  void read_places();
  void measure();
  [[nodiscard]] RigidTransform pose(bool is_second) const;

  const Inspection& first_;
  Inspection inspection_;
  std::optional<SecondFinger> second_;
  std::array<std::filesystem::path, 2> folders_;
  std::map<std::filesystem::path, FingerPlace> places_;
  std::optional<Error> read_problem_;
  FrameBeside beside_;
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
