#include "widgets/shell/elided_label.h"

#include <QPainter>
#include <algorithm>

namespace alltact {

ElidedLabel::ElidedLabel(Qt::TextElideMode cut, QWidget* parent)
    : QLabel(parent), elide_mode_(cut) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ElidedLabel::set_text(const QString& text, int bold) {
  bold_ = bold;
  setText(text);
  setToolTip(text);
  updateGeometry();
}

QFont ElidedLabel::bold_font() const {
  QFont heavy = font();
  heavy.setBold(true);
  return heavy;
}

int ElidedLabel::full_width() const {
  return QFontMetrics(bold_font()).horizontalAdvance(text().left(bold_)) +
         fontMetrics().horizontalAdvance(text().mid(bold_));
}

bool ElidedLabel::is_elided() const {
  return full_width() > contentsRect().width();
}

QSize ElidedLabel::minimumSizeHint() const {
  return {1, fontMetrics().height()};
}

QSize ElidedLabel::sizeHint() const {
  return {full_width() + 1, fontMetrics().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(
      palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
  QRect room = contentsRect();
  const QString head = text().left(bold_);
  if (!head.isEmpty()) {
    painter.setFont(bold_font());
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, head);
    room.setLeft(room.left() + QFontMetrics(bold_font()).horizontalAdvance(head));
    painter.setFont(font());
  }
  painter.drawText(
      room,
      static_cast<int>(alignment() & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter,
      fontMetrics().elidedText(text().mid(bold_), elide_mode_, std::max(0, room.width())));
}

QString elided_path(const QString& path, const QFontMetrics& metrics, int room) {
  return metrics.elidedText(path, Qt::ElideLeft, room);
}

}  // namespace alltact
