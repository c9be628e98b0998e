// Steps that can be undone and say what they are called anew in each language.
#pragma once

#include <QString>
#include <QUndoStack>
#include <functional>
#include <utility>

namespace alltact {

/// What a step is called. Asked again whenever it is shown, so that it follows the language.
using StepWords = std::function<QString()>;

class UndoStep : public QUndoCommand {
 public:
  explicit UndoStep(StepWords words) : QUndoCommand(words()), words_(std::move(words)) {}
  [[nodiscard]] QString words() const { return words_(); }

 private:
  StepWords words_;
};

/// Of the step that undo or redo would do next; empty where there is none.
[[nodiscard]] inline QString words_of(const QUndoCommand* step) {
  if (step == nullptr) return {};
  const auto* said = dynamic_cast<const UndoStep*>(step);
  return said != nullptr ? said->words() : step->text();
}
[[nodiscard]] inline QString undo_words(const QUndoStack& stack) {
  return words_of(stack.command(stack.index() - 1));
}
[[nodiscard]] inline QString redo_words(const QUndoStack& stack) {
  return words_of(stack.command(stack.index()));
}

}  // namespace alltact
