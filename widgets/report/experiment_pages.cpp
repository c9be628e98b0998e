#include "widgets/report/experiment_pages.h"

#include "widgets/joined_words.h"
#include "widgets/plots/experiment_figure.h"
#include "widgets/report/document.h"
#include "widgets/report/relief_image.h"
#include "widgets/report/report_words.h"
#include "widgets/theme.h"

#include <cmath>

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
  const auto cell = [](const QString& words) { return Document::Cell{words, {}, 0}; };
  return {cell(what_of(figure)),
          cell(measured_number(figure.simulated)),
          cell(given_number(figure.paper)),
          cell(given_number(figure.aim)),
          cell(as_text(figure.unit)),
          cell(figure.aim ? (figure.reaches_aim() ? text("reached") : text("missed")) : QString())};
}

void add_table(Document& document, const std::vector<Document::Row>& rows) {
  document.table({QString(), text("Ours"), text("Paper"), text("Aim"), text("Unit"), QString()},
                 rows,
                 {false, true, true, true, false, false},
                 {50, 11, 9, 9, 10, 11});
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
  document.paragraph(
      text("%1 experiments with %2 frames; %3 of %4 figures with an aim reach it. Made %5 by "
           "AllTact %6 with the seed %7.")
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
    document.figure(
        drawn.image({kPlotWidth, kPlotHeight}, kPlotSharpness), kPlotWidth, sentence(plot.caption));
  }
  for (const ExperimentMaps& maps : outcome.maps)
    document.figure(
        relief_image(maps, kPlotWidth, kPlotSharpness), kPlotWidth, sentence(maps.caption));
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

}  // namespace alltact
