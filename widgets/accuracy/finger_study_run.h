// The study of the open finger and the settings in use: stored with the finger, measured on a
// background thread, changed undoably.
#pragma once

#include "calibration/finger/measuring_presets.h"
#include "calibration/study/finger_study.h"
#include "widgets/background_work.h"

#include <QUndoStack>
#include <deque>

namespace alltact {

class FingerStudyRun : public QObject {
  Q_OBJECT
 public:
  FingerStudyRun(QUndoStack& undo, std::string program_version, QObject* parent = nullptr);

  /// Reads the finger's stored study; an empty folder: none is open. Call it again when the
  /// folder's content has changed.
  void open(const std::filesystem::path& folder);
  /// Measures what is missing. Does nothing while it runs, or without a finger.
  void start(StudyExtent extent);
  /// Rows measured so far are stored, and the next start() continues there.
  void stop() { work_.stop(); }
  [[nodiscard]] bool is_running() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }

  /// The finger measures with them from now on, everywhere; undoable. `row` is of study().
  void use(std::size_t row);

  /// The finger as its folder has it; null where none is open or it cannot be read.
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  /// Null where the finger has none stored.
  [[nodiscard]] const std::shared_ptr<const FingerStudy>& study() const { return study_; }
  /// The row that the finger measures with; nullopt: it is not among the measured ones.
  [[nodiscard]] std::optional<std::size_t> row_in_use() const;
  [[nodiscard]] const PipelineSettings& settings_in_use() const { return in_use_.settings; }
  /// Why the last piece of work failed.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

 Q_SIGNALS:
  void changed();

 private:
  struct InUse {
    std::string name;  ///< empty: as calibrated
    PipelineSettings settings;
    [[nodiscard]] bool operator==(const InUse& other) const {
      return name == other.name && key_of(settings) == key_of(other.settings);
    }
  };
  struct FolderState {
    FingerPtr finger;
    std::shared_ptr<const FingerStudy> study;
    InUse in_use;
    std::optional<Error> problem;
  };
  [[nodiscard]] static FolderState state_of(const std::filesystem::path& folder);
  void read_folder();
  void take(const FolderState& folder_state);
  void set_in_use(const std::filesystem::path& folder, const InUse& requested);
  void write_next();

  QUndoStack& undo_;
  std::string version_;
  std::filesystem::path folder_;
  FingerPtr finger_;
  std::shared_ptr<const FingerStudy> study_;
  InUse in_use_;
  std::optional<Error> problem_;
  std::deque<std::pair<std::filesystem::path, InUse>> to_write_;  // in the order of the changes
  BackgroundWork work_, reading_, writing_;
};

}  // namespace alltact
