// Steps that can be undone, with names that follow the language.
#pragma once

#include <QString>
#include <QUndoStack>
#include <functional>
#include <utility>

namespace alltact {

/// A step's name. Called whenever the name is shown, so that it follows the language.
using StepWords = std::function<QString()>;

class UndoStep : public QUndoCommand {
 public:
  explicit UndoStep(StepWords words) : QUndoCommand(words()), words_(std::move(words)) {}
  [[nodiscard]] QString words() const { return words_(); }

 private:
  StepWords words_;
};

/// The name of the step that undo or redo runs next; empty where there is none.
[[nodiscard]] inline QString words_of(const QUndoCommand* step) {
  if (step == nullptr) return {};
  const auto* undo_step = dynamic_cast<const UndoStep*>(step);
  return undo_step != nullptr ? undo_step->words() : step->text();
}
[[nodiscard]] inline QString undo_words(const QUndoStack& stack) {
  return words_of(stack.command(stack.index() - 1));
}
[[nodiscard]] inline QString redo_words(const QUndoStack& stack) {
  return words_of(stack.command(stack.index()));
}

}  // namespace alltact
