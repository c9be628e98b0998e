#include "widgets/shell/image_dialog.h"

#include <QPainter>

namespace alltact {

ImageDialog::ImageDialog(QImage image, QWidget* parent)
    : QDialog(parent), image_(std::move(image)) {}

// The image's size, but no larger than the parent window.
QSize ImageDialog::sizeHint() const {
  const QSize max_size =
      parentWidget() != nullptr ? parentWidget()->window()->size() : QSize(1000, 700);
  return image_.width() > max_size.width() || image_.height() > max_size.height()
             ? image_.size().scaled(max_size, Qt::KeepAspectRatio)
             : image_.size();
}

void ImageDialog::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QRect target({}, image_.size().scaled(size(), Qt::KeepAspectRatio));
  target.moveCenter(rect().center());
  painter.drawImage(target, image_);
}

}  // namespace alltact
