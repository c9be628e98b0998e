// Base class of the pages of a calibration, one a step.
#pragma once

#include "widgets/shell/dropped_files.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <QObject>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <functional>
#include <vector>

namespace alltact {

// Steps in a row, each with number, name and state; a step that is not open yet shows why.

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

class StepPage : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit StepPage(QWidget* parent = nullptr) : Translated(parent) {}
  /// As Page::take_files().
  [[nodiscard]] virtual bool take_files(const DroppedFiles& /*dropped*/) { return false; }
  /// What the step could not do, for the window's notification bar.
  [[nodiscard]] std::vector<Problem> problems() const;
  [[nodiscard]] virtual QString title() const = 0;
  [[nodiscard]] virtual StepState state() const = 0;
  /// What must be done before the next step; empty: nothing.
  [[nodiscard]] virtual QString missing() const = 0;
  /// Called by a foot pedal; same action as the space bar.
  virtual void press_pedal() {}
  /// Column for the buttons Undo and Next, next to the image. Null: they are below the page.
  [[nodiscard]] virtual QVBoxLayout* foot() const { return nullptr; }
  /// Most likely used control; gets the focus when the step is opened.
  [[nodiscard]] virtual QWidget* main_control() const = 0;

  /// Button of the next action on this page; null: none, or none now.
  [[nodiscard]] virtual const QPushButton* action_button() const {
    return qobject_cast<const QPushButton*>(main_control());
  }

 Q_SIGNALS:
  /// state() or missing() may have changed.
  void changed();
  /// problems() may have changed.
  void problems_changed();
  /// The control with the focus is gone: the focus belongs to what comes next.
  void focus_released();

 protected:
  void set_problems(std::vector<Problem> problems);

 private:
  std::vector<Problem> problems_;
};

// Makes the space bar act as a foot pedal: it takes the next press wherever the focus is in the
// window.

/// While `page` is visible, Space calls `act`. Exceptions are text fields and controls that were
/// focused by keys: there Space has its own function. A button focused by a mouse click and a
/// number field are no exceptions.
class SpaceKey : public QObject {
  Q_OBJECT
 public:
  SpaceKey(QWidget& page, std::function<void()> act);

 protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

 private:
  [[nodiscard]] bool handles_space(const QWidget& widget) const;
  QWidget& page_;
  std::function<void()> act_;
  const QObject* clicked_ = nullptr;  // widget focused by a mouse click; only compared with
};

}  // namespace alltact
