// The space bar as a foot pedal has it: wherever the focus is in the window it takes the next
// press.
#pragma once

#include <QObject>
#include <QWidget>
#include <functional>

namespace alltact {

/// While `page` is shown, Space calls `act`, wherever the focus is in the window, but for where it
/// writes words or works a control that was gone to by keys: there it does what it does everywhere.
/// A button that a mouse clicked has been used, and it never types into fields of numbers.
class SpaceKey : public QObject {
  Q_OBJECT
 public:
  SpaceKey(QWidget& page, std::function<void()> act);

 protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

 private:
  [[nodiscard]] bool is_needed_by(const QWidget& widget) const;
  QWidget& page_;
  std::function<void()> act_;
  const QObject* by_mouse_ = nullptr;  // what a click gave the focus; only compared with
};

}  // namespace alltact
