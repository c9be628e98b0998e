// Steps in a row, each with number, name and state; a step that is not open yet shows why.
#pragma once

#include "widgets/translated.h"

#include <QString>
#include <QToolButton>
#include <vector>

namespace alltact {

enum class StepState {
  kToDo = 1,
  kDone,
  kOutdated,  ///< done, but something has changed since
  kReading,   ///< not known yet: the finger is being read
};

struct Step {
  QString title;
  StepState state = StepState::kToDo;
  bool is_open = true;  ///< the user can go to it
  QString why_not;      ///< shown where it is not open
};

class StepList : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit StepList(QWidget* parent = nullptr);

  /// Always the same number of steps. `current` is marked.
  void show_steps(const std::vector<Step>& steps, std::size_t current);

 Q_SIGNALS:
  void chosen(std::size_t step);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_buttons(std::size_t count);
  void apply_style();
  [[nodiscard]] QString title(std::size_t step) const;
  /// In one line where all have the room, else in two.
  void fit();
  std::vector<Step> steps_;
  std::vector<QToolButton*> buttons_;
};

}  // namespace alltact
