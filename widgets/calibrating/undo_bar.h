// The last change taken back with one click, and made again with another: what is shown before and
// after it can be compared.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/translated.h"

#include <QToolButton>
#include <QUndoStack>

namespace alltact {

/// Says what it would take back. While a recording runs it takes back nothing: a step may open
/// another source.
class UndoBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  UndoBar(QUndoStack& undo, const LiveSession& session, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();
  void set_icons();

  QUndoStack& stack_;
  const LiveSession& session_;
  QToolButton *undo_, *redo_;
};

}  // namespace alltact
