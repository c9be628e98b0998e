#include "widgets/report/experiment_pages.h"

#include "core/image/colour_map.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/report/document.h"
#include "widgets/theme.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kPlotWidth = 600, kPlotHeight = 262;  // px at 96 to the inch
constexpr double kPlotSharpness = 3.0;              // 288 to the inch on paper

/// A measured number.
QString measured_number(double number) {
  return QString::number(number, 'f', std::abs(number) >= 10 ? 1 : 3);
}

/// With the digits that the paper gives.
QString given_number(const std::optional<double>& number) {
  return number ? QString::number(*number, 'g', 6) : QString::fromUtf8("\u2013");
}

QString what_of(const ExperimentFigure& figure) {
  return sentence(figure.what).chopped(1).replace("+-", QString::fromUtf8("\u00b1"));
}

Document::Row row_of(const ExperimentFigure& figure) {
  return {{what_of(figure)},
          {measured_number(figure.simulated)},
          {given_number(figure.paper)},
          {given_number(figure.aim)},
          {as_text(figure.unit)},
          {figure.aim ? (figure.reaches_aim() ? text("reached") : text("missed")) : QString()}};
}

void add_table(Document& document, const std::vector<Document::Row>& rows) {
  document.table({QString(), text("Ours"), text("Paper"), text("Aim"), text("Unit"), QString()},
                 rows, {false, true, true, true, false, false}, {50, 11, 9, 9, 10, 11});
}

/// All figures that the paper gives or that have a target.
void add_overview(Document& document, const ExperimentReport& report) {
  std::vector<Document::Row> rows;
  for (const ExperimentDone& done : report.done)
    for (const ExperimentFigure& figure : done.outcome.figures) {
      if (!figure.paper && !figure.aim) continue;
      rows.push_back(row_of(figure));
      rows.back()[0].text = labelled(as_text(done.experiment->name), what_of(figure));
    }
  document.heading(text("All figures that the paper tells, or that have an aim"));
  add_table(document, rows);
}

void add_summary(Document& document, const ExperimentReport& report) {
  document.box(text("Simulated here, measured there"),
               as_text(simulated_and_real()) +
                   text(" That ours are less says what the method itself adds to the error, not "
                        "that a real finger would do so. Where the paper shows a picture and no "
                        "figure, there is a dash."),
               meaning_colour(Meaning::kDoubtful, theme_palette(Theme::kLight)));
  int frames = 0, aims = 0, reached = 0;
  for (const ExperimentDone& done : report.done) {
    frames += done.outcome.frames;
    for (const ExperimentFigure& figure : done.outcome.figures)
      if (figure.aim) ++aims, reached += figure.reaches_aim();
  }
  document.paragraph(text("%1 experiments with %2 frames; %3 of %4 figures with an aim reach it. "
                          "Made %5 by AllTact %6 with the seed %7.")
                         .arg(report.done.size())
                         .arg(frames)
                         .arg(reached)
                         .arg(aims)
                         .arg(when(as_text(report.date)), as_text(report.program_version))
                         .arg(report.seed));
}

void add_figures(Document& document, const ExperimentOutcome& outcome) {
  std::vector<Document::Row> rows;
  for (const ExperimentFigure& figure : outcome.figures) rows.push_back(row_of(figure));
  add_table(document, rows);
}

void add_plots(Document& document, const ExperimentOutcome& outcome) {
  for (const ExperimentPlot& plot : outcome.plots) {
    ExperimentFigurePlot drawn;
    QFont font("DejaVu Sans");
    font.setPixelSize(12);
    drawn.setFont(font);
    drawn.setPalette(theme_palette(Theme::kLight));
    drawn.set_plot(plot);
    document.figure(drawn.image({kPlotWidth, kPlotHeight}, kPlotSharpness), kPlotWidth,
                    sentence(plot.caption));
  }
  for (const ExperimentMaps& maps : outcome.maps)
    document.figure(relief_image(maps, kPlotWidth, kPlotSharpness), kPlotWidth,
                    sentence(maps.caption));
}

/// How to reproduce it.
void add_origin(Document& document, const ExperimentDone& done, std::uint64_t seed) {
  QStringList scenes;
  for (const std::string& scene : done.experiment->scenes) scenes << as_text(scene);
  document.paragraph(text("%1 frames of %2 in %3 s; alltact experiments %4 --seed %5")
                         .arg(done.outcome.frames)
                         .arg(listed(scenes))
                         .arg(done.seconds, 0, 'f', 1)
                         .arg(as_text(done.experiment->name))
                         .arg(seed));
}

}  // namespace

Result<std::vector<ReportFile>> make_experiment_pages(const ExperimentReport& report,
                                                      const std::string& name) {
  Document document(text("The paper's experiments, in simulation"));
  document.keep_sections_together();
  add_summary(document, report);
  add_overview(document, report);
  for (const ExperimentDone& done : report.done) {
    document.heading(labelled(as_text(done.experiment->name), as_text(done.experiment->measures)));
    add_figures(document, done.outcome);
    add_plots(document, done.outcome);
    for (const Message& remark : done.outcome.remarks) document.paragraph(sentence(remark));
    add_origin(document, done, report.seed);
  }
  auto pdf = document.pdf(report.date);
  if (!pdf) return pdf.error();
  return std::vector<ReportFile>{{name + ".html", document.html()},
                                 {name + ".pdf", std::move(*pdf)}};
}

namespace {

constexpr double kGap = 8, kLine = 18;  // px at 96 to the inch
constexpr double kLength_mm = 5;        // shown next to the scales

QImage coloured(const cv::Mat_<float>& map_mm, const ColourScale& scale) {
  QImage image(map_mm.cols, map_mm.rows, QImage::Format_RGB32);
  for (int v = 0; v < map_mm.rows; ++v)
    for (int u = 0; u < map_mm.cols; ++u) {
      const double mm = static_cast<double>(map_mm(v, u));
      if (!std::isfinite(mm)) {
        image.setPixel(u, v, qRgb(128, 128, 128));
        continue;
      }
      const MapColour c = scale.colour_at(mm);
      image.setPixel(u, v, qRgb(c.red, c.green, c.blue));
    }
  return image;
}

void draw_map(QPainter& painter, const ExperimentMap& map, const ColourScale& scale,
              const QRectF& room) {
  painter.setPen(Qt::black);
  painter.drawText(QRectF(room.left(), room.top(), room.width(), kLine),
                   Qt::AlignLeft | Qt::AlignVCenter, sentence(map.name).chopped(1));
  const QRectF map_box = room.adjusted(0, kLine, 0, 0);
  painter.drawImage(map_box, coloured(map.mm, scale));
  painter.setPen(QPen(QColor("#4c5158"), 1));
  painter.drawRect(map_box);
}

/// Returns the position of the next one.
double draw_scale(QPainter& painter, const ColourScale& scale, const QString& title,
                  const QRectF& room) {
  constexpr double kHeight = 12, kSide = 14;  // half a number sticks out at either end
  painter.setPen(Qt::black);
  painter.drawText(QRectF(room.left(), room.top(), room.width(), kLine),
                   Qt::AlignLeft | Qt::AlignVCenter, title);
  const QRectF bar(room.left() + kSide, room.top() + kLine, room.width() - 2 * kSide, kHeight);
  QLinearGradient colours(bar.topLeft(), bar.topRight());
  for (int i = 0; i <= 16; ++i) {
    const MapColour c = scale.colour(i / 16.0);
    colours.setColorAt(i / 16.0, QColor(c.red, c.green, c.blue));
  }
  painter.fillRect(bar, colours);
  fill_scale_ends(painter, bar);
  for (int i = 0; i <= scale.steps; ++i) {
    const double part = static_cast<double>(i) / scale.steps;
    const double x = bar.left() + part * bar.width();
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
    painter.drawText(QRectF(x - 30, bar.bottom() + 2, 60, kLine), Qt::AlignCenter,
                     QString::number(scale.low_mm + part * (scale.top_mm - scale.low_mm), 'g', 3));
  }
  return bar.bottom() + 2 + kLine;
}

void draw_length(QPainter& painter, const QRectF& room, double px_per_mm) {
  const double y = room.top() + 0.5 * kLine, end = room.left() + kLength_mm * px_per_mm;
  painter.setPen(QPen(Qt::black, 2));
  painter.drawLine(QPointF(room.left(), y), QPointF(end, y));
  painter.setPen(Qt::black);
  painter.drawText(QRectF(end + kGap, room.top(), room.right() - end, kLine),
                   Qt::AlignLeft | Qt::AlignVCenter, QString::number(kLength_mm) + " mm");
}

}  // namespace

QImage relief_image(const ExperimentMaps& maps, int width, double sharpness) {
  const auto columns = static_cast<int>(maps.depths.size());
  const cv::Mat& first = maps.depths.front().mm;
  const double map_width = (width - (columns - 1) * kGap - 1) / columns;
  const double map_height = map_width * first.rows / first.cols;
  const double row_height = kLine + map_height;
  QImage image(qRound(sharpness * width), qRound(sharpness * (2 * row_height + kGap + 1)),
               QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.scale(sharpness, sharpness);
  QFont font("DejaVu Sans");
  font.setPixelSize(11);
  painter.setFont(font);
  const ColourScale depths = depth_scale(maps.top_mm);
  const ColourScale differences = difference_scale(maps.difference_top_mm);
  const auto room_of = [&](int column, int row) {
    return QRectF(column * (map_width + kGap), row * (row_height + kGap), map_width, row_height);
  };
  for (int i = 0; i < columns; ++i)
    draw_map(painter, maps.depths[static_cast<std::size_t>(i)], depths, room_of(i, 0));
  for (int i = 0; i < static_cast<int>(maps.differences.size()); ++i)
    draw_map(painter, maps.differences[static_cast<std::size_t>(i)], differences,
             room_of(i + 1, 1));
  QRectF legend = room_of(0, 1).adjusted(0, 0, -kGap, 0);
  legend.setTop(draw_scale(painter, depths, text("Depth (mm)"), legend) + kGap / 2);
  legend.setTop(draw_scale(painter, differences, text("Told \u2212 true (mm)"), legend) + kGap);
  draw_length(painter, legend, map_width / (first.cols * maps.mm_per_cell));
  return image;
}

namespace {

using Style = ExperimentSeries::Style;

QString words_of(const Message& message) { return QString::fromStdString(message.english()); }

/// With spaces behind: in a high-resolution image QCustomPlot clips the legend a little too early.
QString legend_words(const Message& message) { return words_of(message) + QStringLiteral("    "); }

constexpr std::size_t kPointsToMark = 30;  // on a line; with more points no markers are drawn

bool is_bar(const ExperimentPlot& plot, const ExperimentSeries& series) {
  return !plot.categories.empty() &&
         (series.style == Style::kBars || series.style == Style::kPaper);
}

QCPScatterStyle mark_of(int which, const QColor& colour, double size = 6) {
  constexpr QCPScatterStyle::ScatterShape kShapes[] = {
      QCPScatterStyle::ssDisc, QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
      QCPScatterStyle::ssDiamond};
  return {kShapes[which % 4], QPen(colour, 1.5), QBrush(colour), size};
}

}  // namespace

ExperimentFigurePlot::ExperimentFigurePlot(QWidget* parent) : Plot(parent) {
  setAccessibleName(tr("Figure of an experiment"));
  // Above the plot, so that it covers no data.
  constexpr int kSideBySide = 2;
  QCPLegend* legend = chart().legend;
  chart().axisRect()->insetLayout()->take(legend);
  chart().plotLayout()->insertRow(0);
  chart().plotLayout()->addElement(0, 0, legend);
  chart().plotLayout()->setRowStretchFactor(0, 0.001);
  legend->setFillOrder(QCPLegend::foColumnsFirst);
  legend->setWrap(kSideBySide);
}

void ExperimentFigurePlot::set_plot(const ExperimentPlot& plot) {
  plot_ = plot;
  setAccessibleDescription(words_of(plot_.caption));
  rebuild();
}

QString ExperimentFigurePlot::empty_text() const { return tr("Nothing was measured"); }

void ExperimentFigurePlot::draw_bars(const ExperimentSeries& series, int which, int of) {
  constexpr double kTogether = 0.7;  // fraction of the distance between two groups
  const bool is_paper = series.style == Style::kPaper;
  auto* bars = new QCPBars(chart().xAxis, chart().yAxis);
  const double width = kTogether / of;
  bars->setWidth(0.92 * width);
  if (plot_.logarithmic_y) bars->setBaseValue(min_shown_);
  for (std::size_t i = 0; i < series.x.size(); ++i)
    bars->addData(series.x[i] + (which - 0.5 * (of - 1)) * width, series.y[i]);
  const QColor colour = series_colour(which, palette());
  bars->setPen(QPen(colour, 1.5));
  bars->setBrush(is_paper ? QBrush(colour, Qt::BDiagPattern) : QBrush(colour));
  bars->setName(legend_words(series.name));
}

void ExperimentFigurePlot::draw_points(const ExperimentSeries& series, int which) {
  auto* curve = new QCPCurve(chart().xAxis, chart().yAxis);
  for (std::size_t i = 0; i < series.x.size(); ++i)
    curve->addData(series.x[i], std::max(series.y[i], min_shown_));
  const QColor colour = series_colour(which, palette());
  const QColor text = palette().color(QPalette::Text);
  switch (series.style) {
    case Style::kPaper:
      curve->setPen(QPen(colour, 2, Qt::DashLine));
      if (series.x.size() == 1) curve->setScatterStyle(mark_of(which, colour, 12));
      break;
    case Style::kAim:
      curve->setPen(QPen(text, 1.5, Qt::DotLine));
      break;
    case Style::kExact:
      curve->setPen(QPen(text, 1));
      break;
    case Style::kLine:
      curve->setPen(QPen(colour, 2));
      if (series.x.size() <= kPointsToMark) curve->setScatterStyle(mark_of(which, colour));
      break;
    case Style::kDots:
    case Style::kBars:
      curve->setPen(Qt::NoPen);
      curve->setScatterStyle(series.x.size() > 200
                                 ? QCPScatterStyle(QCPScatterStyle::ssDisc, colour, 3)
                                 : mark_of(which, colour));
      break;
  }
  curve->setName(legend_words(series.name));
}

void ExperimentFigurePlot::find_extent() {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  min_ = {kInfinite, kInfinite}, max_ = {-kInfinite, -kInfinite};
  double min_above_0 = kInfinite;
  for (const ExperimentSeries& series : plot_.series) {
    for (const double x : series.x)
      min_.rx() = std::min(min_.x(), x), max_.rx() = std::max(max_.x(), x);
    for (const double y : series.y) {
      min_.ry() = std::min(min_.y(), y), max_.ry() = std::max(max_.y(), y);
      if (y > 0) min_above_0 = std::min(min_above_0, y);
    }
  }
  min_shown_ = -kInfinite;
  if (!plot_.logarithmic_y) return;
  // The power of ten below the smallest value; an error of exactly 0 stands on the axis.
  min_shown_ = std::pow(10, std::floor(std::log10(0.9 * std::min(min_above_0, 1e9))));
}

void ExperimentFigurePlot::set_ranges() {
  if (plot_.logarithmic_y) {
    chart().yAxis->setScaleType(QCPAxis::stLogarithmic);
    chart().yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    chart().yAxis->setNumberFormat("g");
    chart().yAxis->setNumberPrecision(3);
    chart().yAxis->setRange(min_shown_, 1.6 * std::max(max_.y(), 2 * min_shown_));
  } else {
    // Errors and fractions begin at 0; signed values lie around it.
    const double low = std::min(min_.y(), 0.0);
    const double height = std::max(max_.y() - low, 1e-9);
    chart().yAxis->setRange(low < 0 ? low - 0.06 * height : 0, max_.y() + 0.08 * height);
  }
  if (!plot_.categories.empty()) {
    chart().xAxis->setRange(-0.6, static_cast<double>(plot_.categories.size()) - 0.4);
    auto names = QSharedPointer<QCPAxisTickerText>::create();
    for (std::size_t i = 0; i < plot_.categories.size(); ++i)
      names->addTick(static_cast<double>(i), words_of(plot_.categories[i]));
    chart().xAxis->setTicker(names);
    chart().xAxis->grid()->setVisible(false);
    return;
  }
  const double margin = 0.04 * std::max(max_.x() - min_.x(), 1e-9);
  chart().xAxis->setRange(min_.x() - margin, max_.x() + margin);
}

bool ExperimentFigurePlot::draw() {
  if (plot_.series.empty()) return false;
  const auto bars =
      static_cast<int>(std::count_if(plot_.series.begin(), plot_.series.end(),
                                     [&](const auto& one) { return is_bar(plot_, one); }));
  find_extent();
  int which = 0;
  for (const ExperimentSeries& series : plot_.series) {
    if (is_bar(plot_, series))
      draw_bars(series, which, bars);
    else
      draw_points(series, which);
    ++which;
  }
  set_ranges();
  chart().xAxis->setLabel(words_of(plot_.x_axis));
  chart().yAxis->setLabel(words_of(plot_.y_axis));
  chart().legend->setVisible(true);
  return true;
}

}  // namespace alltact
