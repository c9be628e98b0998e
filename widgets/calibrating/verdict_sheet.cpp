#include "widgets/calibrating/verdict_sheet.h"

#include "calibration/checks/check_history.h"
#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/report_words.h"
#include "widgets/verdict_text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPrintDialog>
#include <QPrinter>

namespace alltact {
namespace {

constexpr int kSheetWidth = 600;         // px at 96 per inch: the width of a printed page
constexpr double kSheetSharpness = 3.0;  // pixels per sheet pixel: 288 per inch
constexpr std::size_t kMaxPresses = 12;

struct SheetWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::SheetWords)
};

/// Builds one sheet from top to bottom.
class Sheet {
 public:
  Sheet(const FingerCalibration& done, const std::optional<FingerWorth>& now)
      : done_(done),
        now_(now),
        light_(theme_palette(Theme::kLight)),
        document_(SheetWords::tr("Finger %1: what its calibration is worth")
                      .arg(as_text(done.finger.name))) {}

  Document written(const QString& command) {
    add_verdict();
    add_figures();
    add_presses();
    add_next();
    document_.command(command);
    return std::move(document_);
  }

 private:
  void add_verdict() {
    const bool is_known = now_ && now_->evidence;
    const Verdict worth = is_known ? window_verdict(*now_->evidence) : done_.verdict;
    const Headline headline = headline_of(worth.grade,
                                          expected_error_mm(worth).value_or(0.0),
                                          is_known && now_->must_repeat,
                                          is_known ? now_->reference : ReferenceState::kIntact);
    QStringList lines;
    for (const Message& finding :
         findings_of(worth, is_known ? now_->evidence->contradictions : done_.contradictions))
      lines << window_sentence(finding);
    for (const Message& line : {worth.cause, worth.rests_on})
      if (!line.empty()) lines << window_sentence(line);
    document_.box(
        headline.text, lines.join(QLatin1Char('\n')), meaning_colour(headline.meaning, light_));
    const auto seconds = unix_seconds(done_.inputs.date);
    const QString date =
        seconds ? QLocale().toString(QDateTime::fromSecsSinceEpoch(static_cast<qint64>(*seconds)),
                                     QLocale::ShortFormat)
                : as_text(done_.inputs.date);
    const QString person = as_text(done_.inputs.press_set.operator_name);
    document_.paragraph(joined({SheetWords::tr("%1, ball of radius %2 mm, %n press(es), AllTact %3",
                                               nullptr,
                                               static_cast<int>(done_.calibration.balls.size()))
                                    .arg(date,
                                         local_mm(done_.inputs.press_set.ball_radius_mm, 3),
                                         as_text(done_.inputs.program_version)),
                                person}));
    if (!done_.zones.empty())
      document_.paragraph(SheetWords::tr("By zone of the face: %1.")
                              .arg(in_window_language(zone_sentence(done_.zones))));
    QStringList signs;
    for (const Message& sign : done_.fault_signs) signs << window_sentence(sign);
    if (!signs.isEmpty())
      document_.box(SheetWords::tr("The presses show a fault"),
                    signs.join(QLatin1Char('\n')),
                    meaning_colour(Meaning::kDoubtful, light_));
  }

  void add_figures() {
    MappingPlot mapping;
    mapping.set_data(mapping_figure(done_.calibration, done_.residuals));
    add(mapping,
        220,
        SheetWords::tr("From brightness to depth: each point is a block of pixels "
                       "under a ball."));
    FaceMapPlot map;
    map.set_data(face_figure(
        FaceQuantity::kResidual, done_.calibration, done_.residuals, done_.finger.face.kind));
    add(map, 180, SheetWords::tr("Where on the face, and how far the mapping is off there."));
  }

  void add(Plot& plot, int height, const QString& caption) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    plot.setFont(font);
    plot.setPalette(light_);
    document_.figure(plot.image({kSheetWidth, height}, kSheetSharpness), kSheetWidth, caption);
  }

  void add_presses() {
    std::vector<Document::Row> rows;
    for (const BallFit& ball : done_.calibration.balls) {
      if (rows.size() == kMaxPresses) break;
      const auto error = press_error_mm(ball);
      rows.push_back({{as_text(ball.press), {}, 0},
                      {local_mm(ball.depth_mm, 2), {}, 0},
                      {error ? local_mm(*error, 3) : SheetWords::tr("unknown"), {}, 0},
                      {error ? error_word(meaning_of_error(*error)) : QString(), {}, 0}});
    }
    document_.table({SheetWords::tr("Press"),
                     SheetWords::tr("Depth (mm)"),
                     SheetWords::tr("Error (mm)"),
                     QString()},
                    rows,
                    {false, true, true, false});
    const auto more = done_.calibration.balls.size() - rows.size();
    if (more > 0)
      document_.paragraph(
          SheetWords::tr("And %n press(es) more, in the report.", nullptr, static_cast<int>(more)));
  }

  void add_next() {
    if (done_.calibration.next_press)
      document_.paragraph(window_sentence(done_.calibration.next_press->sentence));
  }

  const FingerCalibration& done_;
  const std::optional<FingerWorth>& now_;
  const QPalette light_;
  Document document_;
};

}  // namespace

Document verdict_sheet(const FingerCalibration& done,
                       const QString& command,
                       const std::optional<FingerWorth>& now) {
  return Sheet(done, now).written(command);
}

void print_sheet(const Document& sheet, QWidget& parent) {
  auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
  printer->setPageLayout(
      QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
  auto* dialog = new QPrintDialog(printer.get(), &parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(SheetWords::tr("Print the verdict"));
  QObject::connect(dialog,
                   qOverload<QPrinter*>(&QPrintDialog::accepted),
                   dialog,
                   [sheet, printer](QPrinter* chosen) { sheet.print(*chosen); });
  // The dialog uses the printer as long as it lives.
  QObject::connect(dialog, &QObject::destroyed, [printer] {});
  dialog->show();
}

}  // namespace alltact
