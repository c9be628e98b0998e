#include "widgets/plots/plot.h"

#include "widgets/copy_figure.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/widget_base.h"

#include <QEvent>
#include <QLocale>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

/// Plot width and height taken by the ticks and titles of the other axes, px.
constexpr int kMarginAcross = 90, kMarginUp = 60;
/// A title that left the axes less height is not shown.
constexpr int kLeastAxes = 90, kBetweenLines = 8;
constexpr int kLegendIcon = 48;  // with the space around it

/// Wraps at spaces so that no line is longer than `room` px, as far as words allow.
QString broken(const QString& text, const QFontMetrics& metrics, int room) {
  QString lines, line;
  for (const QString& word : text.split(QLatin1Char(' '))) {
    const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
    if (!line.isEmpty() && metrics.horizontalAdvance(longer) > room) {
      lines += line + QLatin1Char('\n');
      line = word;
    } else {
      line = longer;
    }
  }
  return lines + line;
}

}  // namespace

Plot::Plot(QWidget* parent)
    : QWidget(parent), chart_(new QCustomPlot(this)), title_(new QCPTextElement(chart_)) {
  auto* layout = without_margins(new QVBoxLayout(this));
  layout->addWidget(chart_);
  chart_->setFocusPolicy(Qt::NoFocus);  // the plot around it has the name and the keys
  setMinimumSize(220, 160);
  chart_->setNotAntialiasedElements(QCP::aeNone);
  setFocusPolicy(Qt::ClickFocus);
  set_accessible_role(*this, QAccessible::Chart);
  new CopyFigure(*this, [this] { return figure(); });
}

Plot::~Plot() = default;

/// As it is shown, sharp enough for a slide.
QImage Plot::figure() {
  constexpr double kSharpness = 2;
  return chart_->toPixmap(width(), height(), kSharpness).toImage();
}

QImage Plot::image(const QSize& size, double scale) {
  ensurePolished();
  draw_now(size, false);
  QImage image = chart_->toPixmap(size.width(), size.height(), scale).toImage();
  rebuild();  // as it is shown
  return image;
}

bool Plot::save_pdf(const QString& file, const QSize& size) {
  ensurePolished();
  draw_now(size, false);
  const bool is_saved = chart_->savePdf(file, size.width(), size.height(), QCP::epAllowCosmetic);
  rebuild();
  return is_saved;
}

bool Plot::save_svg(const QString& file, const QSize& size) {
  ensurePolished();
  draw_now(size, false);
  QSvgGenerator drawing;
  drawing.setFileName(file);
  drawing.setSize(size);
  drawing.setViewBox(QRect(QPoint(), size));
  constexpr int kDotsPerInch = 96;
  drawing.setResolution(kDotsPerInch);
  QCPPainter painter;
  if (!painter.begin(&drawing)) return false;
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  chart_->toPainter(&painter, size.width(), size.height());
  rebuild();
  return painter.end();
}

void Plot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  const auto type = event->type();
  if (type == QEvent::PaletteChange || type == QEvent::FontChange || type == QEvent::LanguageChange)
    rebuild();
}

void Plot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  setAccessibleName(title());
  if (is_stale_) draw_now(size(), true);
}

void Plot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (is_stale_) return;
  fit_text(size());
  fit(size());
  chart_->replot(QCustomPlot::rpQueuedReplot);  // it was resized before this
}

void Plot::rebuild() {
  is_stale_ = true;
  setAccessibleName(title());
  if (isVisible()) draw_now(size(), true);
}

void Plot::draw_now(const QSize& size, bool is_titled) {
  is_stale_ = false;
  chart_->clearPlottables();
  chart_->clearItems();
  apply_style();
  titles_.clear();
  const bool is_drawn = draw();
  title_text_ = is_drawn && is_titled && shows_title() ? title() : QString();
  if (!is_drawn) {
    for (QCPAxis* axis : {chart_->xAxis, chart_->yAxis, chart_->xAxis2, chart_->yAxis2})
      axis->setVisible(false);
    auto* text = new QCPItemText(chart_);
    text->position->setType(QCPItemPosition::ptAxisRectRatio);
    text->position->setCoords(0.5, 0.5);
    text->setText(empty_text());
    text->setFont(font());
    text->setColor(palette().color(QPalette::Text));
  }
  for (QCPAxis* axis : {chart_->xAxis, chart_->yAxis, chart_->xAxis2, chart_->yAxis2})
    if (axis->visible() && !axis->label().isEmpty()) titles_.emplace_back(axis, axis->label());
  fit_text(size);
  fit(size);
  chart_->replot(QCustomPlot::rpQueuedReplot);
}

/// Takes no room without a title.
void Plot::set_title(const QString& title) {
  QCPLayoutGrid* layout = chart_->plotLayout();
  const bool is_shown = title_->layout() != nullptr;
  title_->setText(title);
  title_->setVisible(!title.isEmpty());
  if (title.isEmpty() && is_shown) {
    layout->take(title_);
    layout->simplify();
  } else if (!title.isEmpty() && !is_shown) {
    layout->insertRow(0);
    layout->addElement(0, 0, title_);
  }
}

void Plot::style_axis(QCPAxis* axis) const {
  const QColor text = palette().color(QPalette::Text);
  QColor faint = text;
  faint.setAlpha(38);
  axis->setVisible(true);
  axis->setBasePen(QPen(text, 1));
  axis->setTickPen(QPen(text, 1));
  axis->setSubTickPen(Qt::NoPen);
  axis->setTickLabelColor(text);
  axis->setLabelColor(text);
  axis->setTickLabelFont(font());
  axis->setLabelFont(font());
  axis->grid()->setPen(QPen(faint, 1));
  axis->grid()->setZeroLinePen(QPen(faint, 1));
}

void Plot::add_axis(QCPAxis* axis) {
  style_axis(axis);
  titles_.emplace_back(axis, axis->label());
}

void Plot::apply_style() {
  QLocale numbers;  // the window's, which may have changed since
  numbers.setNumberOptions(QLocale::OmitGroupSeparator);
  chart_->setLocale(numbers);
  chart_->setBackground(QBrush(palette().color(QPalette::Base)));
  for (QCPAxis* axis : {chart_->xAxis, chart_->yAxis}) style_axis(axis);
  for (QCPAxis* axis : {chart_->xAxis2, chart_->yAxis2}) {
    style_axis(axis);
    axis->setTicks(false);
    axis->setTickLabels(false);
  }
  QFont bold = font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setTextColor(palette().color(QPalette::Text));
  chart_->legend->setVisible(false);
  chart_->legend->setFont(font());
  chart_->legend->setTextColor(palette().color(QPalette::Text));
  chart_->legend->setBorderPen(Qt::NoPen);
  QColor ground = palette().color(QPalette::Base);
  ground.setAlpha(200);
  chart_->legend->setBrush(ground);
}

void Plot::add_note(double x, double y, const QString& text, Qt::Alignment anchor) {
  auto* note = new QCPItemText(chart_);
  note->position->setCoords(x, y);
  note->setPositionAlignment(anchor);
  note->setText(text);
  note->setFont(font());
  note->setColor(palette().color(QPalette::Text));
  QColor ground = palette().color(QPalette::Base);  // so that it can be read on dark colours
  ground.setAlphaF(0.75F);
  note->setBrush(ground);
  note->setPadding(QMargins(4, 2, 4, 2));
  note->setClipToAxisRect(false);
}

void Plot::show_legend() {
  QCPLegend* legend = chart_->legend;
  legend->setVisible(true);
  if (legend->layout() == chart_->plotLayout()) return;
  chart_->axisRect()->insetLayout()->take(legend);
  const int row = title_->layout() == nullptr ? 0 : 1;
  chart_->plotLayout()->insertRow(row);
  chart_->plotLayout()->addElement(row, 0, legend);
  chart_->plotLayout()->setRowStretchFactor(row, 1e-3);
}

void Plot::fit_text(const QSize& size) {
  const QFontMetrics metrics(font());
  for (const auto& [axis, title] : titles_) {
    const bool is_across = axis->orientation() == Qt::Horizontal;
    axis->setLabel(broken(title, metrics,
                          is_across ? size.width() - kMarginAcross : size.height() - kMarginUp));
  }
  QCPLegend* legend = chart_->legend;
  int lines = 1;  // above the axes: the title, and those of the legend
  if (legend->visible() && legend->itemCount() > 0) {
    wrap_legend(size);
    lines += (legend->itemCount() + legend->wrap() - 1) / legend->wrap();
  }
  const bool has_room =
      size.height() - kMarginUp - lines * (metrics.height() + kBetweenLines) >= kLeastAxes;
  set_title(has_room ? title_text_ : QString());
}

void Plot::wrap_legend(const QSize& size) {
  const QFontMetrics metrics(font());
  QCPLegend* legend = chart_->legend;
  int widest = 0;
  for (int i = 0; i < legend->itemCount(); ++i)
    if (auto* item = qobject_cast<QCPPlottableLegendItem*>(legend->item(i)))
      widest = std::max(widest, metrics.horizontalAdvance(item->plottable()->name()));
  legend->setWrap(std::clamp(size.width() / (widest + kLegendIcon), 1, legend->itemCount()));
  legend->setFillOrder(QCPLegend::foColumnsFirst, true);
}

}  // namespace alltact
