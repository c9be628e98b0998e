// The live picture with its zoom buttons and what lies under the probe.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/panels/view_options.h"
#include "widgets/translated.h"

#include <QBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

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
  [[nodiscard]] QString message() const;
  [[nodiscard]] const std::shared_ptr<const LiveView>& live() const;

  LiveSession& session_;
  ViewOptions options_;
  std::shared_ptr<const LiveView> instead_;
  QVBoxLayout* column_;
  QHBoxLayout* strip_;
  QLabel* title_;
  ImageView* view_;
  QLabel* readout_;
  QLabel* zoom_;
  QToolButton *closer_, *further_, *fit_, *actual_;
};

}  // namespace alltact
