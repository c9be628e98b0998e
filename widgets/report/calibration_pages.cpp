#include "widgets/report/calibration_pages.h"

#include "calibration/checks/check_history.h"
#include "calibration/finger/calibration_report.h"
#include "widgets/plots/histogram_plot.h"
#include "widgets/plots/history_plot.h"
#include "widgets/plots/press_light_plot.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/document.h"
#include "widgets/report/fault_pages.h"
#include "widgets/report/press_picture.h"
#include "widgets/report/report_words.h"
#include "widgets/theme.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>

namespace alltact {
namespace {

constexpr int kFigureWidth = 600;   // px at 96 to the inch: the width of a printed page
constexpr int kPictureWidth = 132;  // of a press
constexpr double kSharpness = 2.0;  // pixels to each of these, for paper and for dense screens

QString tr(const char* text) {
  return QCoreApplication::translate("CalibrationReport", text);
}

QString grade_word(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return tr("Good");
    case Grade::kUsable:
      return tr("Usable for contact and its place");
    case Grade::kUnproven:
      return tr("Unproven");
    case Grade::kUnfit:
      break;
  }
  return tr("Not fit to measure with");
}

Meaning meaning_of(Grade grade) {
  if (grade == Grade::kGood) return Meaning::kGood;
  return grade == Grade::kUnfit ? Meaning::kBad : Meaning::kDoubtful;
}

/// Writes one report from top to bottom.
class Pages {
 public:
  Pages(const FingerCalibration& done, const std::filesystem::path& folder)
      : done_(done),
        folder_(folder),
        light_(theme_palette(Theme::kLight)),
        document_(tr("Calibration of finger %1").arg(as_text(done.finger.name))) {}

  /// Empty when the job was stopped.
  std::optional<Document> write(const Job& job) {
    for (const auto part : {&Pages::add_verdict,
                            &Pages::add_facts,
                            &Pages::add_presses,
                            &Pages::add_mapping,
                            &Pages::add_errors,
                            &Pages::add_maps,
                            &Pages::add_spread,
                            &Pages::add_methods,
                            &Pages::add_light,
                            &Pages::add_remarks,
                            &Pages::add_history,
                            &Pages::add_repetition}) {
      if (job.stop_requested()) return std::nullopt;
      (this->*part)();
    }
    if (!add_typical_faults(document_, light_, plot_font(), job)) return std::nullopt;
    return std::move(document_);
  }

 private:
  void add_verdict();
  void add_zones();
  void add_facts();
  [[nodiscard]] QString press_words(const BallFit& ball) const;
  static QString punch_words(const StepFit& step);
  void add_presses();
  void add_left_out();
  void add_mapping();
  void add_errors();
  void add_maps();
  void add_map(FaceQuantity quantity, const QString& caption);
  void add_spread();
  static QString method_words(CalibrationMethod method);
  void add_methods();
  void add_light();
  void add_remarks();
  void add_history();
  void add_repetition();

  void add_plot(Plot& plot, int height, const QString& caption) {
    document_.figure(plot.picture({kFigureWidth, height}, kSharpness), kFigureWidth, caption);
  }
  static QFont plot_font() {
    QFont font("DejaVu Sans");
    font.setPixelSize(12);
    return font;
  }
  void dress(Plot& plot) const {
    plot.setFont(plot_font());
    plot.setPalette(light_);
  }
  [[nodiscard]] std::vector<Eigen::Vector2d> touched_by(const BallFit& ball) const {
    std::vector<Eigen::Vector2d> pixels;
    for (const PressResiduals& press : done_.residuals)
      if (press.press == ball.press)
        for (const ResidualSample& sample : press.samples) pixels.push_back(sample.pixel);
    return pixels;
  }
  [[nodiscard]] QString noted(const char* key) const {
    const auto found = done_.finger.provenance.find(key);
    return found == done_.finger.provenance.end() ? QString() : as_text(found->second);
  }

  const FingerCalibration& done_;
  const std::filesystem::path& folder_;
  const QPalette light_;
  Document document_;
};

void Pages::add_verdict() {
  const std::string& whole = done_.verdict.sentence;
  const std::size_t colon = whole.find(": ");
  const std::string rest = colon == std::string::npos ? whole : whole.substr(colon + 2);
  document_.box(grade_word(done_.verdict.grade),
                sentence(rest),
                meaning_colour(meaning_of(done_.verdict.grade), light_));
  document_.paragraph(
      tr("Good means at most %1 mm, usable at most %2 mm of mean error of press depth inside a "
         "contact, on presses that the mapping was made without.")
          .arg(mm(kGoodErrorMm, 2), mm(kUsableErrorMm, 2)));
  if (!done_.fault_signs.empty()) {
    QStringList signs;
    for (const std::string& sign : done_.fault_signs) signs << sentence(sign);
    document_.box(tr("The presses show a fault"),
                  signs.join('\n'),
                  meaning_colour(Meaning::kDoubtful, light_));
  }
  add_zones();
}

void Pages::add_zones() {
  std::vector<Document::Row> rows;
  QStringList unknown;
  for (const ZoneError& zone : done_.zones) {
    const QString name = as_text(zone.zone);
    if (!zone.error_mm) unknown << name;
    rows.push_back({{name, {}, 0},
                    {QString::number(zone.presses), {}, 0},
                    {zone.error_mm ? mm(*zone.error_mm) : tr("unknown: no press there"), {}, 0}});
  }
  document_.heading(tr("How good it is, by zone of the face"));
  document_.table(
      {tr("Zone"), tr("Presses"), tr("Mean depth error (mm)")}, rows, {false, true, true});
  if (!unknown.isEmpty())
    document_.paragraph(tr("Nothing was pressed here, so nothing is known of it: %1. Add a press "
                           "there, or do not rely on depth there.")
                            .arg(unknown.join(", ")));
}

void Pages::add_facts() {
  const Finger& finger = done_.finger;
  const CalibrationInputs& inputs = done_.inputs;
  std::vector<Document::Row> rows;
  const auto add = [&](const QString& name, const QString& value) {
    if (!value.isEmpty()) rows.push_back({{name, {}, 0}, {value, {}, 0}});
  };
  add(tr("Date"), when(as_text(inputs.date)));
  add(tr("Operator"),
      inputs.operator_name.empty() ? tr("not told") : as_text(inputs.operator_name));
  add(tr("Ball"),
      tr("radius %1 mm").arg(inputs.ball_radius_mm) +
          (inputs.other_balls.empty() ? "" : tr("; other balls stand beside their presses")));
  add(tr("Presses"),
      tr("%1 used of %2 given")
          .arg(done_.calibration.balls.size() + done_.calibration.steps.size())
          .arg(done_.presses.size()));
  add(tr("Camera"),
      tr("%1, %2 x %3 px")
          .arg(QString::fromUtf8(to_string(finger.camera.model).data()))
          .arg(finger.camera.width_px)
          .arg(finger.camera.height_px));
  const QString taken_with = noted("press_settings");
  add(tr("Camera and light"),
      taken_with.isEmpty() ? tr("the pictures do not tell what they were taken with") : taken_with);
  add(tr("Reference"),
      noted("reference_date").isEmpty() ? tr("installed with this calibration")
                                        : tr("of %1").arg(when(noted("reference_date"))));
  add(tr("Mapping"), sentence(done_.calibration.degree_choice));
  QStringList settings;
  for (const auto& setting : calibration_settings())
    settings << as_text(setting.name + " " + setting.get(inputs.calibration));
  add(tr("Settings"), settings.join(", "));
  QStringList frames;
  const PipelineSettings usual;
  for (const auto& setting : pipeline_settings())
    if (setting.get(inputs.pipeline) != setting.get(usual))
      frames << as_text(setting.name + " " + setting.get(inputs.pipeline));
  add(tr("Other settings"), frames.join(", "));
  add(tr("Program"), tr("AllTact %1").arg(as_text(inputs.program_version)));
  document_.heading(tr("What it was made with"));
  document_.table({}, rows, {});
}

QString Pages::press_words(const BallFit& ball) const {
  QString words = as_text(ball.press);
  if (!done_.inputs.other_balls.empty()) words += "\n" + tr("ball %1 mm").arg(ball.radius_mm);
  if (ball.cut_by_edge) words += "\n" + tr("cut by the edge");
  if (ball.told_depth)
    words += "\n" +
             tr("measured %1 ± %2 mm deep, the solution has %3 mm")
                 .arg(mm(ball.told_depth->mm), mm(ball.told_depth->sd_mm), mm(ball.pressed_in_mm));
  return words;
}

QString Pages::punch_words(const StepFit& step) {
  return as_text(step.press) + "\n" +
         tr("a punch with a step of %1 mm, which reads %2 ± %3 mm")
             .arg(mm(step.step_mm), mm(step.reads_mm), mm(step.sd_mm));
}

void Pages::add_presses() {
  document_.new_page();
  document_.heading(tr("The presses, worst first"));
  std::map<std::string, const TakenPress*> taken;
  for (const TakenPress& press : done_.presses) taken[press.name] = &press;
  std::vector<const BallFit*> balls;
  for (const BallFit& ball : done_.calibration.balls) balls.push_back(&ball);
  const auto worst = [](const BallFit* ball) {
    return std::max(ball->residual_mm, ball->held_out_mm);
  };
  std::stable_sort(balls.begin(), balls.end(), [&](const BallFit* a, const BallFit* b) {
    return worst(a) > worst(b);
  });
  const auto camera = Camera::create(done_.finger.camera);
  const QSize size = QSize(kPictureWidth, kPictureWidth * 3 / 4) * kSharpness;
  std::vector<Document::Row> rows;
  for (const BallFit* ball : balls) {
    const auto press = taken.find(ball->press);
    QImage picture;
    if (camera && press != taken.end())
      picture = press_picture(press->second->grey, *camera, *ball, touched_by(*ball), size);
    rows.push_back(
        {{QString(), picture, kPictureWidth},
         {press_words(*ball), {}, 0},
         {mm(ball->depth_mm), {}, 0},
         {mm(ball->residual_mm), {}, 0},
         {ball->held_out_mm > 0 ? mm(ball->held_out_mm) : tr("none"), {}, 0},
         {mm(ball->centre_sd_mm.z()), {}, 0},
         {press == taken.end() ? QString() : percent(press->second->sign.light_change), {}, 0}});
  }
  for (const StepFit& step : done_.calibration.steps) {
    const auto press = taken.find(step.press);
    if (press == taken.end()) continue;
    rows.push_back({{QString(), whole_picture(press->second->grey, size), kPictureWidth},
                    {punch_words(step), {}, 0},
                    {tr("none"), {}, 0},
                    {tr("none"), {}, 0},
                    {tr("none"), {}, 0},
                    {tr("none"), {}, 0},
                    {percent(press->second->sign.light_change), {}, 0}});
  }
  document_.pictured_table({tr("Picture"),
                            tr("Press"),
                            tr("Depth (mm)"),
                            tr("Residual (mm)"),
                            tr("Left out (mm)"),
                            tr("Ball's distance, sd (mm)"),
                            tr("Light (%)")},
                           rows,
                           {false, false, true, true, true, true, true});
  document_.paragraph(tr(
      "Orange: the outline of the ball as it was found, with its middle. Dashed: what the ball "
      "touches; the dark contact must lie in there, or something else was taken for the ball. "
      "Depth: the deepest point. Residual: mean error inside the contact with the final mapping. "
      "Left out: the same with a mapping made from the other presses; this is the figure that "
      "counts. Ball's distance, sd: how well the ball's distance from the camera is known. Light: "
      "how much brighter the untouched face is than in the reference; it should be 0 within 1 %."));
  add_left_out();
}

void Pages::add_left_out() {
  std::vector<Document::Row> rows;
  for (const TakenPress& press : done_.presses) {
    if (press.left_out.empty()) continue;
    rows.push_back(
        {{QString(),
          whole_picture(press.grey, QSize(kPictureWidth, kPictureWidth * 9 / 16) * kSharpness),
          kPictureWidth},
         {as_text(press.name), {}, 0},
         {sentence(press.left_out), {}, 0}});
  }
  QStringList reasons;
  for (const std::string& reason : done_.calibration.left_out) {
    const bool shown =
        std::any_of(done_.presses.begin(), done_.presses.end(), [&](const auto& one) {
          return !one.left_out.empty() && reason.rfind(one.name + ": ", 0) == 0;
        });
    if (!shown) reasons << sentence(reason);
  }
  if (rows.empty() && reasons.isEmpty()) return;
  document_.new_page();
  document_.heading(tr("Presses that were left out"));
  if (!rows.empty()) document_.pictured_table({tr("Picture"), tr("Press"), tr("Why")}, rows, {});
  if (!reasons.isEmpty()) document_.list(reasons);
}

void Pages::add_mapping() {
  document_.new_page();
  document_.heading(tr("From brightness to depth"));
  if (!done_.calibration.mapping.variation.is_none())
    document_.paragraph(
        tr("The mapping varies over the face; shown is the middle of the face, the "
           "points as they would be there."));
  MappingPlot plot;
  dress(plot);
  plot.set_data(mapping_figure(done_.calibration, done_.residuals));
  add_plot(
      plot,
      340,
      tr("Each point is a block of pixels under a ball: how much darker it became, and how deep "
         "the ball is there. The line is the mapping, the band two standard deviations of it. "
         "Good: one narrow cloud around the line, reaching to the deepest presses you will "
         "measure. Two clouds side by side: presses that do not agree. Crosses far off the line "
         "belong to the rim, where skin leaves the ball, and are not used."));
}

void Pages::add_errors() {
  constexpr std::size_t kFewPresses = 8;  // their bars fit below the mapping
  if (done_.calibration.balls.size() > kFewPresses) document_.new_page();
  document_.heading(tr("Errors"));
  PressErrorPlot bars;
  dress(bars);
  bars.set_data(press_errors(done_.calibration));
  add_plot(
      bars,
      bars.comfortable_height(),
      tr("Good: all bars alike. One bar much longer than the others: look at that press' picture "
         "above, and leave it out if it shows anything but one clean ball. Left out much longer "
         "than residual: this press tells something that no other does; press more like it."));
}

void Pages::add_map(FaceQuantity quantity, const QString& caption) {
  FaceMapPlot plot;
  dress(plot);
  plot.set_data(face_figure(quantity, done_.calibration, done_.residuals, done_.finger.face.kind));
  const FaceMapData data =
      face_figure(quantity, done_.calibration, done_.residuals, done_.finger.face.kind);
  // The face in its proportions, within reason.
  const double ratio = data.length_mm > 0 ? data.width_mm / data.length_mm : 0.4;
  add_plot(plot, 62 + static_cast<int>(470 * std::clamp(ratio, 0.2, 0.45)), caption);
}

void Pages::add_maps() {
  document_.new_page();
  document_.heading(tr("Where on the face"));
  add_map(
      FaceQuantity::kResidual,
      tr("Mean residual of each square millimetre. Good: no pattern. Errors that grow towards one "
         "end or one side point to light or shape there."));
  if (done_.calibration.held_out_mm > 0)
    add_map(FaceQuantity::kHeldOut,
            tr("Error of each press when the mapping was made without it. Hatched: nothing was "
               "pressed there, nothing is known."));
  add_map(FaceQuantity::kCoverage,
          tr("How deep the presses went, and where. Press next where it is hatched, and as deep as "
             "you will measure."));
}

void Pages::add_spread() {
  document_.new_page();
  document_.heading(tr("How errors are spread"));
  HistogramPlot histogram;
  dress(histogram);
  histogram.set_data(all_errors(done_.residuals), tr("Mapping minus ball (mm)"));
  add_plot(
      histogram,
      260,
      tr("Errors of all blocks in the inner part of the contacts. Good: one hill around zero. A "
         "second hill or a hill beside zero: something differs between presses."));
}

QString Pages::method_words(CalibrationMethod method) {
  switch (method) {
    case CalibrationMethod::kJoint:
      return tr("joint");
    case CalibrationMethod::kPaper:
      return tr("paper");
    case CalibrationMethod::kCircle:
      return tr("circle");
    case CalibrationMethod::kCone:
      break;
  }
  return tr("cone");
}

void Pages::add_methods() {
  if (done_.methods.empty()) return;
  std::vector<Document::Row> rows;
  QStringList failed;
  for (const MethodRow& row : done_.methods) {
    const QString name = method_words(row.method);
    if (!row.failed.empty()) {
      failed << tr("%1: %2").arg(name, as_text(row.failed));
      continue;
    }
    rows.push_back({{name, {}, 0},
                    {QString::number(row.presses), {}, 0},
                    {mm(row.press_depth_mm), {}, 0},
                    {mm(row.residual_mm), {}, 0},
                    {mm(row.at_depth_mm), {}, 0},
                    {mm(row.joint_depth_mm), {}, 0}});
  }
  document_.heading(tr("Other methods on the same presses"));
  document_.table({tr("Method"),
                   tr("Presses"),
                   tr("Mean depth (mm)"),
                   tr("Residual (mm)"),
                   tr("Reads (mm)"),
                   tr("Joint reads (mm)")},
                  rows,
                  {false, true, true, true, true, true});
  document_.paragraph(
      tr("The joint method was used. The others find every ball from its dark border alone and are "
         "here to compare with. Presses: in how many a ball was found, and how deep these went on "
         "average. Reads: the depth for the darkest contact, beside what the joint method reads "
         "there. A border that fades where the skin leaves the ball is neither the ball's outline "
         "nor where it would leave a hard face, so the depths differ."));
  if (!failed.isEmpty()) document_.paragraph(failed.join('\n'));
}

void Pages::add_light() {
  std::vector<PressLight> light;
  for (const TakenPress& press : done_.presses)
    if (press.left_out.empty()) light.push_back({press.name, 100 * press.sign.light_change});
  document_.heading(tr("Light"));
  PressLightPlot plot;
  dress(plot);
  plot.set_data(std::move(light), 100 * kOtherLight);
  add_plot(
      plot,
      190,
      tr("How much brighter the untouched face is than in its reference, in the order in which "
         "the presses were given. Good: all near zero. All alike beyond a dashed line: other "
         "light than when the reference was taken. Up and down: automatic exposure, or light "
         "that gets in."));
}

void Pages::add_remarks() {
  QStringList remarks;
  for (const std::string& remark : done_.calibration.remarks) remarks << sentence(remark);
  for (const std::string& warning : done_.about_settings) remarks << sentence(warning);
  if (remarks.isEmpty()) return;
  document_.heading(tr("Remarks"));
  document_.list(remarks);
}

/// Only what was there when it was calibrated: made again it must be the same.
void Pages::add_history() {
  const auto checks = load_checks(folder_, nullptr);
  if (!checks) return;
  HistoryData data;
  for (const CheckEntry& check : *checks) {
    if (check.time > done_.inputs.date) continue;
    data.points.push_back({seconds_of(check.time).value_or(0), check.error_mm});
    data.drifting_above_mm = check.drifting_above_mm;
    data.recalibrate_above_mm = check.recalibrate_above_mm;
  }
  if (data.points.empty()) return;
  document_.heading(tr("Checks before this calibration"));
  HistoryPlot plot;
  dress(plot);
  plot.set_data(std::move(data));
  add_plot(
      plot,
      250,
      tr("What alltact check --presses found over time. The bands are those of the last check. A "
         "line that climbs: lamps that age, or a layer that wears."));
}

void Pages::add_repetition() {
  document_.heading(tr("To make this calibration again"));
  document_.paragraph(
      tr("Everything it was made from is kept with the finger. In the folder above the finger's:"));
  document_.command(as_text(repeat_command(folder_)));
  document_.paragraph(
      tr("Add --exclude NAME to leave a press out, --include NAME to take it back."));
}

}  // namespace

Result<std::vector<ReportFile>> make_calibration_pages(const FingerCalibration& done,
                                                       const std::filesystem::path& folder,
                                                       const Job& job) {
  const Error stopped{"stopped before the report was written", "", ""};
  const auto document = Pages(done, folder).write(job);
  if (!document) return stopped;
  std::string html = document->html();
  if (job.stop_requested()) return stopped;
  auto pdf = document->pdf(done.inputs.date);
  if (!pdf) return pdf.error();
  return std::vector<ReportFile>{{"calibration_report.html", std::move(html)},
                                 {"calibration_report.pdf", std::move(pdf).value()}};
}

}  // namespace alltact
