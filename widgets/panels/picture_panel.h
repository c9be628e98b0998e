// The live picture with its zoom buttons, what lies under the probe, a button that freezes it and
// one that saves it.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/panels/view_options.h"
#include "widgets/shell/one_line.h"
#include "widgets/translated.h"

#include <QBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <functional>

namespace alltact {

class PicturePanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit PicturePanel(LiveSession& session, QWidget* parent = nullptr);

  void set_options(const ViewOptions& options);
  /// Shows this instead of the session's newest view; null: the newest again.
  void show_instead(std::shared_ptr<const LiveView> view);
  /// Above the picture, of one of several that share the room: what stands under the probe then has
  /// a line of its own. Empty: none.
  void set_title(const QString& title);
  /// What a place draws over the picture besides, asked for with every view.
  using More = std::function<std::vector<Overlay>(const LiveView& view)>;
  void set_more(More more);
  /// Something was taken from the picture: its border lights up for a moment, with these words.
  void flash(const QString& words);
  [[nodiscard]] bool is_frozen() const { return frozen_ != nullptr; }
  /// Shows what is shown now until it is let go. Nothing where there is no picture.
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
  More more_;
  QString flash_words_;
  QTimer flash_;
  QVBoxLayout* column_;
  QHBoxLayout* strip_;
  QLabel* title_;
  ImageView* view_;
  OneLine* readout_;  // long texts do not widen the window
  QLabel* zoom_;
  QToolButton *freeze_, *snapshot_, *closer_, *further_, *fit_, *actual_;
};

}  // namespace alltact
