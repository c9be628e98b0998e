// All fingers of the lab in one list: grade, dates of calibration and check, and what is due.
#pragma once

#include "widgets/background_work.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/fitted_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <set>
#include <vector>

namespace alltact {

/// The fingers in `known` and all others in the same parent folders.
[[nodiscard]] std::vector<FingerCard> read_all_fingers(
    const std::set<std::filesystem::path>& folders,
    const std::vector<std::filesystem::path>& known,
    const std::string& now,
    const Job& job);

class FingerListDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// known: fingers' folders; read on a background thread.
  explicit FingerListDialog(std::vector<std::filesystem::path> known, QWidget* parent = nullptr);
  [[nodiscard]] const std::vector<FingerCard>& cards() const { return cards_; }

 Q_SIGNALS:
  void finger_chosen(const QString& folder);

 private:
  void read();
  void fill();
  void choose_folder();
  void open_chosen();
  void follow_choice();

  std::vector<std::filesystem::path> known_;
  std::set<std::filesystem::path> folders_;  // to search
  std::vector<FingerCard> cards_;            // most urgent first
  QTreeWidget* list_;
  QLabel* count_;
  QPushButton *open_, *folder_;
  QDialogButtonBox* buttons_;
  BackgroundWork reading_;
};

}  // namespace alltact
