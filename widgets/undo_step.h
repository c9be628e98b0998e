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

// An undoable change of one value.

/// Holds the values before and after, never a pointer to their owner. Consecutive changes with the
/// same `merge_id` (>= 0) are one step.
template <class T>
class ValueChange : public UndoStep {
 public:
  using Apply = std::function<void(const T&)>;

  ValueChange(StepWords words, T before, T after, Apply apply, int merge_id = -1)
      : UndoStep(std::move(words)),
        before_(std::move(before)),
        after_(std::move(after)),
        apply_(std::move(apply)),
        merge_id_(merge_id) {}

  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }
  [[nodiscard]] int id() const override { return merge_id_; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto* same = dynamic_cast<const ValueChange*>(next);
    if (same == nullptr) return false;
    after_ = same->after_;
    setObsolete(before_ == after_);
    return true;
  }

 private:
  T before_, after_;
  Apply apply_;
  int merge_id_;
};

}  // namespace alltact
