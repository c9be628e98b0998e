#include "widgets/shell/picture_dialog.h"

#include <QPainter>

namespace alltact {

PictureDialog::PictureDialog(QImage picture, QWidget* parent)
    : QDialog(parent), picture_(std::move(picture)) {}

// As large as the picture, as far as the window it belongs to goes.
QSize PictureDialog::sizeHint() const {
  const QSize most =
      parentWidget() != nullptr ? parentWidget()->window()->size() : QSize(1000, 700);
  return picture_.width() > most.width() || picture_.height() > most.height()
             ? picture_.size().scaled(most, Qt::KeepAspectRatio)
             : picture_.size();
}

void PictureDialog::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QRect place({}, picture_.size().scaled(size(), Qt::KeepAspectRatio));
  place.moveCenter(rect().center());
  painter.drawImage(place, picture_);
}

}  // namespace alltact
