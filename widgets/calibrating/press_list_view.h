// A list of presses that highlights the current press with or without focus. Focus alone selects no
// press.
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
