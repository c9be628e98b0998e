// The live image with zoom buttons, the readout of the probe, a freeze button and a save button.
#pragma once

#include "calibration/live/live_finger.h"
#include "widgets/image/image_view.h"
#include "widgets/live/live_session.h"
#include "widgets/widget_base.h"

#include <QBoxLayout>
#include <QLabel>
#include <QString>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <functional>
#include <vector>

namespace alltact {

// Overlays of the live image, and the readout of a pixel.

struct ViewOptions {
  bool edges = true, markers = true, direction = true, depth = true, faults = true, focus = false;
  double depth_top_mm = 1.0;  ///< end of the depth colour scale, [0.1, 10]
  bool operator==(const ViewOptions&) const = default;
};

[[nodiscard]] std::vector<Overlay> overlays_for(const LiveView& view, const ViewOptions& options);

/// "u 120 px, v 44 px, grey 131, depth 0.42 mm"; the reason where there is no depth.
[[nodiscard]] QString readout_text(const LiveView& view, QPoint pixel);

class ImagePanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit ImagePanel(LiveSession& session, QWidget* parent = nullptr);

  void set_options(const ViewOptions& options);
  /// Shows this instead of the session's newest view; null: the newest again.
  void show_instead(std::shared_ptr<const LiveView> view);
  /// Title above the image, for one of several next to each other: the readout then has a line of
  /// its own. Empty: none.
  void set_title(const QString& title);
  /// Further overlays of a page; called for every view.
  using ExtraOverlays = std::function<std::vector<Overlay>(const LiveView& view)>;
  void set_extra_overlays(ExtraOverlays extra);
  /// Something was captured: the image's border lights up for a moment, with these words.
  void flash(const QString& words);
  [[nodiscard]] bool is_frozen() const { return frozen_ != nullptr; }
  /// Holds the current view until it is released. Does nothing without an image.
  void freeze(bool is_frozen);
  [[nodiscard]] ImageView& view() { return *view_; }

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void show_frame();
  void show_state();
  void show_readout();
  void show_zoom();
  void set_icons();
  void save_snapshot();
  [[nodiscard]] std::vector<Overlay> overlays() const;
  [[nodiscard]] QString message() const;
  [[nodiscard]] const std::shared_ptr<const LiveView>& live() const;

  LiveSession& session_;
  ViewOptions options_;
  std::shared_ptr<const LiveView> instead_, frozen_;
  ExtraOverlays extra_overlays_;
  QString flash_words_;
  QTimer flash_;
  QVBoxLayout* column_;
  QHBoxLayout* strip_;
  QLabel* title_;
  ImageView* view_;
  ElidedLabel* readout_;  // long texts do not widen the window
  QLabel* zoom_;
  QToolButton *freeze_, *snapshot_, *zoom_in_, *zoom_out_, *fit_, *actual_;
};

// Saves an image of the current view to a chosen file.

/// Opens a file dialog without blocking the window, and saves the image of this moment: with the
/// overlays or, by another filter, as the camera gave it. A dialog reports a failure to write.
void choose_snapshot(const cv::Mat& grey, const std::vector<Overlay>& overlays, QWidget& parent);

}  // namespace alltact
