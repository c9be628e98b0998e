// The inspection recipe on the page Inspect: its readings in the frame that is shown, their
// tolerances, and its file.
#pragma once

#include "core/inspection/inspection_log.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/row_list.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/shell/problem_list.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QDialogButtonBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <filesystem>
#include <memory>

namespace alltact {

/// "pass", in the window's language.
[[nodiscard]] QString conformity_text(Conformity conformity);
[[nodiscard]] Meaning meaning_of(Conformity conformity);
/// "0.45 to 0.55 mm", "at least 0.45 mm"; empty without a tolerance.
[[nodiscard]] QString tolerance_text(const RecipeReading& reading);

class RecipeBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit RecipeBox(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null: nothing can be measured.
  void show_frame(const std::shared_ptr<const InspectedFrame>& frame);
  /// Adds a reading between the points A and B, which are both chosen.
  void add(Measurand what);
  /// Replaces the recipe, or shows why the file cannot be read.
  void open(const std::filesystem::path& file);

 Q_SIGNALS:
  /// As in ViewBox.
  void changed(const alltact::InspectOptions& options, const alltact::StepWords& what,
               int merge_id);
  /// The recipe is to be run over the recording, or over those of a folder.
  void run_requested();
  void run_in_folder_requested();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void name_parts();
  void connect_parts();
  void fill();
  void follow_selection();
  /// -1: none is selected.
  [[nodiscard]] int selected() const;
  void set_recipe(InspectionRecipe recipe, const StepWords& what);
  void change_selected();
  void remove_selected();
  void choose_file();
  void save();

  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  QLabel* hint_;
  RowList* list_;
  ProblemList* problems_;
  QPushButton *change_, *remove_, *open_, *save_, *run_, *run_in_folder_;
};

/// Name and tolerance of one reading.
class ReadingDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// `recipe`: holds `reading`; other names of it are refused.
  ReadingDialog(RecipeReading reading, InspectionRecipe recipe, QWidget* parent = nullptr);

 Q_SIGNALS:
  void accepted_reading(const alltact::RecipeReading& reading);

 private:
  void take();

  RecipeReading reading_;
  InspectionRecipe recipe_;
  QLabel *name_label_, *lower_label_, *upper_label_;
  QLineEdit* name_;
  NumberField *lower_, *upper_;
  ProblemList* problems_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
