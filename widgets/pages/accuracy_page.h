// The page Accuracy: the user states a frame rate and an error, and the page proposes one setting.
// Below, time and error of every setting on this finger.
#pragma once

#include "calibration/study/study_answer.h"
#include "widgets/accuracy/accuracy_table.h"
#include "widgets/accuracy/finger_study_run.h"
#include "widgets/accuracy/settings_comparison.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_session.h"
#include "widgets/pages/page.h"
#include "widgets/plots/accuracy_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>

namespace alltact {

class AccuracyPage : public Page {
  Q_OBJECT
 public:
  /// `undo`: receives every change.
  AccuracyPage(LiveSession& session,
               QUndoStack& undo,
               std::string program_version,
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
  int finished_rate_ = StudyQuestion().frames_per_s;  // used while another is typed
  std::optional<StudyAnswer> study_answer_;
  std::vector<std::size_t> rows_;      // row of the study of each point
  std::vector<std::size_t> front_;     // rows of the study on the Pareto front
  std::optional<std::size_t> picked_;  // row chosen by hand; else that of study_answer_
  std::shared_ptr<const FingerStudy> shown_;
  std::string shown_in_use_;
};

}  // namespace alltact
