// An undoable change of one value.
#pragma once

#include "widgets/undo_step.h"

namespace alltact {

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
