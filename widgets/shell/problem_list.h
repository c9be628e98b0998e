// What is wrong now, in words, with what to do about it; nothing when all is well.
#pragma once

#include "core/result.h"
#include "widgets/shell/one_line.h"
#include "widgets/theme.h"
#include "widgets/translated.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <optional>
#include <utility>
#include <vector>

namespace alltact {

struct Problem {
  Meaning meaning = Meaning::kBad;
  QString what;    ///< a sentence
  QString advice;  ///< a sentence; may be empty
  /// A button beside it; empty for none.
  QString action;
  std::function<void()> on_action = {};
  /// What a library said, from which `what` and `advice` are worded in the window's language.
  std::optional<Error> told = {};

  /// A library's error in place: where it is, what is wrong, what to try. Of a warning or a remark,
  /// which is a sentence alone, it is Error{sentence, "", ""}.
  [[nodiscard]] static Problem of(const Error& error, Meaning meaning = Meaning::kBad);
  [[nodiscard]] bool says_the_same(const Problem& other) const;
};

/// One line: the newest of them with its age, folded over the others; it unfolds to all, each with
/// its sentences whole. What is dismissed stays away until it has ended and begins anew. Each takes
/// the keyboard's focus so that it can be read out, and new ones are announced.
class ProblemList : public Translated<QFrame> {
  Q_OBJECT
 public:
  explicit ProblemList(QWidget* parent = nullptr);
  void set_problems(std::vector<Problem> problems);
  /// Newest first, without those that were dismissed.
  [[nodiscard]] std::vector<Problem> problems() const;
  [[nodiscard]] bool is_unfolded() const { return is_unfolded_; }

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Noted {
    Problem problem;
    qint64 since_ms = 0;  ///< of the monotonic clock
    bool is_dismissed = false;
  };
  void rebuild();
  void word_anew();
  void tell_ages();
  void show_fold();
  void dismiss(const QString& what);
  [[nodiscard]] std::vector<const Noted*> shown() const;
  [[nodiscard]] QWidget* make_row(const Noted& noted, bool is_first);
  void add_buttons(const Noted& noted, bool is_first, QHBoxLayout& layout);
  [[nodiscard]] QString age_text(qint64 since_ms) const;

  std::vector<Noted> noted_;  // newest first
  QVBoxLayout* rows_;
  QTimer clock_;
  bool is_unfolded_ = false;
  std::vector<std::pair<QLabel*, qint64>> ages_;  // of the rows that are shown
  OneLine* line_ = nullptr;                       // of the first row, folded
  QToolButton* fold_ = nullptr;
};

}  // namespace alltact
