// What all plots have in common: theme, empty state, pictures without a screen.
#pragma once

#include <QImage>
#include <QWidget>
#include <utility>
#include <vector>

class QCPAxis;
class QCustomPlot;

namespace alltact {

/// A plot that stands alone: it is given plain values, knows no files, follows the palette and the
/// font of its widget, and can be drawn without being shown.
class Plot : public QWidget {
  Q_OBJECT
 public:
  explicit Plot(QWidget* parent = nullptr);
  ~Plot() override;

  /// The plot in `size` (px at scale 1), with `scale` times as many pixels each way.
  [[nodiscard]] QImage picture(const QSize& size, double scale = 1.0);
  /// One page of `size` (px at 96 to the inch), lines and letters as such. False: not writable.
  [[nodiscard]] bool save_pdf(const QString& file, const QSize& size);
  /// The same as a drawing for papers and pages.
  [[nodiscard]] bool save_svg(const QString& file, const QSize& size);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  /// Draws what was given into chart(), which is empty and dressed; false when there is nothing to
  /// draw. Called again whenever data or palette change.
  virtual bool draw() = 0;
  /// The size has changed, or is known first: for what depends on the room between the axes.
  virtual void fit(const QSize& /*size*/) {}
  /// Stands in the middle where draw() has nothing.
  [[nodiscard]] virtual QString empty_text() const = 0;
  /// To be called when the data changed. What nobody sees is drawn when it is shown.
  void rebuild();

  [[nodiscard]] QCustomPlot& chart() const { return *chart_; }
  /// Another axis than the chart's own, from draw(): dressed as they are, its title broken as
  /// theirs.
  void add_axis(QCPAxis* axis);
  /// Small words inside the plot, on the base colour.
  void add_note(double x, double y, const QString& text, Qt::Alignment anchor);
  /// Legend above the plot, beside no data; call last.
  void show_legend();

 private:
  void draw_now(const QSize& size);
  void dress();
  void dress_axis(QCPAxis* axis) const;
  /// Breaks the titles of axes and the legend into as many lines as the size asks for.
  void fit_words(const QSize& size);
  QCustomPlot* chart_;
  std::vector<std::pair<QCPAxis*, QString>> titles_;  ///< of axes, each in one line
  bool is_stale_ = true;
};

}  // namespace alltact
