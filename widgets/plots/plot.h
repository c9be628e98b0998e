// Base of all plots: theme, empty state, images without a screen.
#pragma once

#include <QImage>
#include <QWidget>
#include <utility>
#include <vector>

class QCPAxis;
class QCPTextElement;
class QCustomPlot;

namespace alltact {

/// A self-contained plot: it takes plain values, reads no files, follows the palette and the font
/// of its widget, and can be drawn without being shown. Shown or copied it has its title above,
/// where there is room; an image or a file has none, for documents write their own.
class Plot : public QWidget {
  Q_OBJECT
 public:
  explicit Plot(QWidget* parent = nullptr);
  ~Plot() override;

  /// The plot in `size` (px at scale 1), with `scale` times as many pixels along each side.
  [[nodiscard]] QImage image(const QSize& size, double scale = 1.0);
  /// One page of `size` (px at 96 to the inch) with vector lines and text. False: not writable.
  [[nodiscard]] bool save_pdf(const QString& file, const QSize& size);
  /// The same as an SVG file.
  [[nodiscard]] bool save_svg(const QString& file, const QSize& size);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  /// Above the shown plot, and its accessible name: by default that which was set.
  [[nodiscard]] virtual QString title() const { return accessibleName(); }
  /// False: there is no room for the title.
  [[nodiscard]] virtual bool shows_title() const { return true; }
  /// Draws the data into chart(), which is empty and has the theme's style. False: there is nothing
  /// to draw. Called again whenever data or palette change.
  virtual bool draw() = 0;
  /// Called when the size changes or is first known, for what depends on the room between the axes.
  virtual void fit(const QSize& /*size*/) {}
  /// Shown in the middle where draw() has nothing.
  [[nodiscard]] virtual QString empty_text() const = 0;
  /// Call it when the data changed. A hidden plot is drawn when it is shown.
  void rebuild();

  [[nodiscard]] QCustomPlot& chart() const { return *chart_; }
  /// Adds an axis from draw() with the style of the chart's own; its title is wrapped like the
  /// others.
  void add_axis(QCPAxis* axis);
  /// Small text inside the plot, on the base colour.
  void add_note(double x, double y, const QString& text, Qt::Alignment anchor);
  /// Adds the legend above the plot, where it covers no data; call last.
  void show_legend();

 private:
  void draw_now(const QSize& size, bool is_titled);
  void set_title(const QString& title);
  [[nodiscard]] QImage figure();
  void apply_style();
  void style_axis(QCPAxis* axis) const;
  /// Wraps the titles of axes and the legend to the size; drops the title where it is too low.
  void fit_text(const QSize& size);
  void wrap_legend(const QSize& size);
  QCustomPlot* chart_;
  QCPTextElement* title_;
  QString title_text_;                                ///< empty: none
  std::vector<std::pair<QCPAxis*, QString>> titles_;  ///< of axes, each in one line
  bool is_stale_ = true;
};

}  // namespace alltact
