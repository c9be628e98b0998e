#include "widgets/report/experiment_pages.h"

#include "widgets/plots/experiment_figure.h"
#include "widgets/report/document.h"
#include "widgets/report/report_words.h"
#include "widgets/theme.h"

#include <cmath>

namespace alltact {
namespace {

constexpr int kPlotWidth = 600, kPlotHeight = 300;  // px at 96 to the inch
constexpr double kPlotSharpness = 2.0;

QString figure_number(const std::optional<double>& number) {
  if (!number) return QString::fromUtf8("\u2013");
  return QString::number(*number, 'f', std::abs(*number) >= 10 ? 1 : 3);
}

void add_summary(Document& document, const ExperimentReport& report) {
  document.box(text("Simulated here, measured there"),
               as_text(ours_and_theirs()) +
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
  for (const ExperimentFigure& figure : outcome.figures)
    rows.push_back(
        {{sentence(figure.what).chopped(1), {}, 0},
         {figure_number(figure.ours), {}, 0},
         {figure_number(figure.paper), {}, 0},
         {figure_number(figure.aim), {}, 0},
         {as_text(figure.unit), {}, 0},
         {figure.aim ? (figure.reaches_aim() ? text("reached") : text("missed")) : QString(),
          {},
          0}});
  document.table({QString(),
                  text("Ours, simulated"),
                  text("Paper, measured"),
                  text("Aim"),
                  text("Unit"),
                  QString()},
                 rows,
                 {false, true, true, true, false, false});
}

void add_plots(Document& document, const ExperimentOutcome& outcome) {
  for (const ExperimentPlot& plot : outcome.plots) {
    ExperimentFigurePlot drawn;
    QFont font("DejaVu Sans");
    font.setPixelSize(12);
    drawn.setFont(font);
    drawn.setPalette(theme_palette(Theme::kLight));
    drawn.set_plot(plot);
    document.figure(drawn.picture({kPlotWidth, kPlotHeight}, kPlotSharpness),
                    kPlotWidth,
                    sentence(plot.caption));
  }
  for (const ExperimentPicture& picture : outcome.pictures) {
    const cv::Mat& colours = picture.colours;
    const QImage image(colours.data,
                       colours.cols,
                       colours.rows,
                       static_cast<qsizetype>(colours.step),
                       QImage::Format_BGR888);
    document.figure(image.copy(), kPlotWidth, sentence(picture.caption));
  }
}

}  // namespace

Result<std::vector<ReportFile>> make_experiment_pages(const ExperimentReport& report,
                                                      const std::string& name) {
  Document document(text("The paper's experiments, in simulation"));
  add_summary(document, report);
  bool is_first = true;
  for (const ExperimentDone& done : report.done) {
    if (!is_first) document.new_page();
    is_first = false;
    QString title = as_text(done.experiment->name);
    document.heading(title + ": " + as_text(done.experiment->measures));
    add_figures(document, done.outcome);
    add_plots(document, done.outcome);
    for (const Message& remark : done.outcome.remarks) document.paragraph(sentence(remark));
  }
  auto pdf = document.pdf(report.date);
  if (!pdf) return pdf.error();
  return std::vector<ReportFile>{{name + ".html", document.html()},
                                 {name + ".pdf", std::move(*pdf)}};
}

}  // namespace alltact
