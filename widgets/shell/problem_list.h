// Current problems as text, with advice.
#pragma once

#include "core/base/result.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

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
  QString what;         ///< a sentence
  QString advice = {};  ///< a sentence; may be empty
  /// Label of a button; empty for none.
  QString action = {};
  std::function<void()> on_action = {};
  /// The library's error; `what` and `advice` are its translation into the window's language.
  std::optional<Error> cause = {};

  /// A library's error with location, cause and advice. A warning or a remark, which is one
  /// sentence, is Error{sentence, "", ""}.
  [[nodiscard]] static Problem of(const Error& error, Meaning meaning = Meaning::kBad);
  [[nodiscard]] bool has_same_text(const Problem& other) const;
};

/// Folded it shows the newest problem with its age in one line; unfolded it shows all, in full
/// sentences, over what is below it. It takes the room of one line also without problems, so that
/// nothing moves when one comes or goes. A dismissed problem stays away until it has ended and
/// begins again. Each takes the keyboard's focus so that it can be read out, and new ones are
/// announced.
class ProblemList : public Translated<QFrame> {
  Q_OBJECT
 public:
  explicit ProblemList(QWidget* parent = nullptr);
  void set_problems(std::vector<Problem> problems);
  /// Newest first, without the dismissed ones.
  [[nodiscard]] std::vector<Problem> problems() const;
  [[nodiscard]] bool is_unfolded() const { return is_unfolded_; }
  /// Without the fold: always all problems in full, in the list's own room. For dialogs.
  void show_in_full();

 Q_SIGNALS:
  void filled(bool is_any);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct ListedProblem {
    Problem problem;
    qint64 since_ms = 0;  ///< of the monotonic clock
    bool is_dismissed = false;
  };
  void rebuild();
  void retranslate();
  void show_ages();
  void show_fold();
  /// In the list's room, or over the window's content.
  void arrange_sheet();
  void dismiss(const QString& what);
  [[nodiscard]] std::vector<const ListedProblem*> shown() const;
  [[nodiscard]] QWidget* make_row(const ListedProblem& listed, bool is_first);
  void add_buttons(const ListedProblem& listed, bool is_first, QHBoxLayout& layout);
  [[nodiscard]] QString age_text(qint64 since_ms) const;

  std::vector<ListedProblem> listed_;  // newest first
  QWidget* sheet_;                     // holds the rows
  QVBoxLayout* rows_;
  QTimer clock_;
  bool is_unfolded_ = false, is_in_full_ = false;
  std::vector<std::pair<QLabel*, qint64>> ages_;  // of the shown rows
  ElidedLabel* line_ = nullptr;                   // of the first row, folded
  QToolButton* fold_ = nullptr;
};

}  // namespace alltact
