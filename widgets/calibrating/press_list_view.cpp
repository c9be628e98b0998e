#include "widgets/calibrating/press_list_view.h"

#include <QSignalBlocker>

namespace alltact {

PressListView::PressListView(QWidget* parent) : QListView(parent) {
  setWordWrap(true);
  setIconSize(PressThumbnails::size());
  setSpacing(2);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  mark_always();
}

void PressListView::focusInEvent(QFocusEvent* event) {
  // Qt makes the first row the current one where none is.
  const bool is_by_keys = !currentIndex().isValid() && event->reason() != Qt::MouseFocusReason;
  if (!is_by_keys || selectionModel() == nullptr) return QListView::focusInEvent(event);
  const QSignalBlocker quiet(selectionModel());
  QListView::focusInEvent(event);
  selectionModel()->clear();
}

void PressListView::changeEvent(QEvent* event) {
  QListView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) mark_always();
}

void PressListView::mark_always() {
  QPalette marks;  // only the changed roles
  bool is_other = false;
  for (const auto role : {QPalette::Highlight, QPalette::HighlightedText}) {
    const QColor active = palette().color(QPalette::Active, role);
    is_other = is_other || palette().color(QPalette::Inactive, role) != active;
    marks.setColor(QPalette::Inactive, role, active);
  }
  if (is_other) setPalette(marks);
}

}  // namespace alltact
