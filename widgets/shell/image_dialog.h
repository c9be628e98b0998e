// An image in a window of its own, as large as the window allows.
#pragma once

#include <QDialog>
#include <QImage>

namespace alltact {

class ImageDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ImageDialog(QImage image, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage image_;
};

}  // namespace alltact
