// Copies plots and images, each as an image with its colour bar, to the clipboard.
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QObject>
#include <functional>

class QPoint;
class QWidget;

namespace alltact {

/// Ctrl+C copies the widget's figure while it has the focus, and so does the entry of its context
/// menu. `image` returns a null image while there is none.
class CopyFigure : public QObject {
  Q_DECLARE_TR_FUNCTIONS(alltact::CopyFigure)
 public:
  /// The key Menu always opens the menu; with kByKeysOnly the right mouse button does not, because
  /// it does something else in the widget.
  enum class Menu { kByMouseToo = 1, kByKeysOnly };
  /// Owned by `widget`.
  CopyFigure(QWidget& widget, std::function<QImage()> image, Menu menu = Menu::kByMouseToo);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void copy();
  void open_menu(const QPoint& at);

  QWidget& widget_;
  std::function<QImage()> image_;
  Menu menu_;
};

}  // namespace alltact
