// What is wrong now, in words, with what to do about it; nothing when all is well.
#pragma once

#include "core/result.h"
#include "widgets/theme.h"
#include "widgets/translated.h"

#include <QFrame>
#include <QVBoxLayout>
#include <optional>
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

/// Rows of symbol, word and sentences; each takes the keyboard's focus so that it can be read out,
/// and new ones are announced.
class ProblemList : public Translated<QFrame> {
  Q_OBJECT
 public:
  explicit ProblemList(QWidget* parent = nullptr);
  void set_problems(std::vector<Problem> problems);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void word_anew();
  [[nodiscard]] QWidget* make_row(const Problem& problem);

  std::vector<Problem> problems_;
  QVBoxLayout* rows_;
};

}  // namespace alltact
