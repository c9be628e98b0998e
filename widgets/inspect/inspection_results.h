// A recording inspected by a recipe: summary of every reading, its values over the frames, a table
// of all frames, and a report.
#pragma once

#include "calibration/live/inspect_recording.h"
#include "widgets/background_work.h"
#include "widgets/controls/row_list.h"
#include "widgets/plots/plot.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

// Values of one reading over the frames, with their standard deviations and limits.

struct ReadingSeries {
  std::vector<double> x;  ///< s, or numbers of frames from 1
  std::vector<double> values, sd;
  std::optional<double> lower, upper;
  bool is_time = false;
  QString label;  ///< with the unit, of the y axis
};
[[nodiscard]] ReadingSeries series_of(const InspectionLog& log, std::size_t reading);

class ReadingPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  void set_series(ReadingSeries series);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  ReadingSeries series_;
};

// The dialog, and what it saves.

/// A row a frame and a column a reading; sorted by the column whose head is clicked.
class FrameTable : public RowList {
  Q_OBJECT
 public:
  explicit FrameTable(QWidget* parent = nullptr);
  void show_log(const InspectionLog& log);
  /// The selected rows, or all where none is selected, in the shown order: the head and a line
  /// each, cells apart by tabs.
  [[nodiscard]] QString text() const;

 Q_SIGNALS:
  /// Index of a frame that was clicked, or chosen by keys.
  void frame_chosen(std::size_t index);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void follow_selection();
  std::optional<std::size_t> chosen_;
};

class InspectionResults : public FittedDialog {
  Q_OBJECT
 public:
  /// Starts at once, on a background thread.
  explicit InspectionResults(InspectionOrder order, QWidget* parent = nullptr);
  /// Null until it is done.
  [[nodiscard]] const std::shared_ptr<const InspectionLog>& log() const { return log_; }
  /// The table that `alltact inspect` writes for the same recording and recipe, to the byte.
  void save_table(const std::filesystem::path& file);
  /// A report to sign, in English: PDF.
  void save_report(const std::filesystem::path& file);

 Q_SIGNALS:
  /// The user asks to see this frame of the recording.
  void frame_requested(std::size_t index);

 private:
  void name_parts();
  void show_log();
  void show_plot();
  void choose_file(const QString& ending,
                   void (InspectionResults::*save)(const std::filesystem::path& file));
  void show_saved(const Status& status, const std::filesystem::path& file);

  const InspectionOrder order_;
  ReservedText* verdict_;
  QTabWidget* tabs_;
  RowList* table_;
  ReadingPlot* plot_;
  FrameTable* frames_;
  QProgressBar* bar_;
  ProblemList* problems_;
  QPushButton *stop_, *copy_, *save_table_, *save_report_;
  QDialogButtonBox* buttons_;
  std::shared_ptr<const InspectionLog> log_;
  BackgroundWork work_;
};

/// Several recordings inspected by one recipe: a row for each recording and reading.
class RecordingsInspection : public FittedDialog {
  Q_OBJECT
 public:
  /// Starts at once, on a background thread.
  explicit RecordingsInspection(InspectionOrder order, QWidget* parent = nullptr);
  /// Empty until it is done.
  [[nodiscard]] const std::vector<InspectedRecording>& recordings() const { return recordings_; }
  /// The table that `alltact inspect --each` writes, to the byte.
  void save_table(const std::filesystem::path& file);

 private:
  void name_parts();
  void show_recordings();

  ReservedText* summary_;
  RowList* table_;
  QProgressBar* bar_;
  ProblemList* problems_;
  QPushButton *stop_, *save_table_;
  QDialogButtonBox* buttons_;
  std::vector<InspectedRecording> recordings_;
  BackgroundWork work_;
};

/// `date`: UTC, as utc_now() writes it; the same values give the same bytes. Error: it could not be
/// printed.
[[nodiscard]] Result<std::string> inspection_report_pdf(const InspectionLog& log,
                                                        const InspectionOrder& order,
                                                        const std::string& date);

}  // namespace alltact
