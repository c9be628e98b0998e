// Exports a finger's calibration for other programs: formats, folder, and the files written.
#pragma once

#include "calibration/export/export_finger.h"
#include "widgets/background_work.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <filesystem>
#include <vector>

namespace alltact {

class ExportDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// `finger`: its folder. The default target is a folder next to it.
  explicit ExportDialog(const std::filesystem::path& finger, QWidget* parent = nullptr);
  [[nodiscard]] std::vector<ExportForm> forms() const;
  [[nodiscard]] QString command_line() const;

 private:
  struct Form {
    ExportForm form;
    QCheckBox* check_box;
    QLabel* what_for;
  };
  [[nodiscard]] QLayout* make_forms();
  [[nodiscard]] QLayout* make_folder_row();
  [[nodiscard]] QLayout* make_command_row();
  void name_forms();
  void show_verdict();
  void show_command();
  void show_running(bool is_running);
  void write();
  void show_outcome(const Status& status, const std::vector<std::filesystem::path>& written,
                    const std::vector<std::filesystem::path>& left_out);

  const std::filesystem::path finger_;
  std::vector<Form> forms_;
  QLabel *intro_, *verdict_symbol_, *verdict_, *folder_label_;
  QLineEdit *folder_, *command_;
  QPushButton *choose_, *copy_, *write_, *stop_;
  QProgressBar* progress_;
  ProblemList* outcome_;
  QDialogButtonBox* buttons_;
  std::optional<FingerCard> card_;
  BackgroundWork work_, reading_;
};

}  // namespace alltact
