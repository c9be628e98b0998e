#include "widgets/copy_figure.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QToolTip>
#include <utility>

namespace alltact {

CopyFigure::CopyFigure(QWidget& widget, std::function<QImage()> image, Menu menu)
    : QObject(&widget), widget_(widget), image_(std::move(image)), menu_(menu) {
  widget_.installEventFilter(this);
}

void CopyFigure::copy() {
  const QImage image = image_();
  if (image.isNull()) return;
  QGuiApplication::clipboard()->setImage(image);
  const QLocale locale;
  QToolTip::showText(
      widget_.mapToGlobal(widget_.rect().center()),
      tr("Copied: %1 × %2 px").arg(locale.toString(image.width()), locale.toString(image.height())),
      &widget_);
}

void CopyFigure::open_menu(const QPoint& at) {
  auto* menu = new QMenu(&widget_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  // The key is only shown: the event filter handles it.
  const QAction* entry =
      menu->addAction(tr("&Copy the figure") + QLatin1Char('\t') +
                      QKeySequence(QKeySequence::Copy).toString(QKeySequence::NativeText));
  connect(entry, &QAction::triggered, this, &CopyFigure::copy);
  menu->popup(at);
}

bool CopyFigure::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    copy();
    return true;
  }
  if (event->type() == QEvent::ContextMenu) {
    const auto* request = static_cast<QContextMenuEvent*>(event);
    const bool is_by_mouse = request->reason() == QContextMenuEvent::Mouse;
    if (!is_by_mouse || menu_ == Menu::kByMouseToo)
      open_menu(is_by_mouse ? request->globalPos() : widget_.mapToGlobal(widget_.rect().center()));
    return true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace alltact
