#include "widgets/report/calibration_pages.h"

#include "calibration/checks/check_history.h"
#include "widgets/joined_words.h"
#include "widgets/plots/history_plot.h"
#include "widgets/report/report_pages.h"
#include "widgets/verdict_text.h"

#include <cmath>

namespace alltact {
namespace {

Error stopped() {
  return {en::say("stopped before the report was written"), "", ""};
}

QString cause_words(ErrorCause cause) {
  switch (cause) {
    case ErrorCause::kShape:
      return text("shape of the mapping, by presses left out of it");
    case ErrorCause::kScale:
      return text("scale of the mapping as a whole");
    case ErrorCause::kPixel:
      return text("noise, reference and light of a single pixel");
    case ErrorCause::kZone:
      return text("parts of the face far from any press");
    case ErrorCause::kHalo:
      return text("light that scatters sideways");
    case ErrorCause::kBody:
      return text("bodies of other shape than the ball");
    case ErrorCause::kRadius:
      break;
  }
  return text("the ball's radius");
}

}  // namespace

void ReportPages::add_verdict() {
  const Verdict& worth = calibration_.verdict;
  const auto error = expected_error_mm(worth);
  QStringList lines;
  for (const Message& finding : findings_of(worth, calibration_.contradictions))
    lines << sentence(finding);
  if (!worth.cause.empty()) lines << sentence(worth.cause);
  if (!worth.rests_on.empty()) lines << text("It rests on: %1.").arg(as_text(worth.rests_on));
  const QString grade = phrase(word_of(worth.grade));
  document_.box(error ? text("%1, ±%2 mm").arg(grade, mm(*error)) : grade,
                lines.join('\n'),
                meaning_colour(meaning_of(worth.grade), light_));
  document_.paragraph(
      text("The expected error is what the next contact will be off by, all known causes together: "
           "two of three contacts are off by less. Good needs at most %1 mm, usable at most %2 mm, "
           "and every piece of evidence that is listed.")
          .arg(mm(kGoodErrorMm, 2), mm(kUsableErrorMm, 2)));
  add_causes();
  if (!calibration_.fault_signs.empty()) {
    QStringList signs;
    for (const Message& sign : calibration_.fault_signs) signs << sentence(sign);
    document_.box(text("The presses show a fault"),
                  signs.join('\n'),
                  meaning_colour(Meaning::kDoubtful, light_));
  }
  add_zones();
}

void ReportPages::add_causes() {
  std::vector<Document::Row> rows;
  for (const ErrorPart& part : calibration_.verdict.parts)
    rows.push_back({{cause_words(part.cause), {}, 0}, {mm(part.error_mm), {}, 0}});
  if (rows.empty()) return;
  if (std::isfinite(calibration_.verdict.error_mm))
    rows.push_back({{text("all together"), {}, 0}, {mm(calibration_.verdict.error_mm), {}, 0}});
  document_.table({text("Cause of error"), text("Mean depth error (mm)")}, rows, {false, true});
}

void ReportPages::add_zones() {
  std::vector<Document::Row> rows;
  QStringList unknown;
  for (const ZoneError& zone : calibration_.zones) {
    const QString name = as_text(zone.zone);
    if (!zone.error_mm) unknown << name;
    rows.push_back({{name, {}, 0},
                    {QString::number(zone.presses), {}, 0},
                    {zone.error_mm ? mm(*zone.error_mm) : text("unknown: no press there"), {}, 0}});
  }
  document_.heading(text("How good it is, by zone of the face"));
  document_.table(
      {text("Zone"), text("Presses"), text("Mean depth error (mm)")}, rows, {false, true, true});
  if (!unknown.isEmpty())
    document_.paragraph(text("Nothing was pressed here, so nothing is known of it: %1. Add a press "
                             "there, or do not rely on depth there.")
                            .arg(listed(unknown)));
}

void ReportPages::add_facts() {
  const Finger& finger = calibration_.finger;
  const CalibrationInputs& inputs = calibration_.inputs;
  std::vector<Document::Row> rows;
  const auto add = [&](const QString& name, const QString& value) {
    if (!value.isEmpty()) rows.push_back({{name, {}, 0}, {value, {}, 0}});
  };
  add(text("Date"), when(as_text(inputs.date)));
  add(text("Operator"),
      inputs.press_set.operator_name.empty() ? text("not told")
                                             : as_text(inputs.press_set.operator_name));
  add(text("Ball"),
      text("radius %1 mm").arg(inputs.press_set.ball_radius_mm) +
          (inputs.press_set.has_other_balls() ? text("; other balls stand beside their presses")
                                              : ""));
  add(text("Presses"),
      text("%1 used of %2 given")
          .arg(calibration_.calibration.balls.size() + calibration_.calibration.steps.size())
          .arg(calibration_.presses.size()));
  add(text("Camera"),
      text("%1, %2 x %3 px")
          .arg(QString::fromUtf8(to_string(finger.camera.model).data()))
          .arg(finger.camera.width_px)
          .arg(finger.camera.height_px));
  const QString taken_with = provenance_text("press_settings");
  add(text("Camera and light"),
      taken_with.isEmpty() ? text("the pictures do not tell what they were taken with")
                           : taken_with);
  add(text("Reference"),
      provenance_text("reference_date").isEmpty()
          ? text("installed with this calibration")
          : text("of %1").arg(when(provenance_text("reference_date"))));
  add(text("Mapping"), sentence(calibration_.calibration.degree_choice));
  QStringList settings;
  for (const auto& setting : calibration_settings())
    settings << as_text(setting.name + " " + setting.get(inputs.calibration));
  add(text("Settings"), listed(settings));
  QStringList frames;
  const PipelineSettings defaults;
  for (const auto& setting : pipeline_settings())
    if (setting.get(inputs.pipeline) != setting.get(defaults))
      frames << as_text(setting.name + " " + setting.get(inputs.pipeline));
  add(text("Other settings"), listed(frames));
  add(text("Program"), text("AllTact %1").arg(as_text(inputs.program_version)));
  document_.heading(text("What it was made with"));
  document_.table({}, rows, {});
}

QString ReportPages::method_words(CalibrationMethod method) {
  switch (method) {
    case CalibrationMethod::kJoint:
      return text("joint");
    case CalibrationMethod::kPaper:
      return text("paper");
    case CalibrationMethod::kCircle:
      return text("circle");
    case CalibrationMethod::kCone:
      break;
  }
  return text("cone");
}

void ReportPages::add_methods() {
  if (calibration_.methods.empty()) return;
  std::vector<Document::Row> rows;
  QStringList failed;
  for (const MethodRow& row : calibration_.methods) {
    const QString name = method_words(row.method);
    if (!row.failed.empty()) {
      failed << text("%1: %2").arg(name, as_text(row.failed));
      continue;
    }
    rows.push_back({{name, {}, 0},
                    {QString::number(row.presses), {}, 0},
                    {mm(row.press_depth_mm), {}, 0},
                    {mm(row.residual_mm), {}, 0},
                    {mm(row.at_depth_mm), {}, 0},
                    {mm(row.joint_depth_mm), {}, 0}});
  }
  document_.heading(text("Other methods on the same presses"));
  document_.table({text("Method"),
                   text("Presses"),
                   text("Mean depth (mm)"),
                   text("With them in the mapping (mm)"),
                   text("Reads (mm)"),
                   text("Joint reads (mm)")},
                  rows,
                  {false, true, true, true, true, true});
  document_.paragraph(text(
      "The joint method was used. The others find every ball from its dark border alone and are "
      "here to compare with. Presses: in how many a ball was found, and how deep these went on "
      "average. Reads: the depth for the darkest contact, beside what the joint method reads "
      "there. A border that fades where the skin leaves the ball is neither the ball's outline "
      "nor where it would leave a hard face, so the depths differ."));
  if (!failed.isEmpty()) document_.paragraph(failed.join('\n'));
}

void ReportPages::add_remarks() {
  QStringList remarks;
  for (const Message& remark : calibration_.calibration.remarks) remarks << sentence(remark);
  for (const Message& warning : calibration_.about_settings) remarks << sentence(warning);
  if (remarks.isEmpty()) return;
  document_.heading(text("Remarks"));
  document_.list(remarks);
}

/// Only entries from before the calibration: a repetition must give the same bytes.
void ReportPages::add_history() {
  const auto checks = load_checks(folder_, nullptr);
  if (!checks) return;
  HistoryData data;
  for (const CheckEntry& check : *checks) {
    if (check.time > calibration_.inputs.date) continue;
    data.points.push_back({unix_seconds(check.time).value_or(0), check.error_mm});
    data.drifting_above_mm = check.drifting_above_mm;
    data.recalibrate_above_mm = check.recalibrate_above_mm;
  }
  if (data.points.empty()) return;
  document_.heading(text("Checks before this calibration"));
  HistoryPlot plot;
  apply_style(plot);
  plot.set_data(std::move(data));
  add_plot(
      plot,
      250,
      text("What alltact check --presses found over time. The bands are those of the last check. A "
           "line that climbs: lamps that age, or a layer that wears."));
}

void ReportPages::add_repetition() {
  document_.heading(text("To make this calibration again"));
  document_.paragraph(text(
      "Everything it was made from is kept with the finger. In the folder above the finger's:"));
  document_.command(as_text(repeat_command(folder_)));
  document_.paragraph(
      text("Add --exclude NAME to leave a press out, --include NAME to take it back."));
}

Result<std::vector<ReportFile>> files_of(const Document& report,
                                         const std::string& date,
                                         const Job& job) {
  std::string html = report.html();
  if (job.stop_requested()) return stopped();
  auto pdf = report.pdf(date);
  if (!pdf) return pdf.error();
  return std::vector<ReportFile>{{kReportHtml, std::move(html)},
                                 {kReportPdf, std::move(pdf).value()}};
}

Result<std::vector<ReportFile>> make_calibration_pages(const FingerCalibration& done,
                                                       const std::filesystem::path& folder,
                                                       const Job& job) {
  auto faults = simulate_typical_faults(job);
  if (!faults) return faults.error();
  const std::shared_ptr<const FingerCalibration> lent(std::shared_ptr<void>(), &done);
  ReportPages pages(lent, folder, std::move(*faults));
  while (pages.write_next())
    if (job.stop_requested()) return stopped();
  return files_of(pages.document(), done.inputs.date, job);
}

}  // namespace alltact
