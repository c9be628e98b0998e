// Summary of a recently used finger, for the start page.
#pragma once

#include "calibration/verdict/verdict.h"
#include "widgets/background_work.h"
#include "widgets/controls/row_list.h"
#include "widgets/verdict_text.h"
#include "widgets/widget_base.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace alltact {

/// Read from the files of a folder; texts are made where they are shown.
struct FingerCard {
  std::filesystem::path folder;
  std::string name;
  std::optional<Grade> grade;  ///< of the calibration
  ReferenceState reference = ReferenceState::kAbsent;
  bool is_recorded = false;       ///< its reference is a recording, not a single image
  bool must_repeat = false;       ///< numbers or reference differ from those of the calibration
  std::vector<Message> findings;  ///< contradictions, then missing requirements
  std::string lacks;              ///< the worst requirement that is not met; empty: none
  Message rests_on;               ///< see Verdict
  /// Of its reference: a change of one of them may change all of this.
  std::vector<std::filesystem::path> files;
  std::string calibrated_on;  ///< UTC, 2026-01-31T12:00:00Z; empty: never
  std::string checked_on;     ///< likewise; of this calibration
  double error_mm = 0;        ///< expected at the next contact; 0: unknown
  double checked_mm = 0;      ///< error in the last check; 0: never checked
  FingerDue due = FingerDue::kNothing;
  QImage image;  ///< of a press or of the finger out of contact; null: none

  [[nodiscard]] bool operator==(const FingerCard&) const = default;
};

/// Reads a folder, on any thread; nullopt where no finger can be opened there.
///   now: UTC, as utc_now() writes it
[[nodiscard]] std::optional<FingerCard> read_finger_card(const std::filesystem::path& folder,
                                                         const std::string& now);

// The summary of a finger as text in the window's language.

/// "Good, ±0.035 mm", "Broken", "Not calibrated yet"; kGood only where nothing is due.
[[nodiscard]] Headline headline_of(const FingerCard& card);
/// The date in the local time zone and format; empty for no date.
[[nodiscard]] QString local_day(const std::string& utc);
/// "today", "yesterday", "3 days ago", by local days; empty for no date.
[[nodiscard]] QString age_in_days(const std::string& utc, const std::string& now);
/// Dates of calibration and check; empty for never.
[[nodiscard]] QString dates_of(const FingerCard& card);
[[nodiscard]] QString due_text(const FingerCard& card);
/// Contradictions and missing requirements of the calibration, one sentence a line; empty: none.
[[nodiscard]] QString findings_text(const FingerCard& card);
/// One line: grade, expected error, ages of calibration and check, error in the check, what is due.
[[nodiscard]] QString summary_of(const FingerCard& card, const std::string& now);

// Recently used fingers, a card each: image, name, grade of the calibration, dates of calibration
// and check, and what is due.

class FingerCards : public Translated<QWidget> {
  Q_OBJECT
 public:
  static constexpr std::size_t kMaxCards = 6;

  explicit FingerCards(QWidget* parent = nullptr);
  /// Latest first; read on a background thread. Missing or unreadable folders, and all after
  /// kMaxCards, are left out; hidden where none is left.
  void set_fingers(const std::vector<std::filesystem::path>& folders);
  [[nodiscard]] const std::vector<FingerCard>& cards() const { return cards_; }

 Q_SIGNALS:
  void finger_chosen(const QString& folder);
  /// The folder stays; it only leaves the list.
  void removal_requested(const std::filesystem::path& folder);
  /// The folders, also after kMaxCards, with a finger that can be opened.
  void found(const std::vector<std::filesystem::path>& folders);
  /// cards() are shown.
  void filled();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void read();
  void rebuild();
  void fit();
  [[nodiscard]] QToolButton* make_button(const FingerCard& card);

  std::vector<std::filesystem::path> folders_;
  std::vector<FingerCard> cards_;
  QGridLayout* grid_;
  BackgroundWork reading_;
};

// All fingers of the lab in one list: grade, dates of calibration and check, and what is due.

/// The fingers in `known` and all others in the same parent folders.
[[nodiscard]] std::vector<FingerCard> read_all_fingers(
    const std::set<std::filesystem::path>& folders, const std::vector<std::filesystem::path>& known,
    const std::string& now, const Job& job);

class FingerListDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// known: fingers' folders; read on a background thread.
  explicit FingerListDialog(std::vector<std::filesystem::path> known, QWidget* parent = nullptr);
  [[nodiscard]] const std::vector<FingerCard>& cards() const { return cards_; }

 Q_SIGNALS:
  void finger_chosen(const QString& folder);
  /// Folders of the selected fingers, in the order of the list.
  void gage_requested(const std::vector<std::filesystem::path>& folders);

 private:
  void read();
  void fill();
  void open_chosen();
  [[nodiscard]] std::vector<std::filesystem::path> selected() const;
  void follow_choice();

  std::vector<std::filesystem::path> known_;
  std::set<std::filesystem::path> folders_;  // to search
  std::vector<FingerCard> cards_;            // most urgent first
  RowList* list_;
  QLabel* count_;
  QPushButton *open_, *folder_, *gage_;
  QDialogButtonBox* buttons_;
  BackgroundWork reading_;
};

}  // namespace alltact
