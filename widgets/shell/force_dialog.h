// Trains a finger's force model from tables, shows its errors, and installs or discards it.
#pragma once

#include "calibration/force/train_force.h"
#include "widgets/background_work.h"
#include "widgets/controls/row_list.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

class ForceDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// `undo` outlives the dialog.
  ForceDialog(std::filesystem::path finger, QUndoStack& undo, QWidget* parent = nullptr);
  /// Trains with them, on a background thread; the finger does not change. `training`: for tests,
  /// which have little time.
  void train(std::vector<std::filesystem::path> tables, const ForceTraining& training = {});
  /// Null until it is trained, and again when it is installed or discarded.
  [[nodiscard]] const std::shared_ptr<TrainedForce>& trained() const { return trained_; }

 private:
  void name_parts();
  void choose_tables();
  void install();
  void discard();
  void show_state();
  void show_comparison();
  void show_problem(const Error& error);

  std::filesystem::path finger_;
  QUndoStack& undo_;
  QLabel* intro_;
  ElidedLabel* tables_text_;
  QPushButton *choose_, *stop_, *install_, *discard_;
  QProgressBar* bar_;
  RowList* comparison_;
  ReservedText* sentence_;
  ProblemList* problems_;
  QDialogButtonBox* buttons_;
  std::vector<std::filesystem::path> tables_;
  std::shared_ptr<ForceTable> table_;
  std::shared_ptr<TrainedForce> trained_;
  bool is_installed_ = false;
  BackgroundWork work_;
};

/// A finger with markers and a reference is open.
[[nodiscard]] bool can_train_force(const FingerStatus& finger);
/// The dialog for the open finger.
void open_force_training(const LiveSession& session, QUndoStack& undo, QWidget& parent);

}  // namespace alltact
