// The live image with zoom buttons, the readout of the probe, a freeze button and a save button.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/panels/view_options.h"
#include "widgets/shell/elided_label.h"
#include "widgets/translated.h"

#include <QBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <functional>

namespace alltact {

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

}  // namespace alltact
