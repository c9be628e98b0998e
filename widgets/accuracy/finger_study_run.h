// The study of the open finger, and the settings that it measures with: kept with the finger,
// measured beside the window, changed undoably.
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

  /// Looks what the finger keeps; an empty folder: none is open. To be called again when what
  /// stands there has changed.
  void open(const std::filesystem::path& folder);
  /// Measures what is missing. Does nothing while it runs, or without a finger.
  void start(StudyExtent extent);
  /// What was measured is kept, and the next start() goes on there.
  void stop() { work_.stop(); }
  [[nodiscard]] bool is_running() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }

  /// The finger measures with them from now on, everywhere; undoable. `row` is of study().
  void use(std::size_t row);

  /// As it stands in its folder; null where none is open or it cannot be read.
  [[nodiscard]] const FingerPtr& finger() const { return finger_; }
  /// Null where the finger keeps none.
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
  struct Looked {
    FingerPtr finger;
    std::shared_ptr<const FingerStudy> study;
    InUse in_use;
    std::optional<Error> problem;
  };
  [[nodiscard]] static Looked look_at(const std::filesystem::path& folder);
  void look();
  void take(const Looked& looked);
  void set_in_use(const std::filesystem::path& folder, const InUse& wanted);
  void write_next();

  QUndoStack& undo_;
  std::string version_;
  std::filesystem::path folder_;
  FingerPtr finger_;
  std::shared_ptr<const FingerStudy> study_;
  InUse in_use_;
  std::optional<Error> problem_;
  std::deque<std::pair<std::filesystem::path, InUse>> to_write_;  // in the order of what was done
  BackgroundWork work_, looking_, writing_;
};

}  // namespace alltact
