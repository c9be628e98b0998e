// Gage R&R of several fingers by their operators, from their checks or from a table.
#pragma once

#include "calibration/checks/gage_readings.h"
#include "widgets/background_work.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/row_list.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <filesystem>
#include <optional>
#include <vector>

namespace alltact {

class GageDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// `fingers`: folders, at least one; their checks are read on a background thread.
  explicit GageDialog(std::vector<std::filesystem::path> fingers, QWidget* parent = nullptr);
  [[nodiscard]] const std::optional<GageStudy>& study() const { return study_; }
  /// Reads the table instead of the fingers' checks.
  void open_table(const std::filesystem::path& file);

 private:
  using Reader = std::function<Result<GageReadings>(const Job&)>;
  void read(const Reader& reader);
  void name_parts();
  void show_study();
  void show_variation();
  void show_anova();
  /// Both tables, with tabulators, for a spreadsheet.
  void copy() const;

  std::vector<std::filesystem::path> fingers_;
  QLabel *intro_, *tolerance_label_;
  ReservedText *counts_, *sentence_;
  NumberField* tolerance_;
  RowList *variation_, *anova_;
  ProblemList* problems_;
  QPushButton *table_, *copy_;
  QDialogButtonBox* buttons_;
  std::optional<GageStudy> study_;
  double origin_mm_ = 0;
  BackgroundWork reading_;
};

}  // namespace alltact
