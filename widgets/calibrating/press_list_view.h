// A list of presses that marks the chosen one whether it has the focus or not, and chooses none
// only because the focus came by.
#pragma once

#include "widgets/calibrating/shown_press.h"

#include <QFocusEvent>
#include <QListView>

namespace alltact {

class PressListView : public QListView {
  Q_OBJECT
 public:
  explicit PressListView(QWidget* parent = nullptr);

 protected:
  void focusInEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void mark_always();
};

}  // namespace alltact
