// A grey image with overlays: zoom down to a pixel, pan, and a probe that reports the pixel under
// it.
#pragma once

#include "widgets/copy_figure.h"
#include "widgets/widget_base.h"

#include <QDialog>
#include <QImage>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QSizeF>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Transform between an image's pixels and a widget.

/// Image coordinates have the centre of the top-left pixel at (0, 0), so that the image covers
/// [-0.5, width - 0.5] by [-0.5, height - 0.5]; widget coordinates are Qt's logical pixels.
///   widget = (image + 0.5) * scale + offset
struct ImageTransform {
  double scale = 1;  ///< logical pixels per image pixel, > 0
  QPointF offset;    ///< of the top-left pixel's outer corner

  [[nodiscard]] QPointF to_widget(QPointF image) const {
    return (image + QPointF(0.5, 0.5)) * scale + offset;
  }
  [[nodiscard]] QPointF to_image(QPointF widget) const {
    return (widget - offset) / scale - QPointF(0.5, 0.5);
  }
  /// The area of the full image in the widget.
  [[nodiscard]] QRectF covered(QSize image) const { return {offset, QSizeF(image) * scale}; }

  /// The full image as large as it fits, centred.
  [[nodiscard]] static ImageTransform fit(QSize image, QSizeF widget);
  /// The same with another scale; the image point under `fixed` does not move.
  [[nodiscard]] ImageTransform zoomed(double new_scale, QPointF fixed) const;
  /// Moved as little as needed: an image larger than the widget leaves no gap at its sides, a
  /// smaller one is centred.
  [[nodiscard]] ImageTransform clamped_to(QSize image, QSizeF widget) const;
};

/// Draws over the image, in widget coordinates.
using Overlay = std::function<void(QPainter& painter, const ImageTransform& transform)>;

/// Mouse: wheel zooms about the pointer, dragging pans, double click fits. Keys: + and - zoom, 0
/// fits, 1 shows an image pixel as a screen pixel, arrows pan. Shift and arrows move the probe by a
/// pixel, Escape removes it. Ctrl+C copies the image with its overlays.
class ImageView : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// `copy_menu`: how its context menu opens.
  explicit ImageView(QWidget* parent = nullptr,
                     CopyFigure::Menu copy_menu = CopyFigure::Menu::kByMouseToo);

  /// CV_8UC1, shared and not copied. The zoom stays as long as the size does.
  void show_image(const cv::Mat& grey, std::vector<Overlay> overlays);
  /// Removes the image and shows the reason.
  void show_message(const QString& message);

  [[nodiscard]] const ImageTransform& transform() const { return transform_; }
  [[nodiscard]] bool is_fitted() const { return is_fitted_; }
  [[nodiscard]] const cv::Mat& image() const { return grey_; }
  /// The reported pixel; nullopt where there is none.
  [[nodiscard]] std::optional<QPoint> probe() const;

  void fit();
  void show_actual_size();
  void zoom_by(double factor);

  [[nodiscard]] QSize sizeHint() const override { return {800, 450}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 135}; }

 Q_SIGNALS:
  /// The probe moved, or the image under it may have changed.
  void probe_changed();
  void zoom_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QSize image_size() const { return {grey_.cols, grey_.rows}; }
  void set_transform(const ImageTransform& transform, bool is_fitted);
  void zoom_to(double scale, QPointF fixed);
  void pan(QPointF by);
  void move_probe(QPoint by);
  void paint_probe(QPainter& painter) const;

  cv::Mat grey_;
  std::vector<Overlay> overlays_;
  QString message_;
  ImageTransform transform_;
  bool is_fitted_ = true;
  std::optional<QPointF> dragged_from_;
  std::optional<QPoint> hovered_;  // pixel under the pointer
  std::optional<QPoint> pinned_;   // pixel that the keys selected
};

// Grey images as Qt draws them.

/// `grey` (CV_8UC1) in its own size, with the overlays.
[[nodiscard]] QImage image_with_overlays(const cv::Mat& grey, const std::vector<Overlay>& overlays);

/// Shares the pixels (CV_8UC1); valid while `grey` lives.
[[nodiscard]] inline QImage grey_image(const cv::Mat& grey) {
  return {grey.data, grey.cols, grey.rows, static_cast<qsizetype>(grey.step),
          QImage::Format_Grayscale8};
}

// An image in a window of its own, as large as the window allows.

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
