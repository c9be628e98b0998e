// Makes the space bar act as a foot pedal: it takes the next press wherever the focus is in the
// window.
#pragma once

#include <QObject>
#include <QWidget>
#include <functional>

namespace alltact {

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
