// The page Accuracy: the user states a frame rate and an error, and the page proposes one setting.
// Below, time and error of every setting on this finger.
#pragma once

#include "calibration/finger/measuring_presets.h"
#include "calibration/study/recommended_settings.h"
#include "calibration/study/study_file.h"
#include "widgets/accuracy/accuracy_plot.h"
#include "widgets/accuracy/settings_comparison.h"
#include "widgets/background_work.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/page.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QUndoStack>
#include <deque>

namespace alltact {

// The study of the open finger and the settings in use: stored with the finger, measured on a
// background thread, changed undoably.

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
  [[nodiscard]] const FingerPtr& finger() const { return now_.finger; }
  /// Null where the finger has none stored.
  [[nodiscard]] const std::shared_ptr<const FingerStudy>& study() const { return now_.study; }
  /// The row that the finger measures with; nullopt: it is not among the measured ones.
  [[nodiscard]] std::optional<std::size_t> row_in_use() const;
  [[nodiscard]] const PipelineSettings& settings_in_use() const { return now_.in_use.settings; }
  /// Why the last piece of work failed.
  [[nodiscard]] const std::optional<Error>& problem() const { return now_.problem; }

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
  FolderState now_;
  std::deque<std::pair<std::filesystem::path, InUse>> to_write_;  // in the order of the changes
  BackgroundWork work_, reading_, writing_;
};

class AccuracyPage : public Page {
  Q_OBJECT
 public:
  /// `undo`: receives every change.
  AccuracyPage(LiveSession& session, QUndoStack& undo, std::string program_version,
               QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Accuracy"); }
  [[nodiscard]] QString menu_text() const override { return tr("&Accuracy"); }
  void add_problems(std::vector<Problem>& problems) override;
  void reload() override { run_.open(folder_); }

  [[nodiscard]] FingerStudyRun& run() { return run_; }
  [[nodiscard]] AccuracyPlot& plot() { return *plot_; }
  [[nodiscard]] SettingsComparison& sides() { return *sides_; }
  /// Row of the study shown as the answer; nullopt where there is none.
  [[nodiscard]] std::optional<std::size_t> answer_row() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_first();
  [[nodiscard]] QWidget* make_measured();
  [[nodiscard]] QLayout* make_questions();
  [[nodiscard]] QLayout* make_answer();
  void connect_parts();
  void name_parts();
  void follow();
  void update_question();
  void pick(std::size_t point);
  void use();
  void show_run();
  void show_progress();
  void show_points();
  void show_answer();
  void show_sides();
  [[nodiscard]] AccuracyPoint point_of(std::size_t row) const;
  [[nodiscard]] QString hint_of(const StudyRow& row) const;
  [[nodiscard]] QString figures_of(const StudyRow& row) const;
  [[nodiscard]] QString row_words(const StudyRow& row) const;
  [[nodiscard]] QString answer_note() const;
  [[nodiscard]] QString standing_text() const;
  [[nodiscard]] QString study_obstacle() const;
  [[nodiscard]] QString command_line() const;
  [[nodiscard]] std::optional<std::size_t> point_of_row(std::size_t row) const;

  LiveSession& session_;
  FingerStudyRun run_;
  QStackedWidget* pages_;
  QLabel *first_words_, *first_reason_;
  QPushButton* measure_;
  QLabel *rate_label_, *error_label_;
  QComboBox* rate_;
  NumberField* error_;
  QLabel *answer_, *figures_, *note_;
  QPushButton *use_, *as_calibrated_;
  QTabWidget* tabs_;
  AccuracyPlot* plot_;
  AccuracyTable* table_;
  SettingsComparison* sides_;
  QPushButton *more_, *copy_;
  QLineEdit* command_;
  QLabel* standing_;
  QWidget* progress_;
  QProgressBar* bar_;
  QLabel* left_;
  QPushButton* stop_;

  std::filesystem::path folder_;
  StudyQuestion question_;
  double finished_rate_ = StudyQuestion().frames_per_s;  // used while another is typed
  std::optional<StudyAnswer> study_answer_;
  std::vector<std::size_t> rows_;      // row of the study of each point
  std::vector<std::size_t> front_;     // rows of the study on the Pareto front
  std::optional<std::size_t> picked_;  // row chosen by hand; else that of study_answer_
  std::shared_ptr<const FingerStudy> shown_;
  std::string shown_in_use_;
};

}  // namespace alltact
