// A picture in a window of its own, as large as the window lets it be.
#pragma once

#include <QDialog>
#include <QImage>

namespace alltact {

class PictureDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PictureDialog(QImage picture, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;
};

}  // namespace alltact
