#include "widgets/report/calibration_pages.h"

#include "calibration/checks/check_history.h"
#include "widgets/joined_words.h"
#include "widgets/plots/history_plot.h"
#include "widgets/report/report_pages.h"

namespace alltact {
namespace {

QString grade_word(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return text("Good");
    case Grade::kUsable:
      return text("Usable for contact and its place");
    case Grade::kUnproven:
      return text("Unproven");
    case Grade::kUnfit:
      break;
  }
  return text("Not fit to measure with");
}

Error stopped() {
  return {en::say("stopped before the report was written"), "", ""};
}

Meaning meaning_of(Grade grade) {
  if (grade == Grade::kGood) return Meaning::kGood;
  return grade == Grade::kUnfit ? Meaning::kBad : Meaning::kDoubtful;
}

}  // namespace

void ReportPages::add_verdict() {
  document_.box(grade_word(done_.verdict.grade),
                sentence(done_.verdict.reason),
                meaning_colour(meaning_of(done_.verdict.grade), light_));
  document_.paragraph(
      text("Good means at most %1 mm, usable at most %2 mm of mean error of press depth inside a "
           "contact, on presses that the mapping was made without.")
          .arg(mm(kGoodErrorMm, 2), mm(kUsableErrorMm, 2)));
  if (!done_.fault_signs.empty()) {
    QStringList signs;
    for (const Message& sign : done_.fault_signs) signs << sentence(sign);
    document_.box(text("The presses show a fault"),
                  signs.join('\n'),
                  meaning_colour(Meaning::kDoubtful, light_));
  }
  add_zones();
}

void ReportPages::add_zones() {
  std::vector<Document::Row> rows;
  QStringList unknown;
  for (const ZoneError& zone : done_.zones) {
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
  const Finger& finger = done_.finger;
  const CalibrationInputs& inputs = done_.inputs;
  std::vector<Document::Row> rows;
  const auto add = [&](const QString& name, const QString& value) {
    if (!value.isEmpty()) rows.push_back({{name, {}, 0}, {value, {}, 0}});
  };
  add(text("Date"), when(as_text(inputs.date)));
  add(text("Operator"),
      inputs.said.operator_name.empty() ? text("not told") : as_text(inputs.said.operator_name));
  add(text("Ball"),
      text("radius %1 mm").arg(inputs.said.ball_radius_mm) +
          (inputs.said.has_other_balls() ? text("; other balls stand beside their presses") : ""));
  add(text("Presses"),
      text("%1 used of %2 given")
          .arg(done_.calibration.balls.size() + done_.calibration.steps.size())
          .arg(done_.presses.size()));
  add(text("Camera"),
      text("%1, %2 x %3 px")
          .arg(QString::fromUtf8(to_string(finger.camera.model).data()))
          .arg(finger.camera.width_px)
          .arg(finger.camera.height_px));
  const QString taken_with = noted("press_settings");
  add(text("Camera and light"),
      taken_with.isEmpty() ? text("the pictures do not tell what they were taken with")
                           : taken_with);
  add(text("Reference"),
      noted("reference_date").isEmpty() ? text("installed with this calibration")
                                        : text("of %1").arg(when(noted("reference_date"))));
  add(text("Mapping"), sentence(done_.calibration.degree_choice));
  QStringList settings;
  for (const auto& setting : calibration_settings())
    settings << as_text(setting.name + " " + setting.get(inputs.calibration));
  add(text("Settings"), listed(settings));
  QStringList frames;
  const PipelineSettings usual;
  for (const auto& setting : pipeline_settings())
    if (setting.get(inputs.pipeline) != setting.get(usual))
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
  if (done_.methods.empty()) return;
  std::vector<Document::Row> rows;
  QStringList failed;
  for (const MethodRow& row : done_.methods) {
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
                   text("Residual (mm)"),
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
  for (const Message& remark : done_.calibration.remarks) remarks << sentence(remark);
  for (const Message& warning : done_.about_settings) remarks << sentence(warning);
  if (remarks.isEmpty()) return;
  document_.heading(text("Remarks"));
  document_.list(remarks);
}

/// Only what was there when it was calibrated: made again it must be the same.
void ReportPages::add_history() {
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
  document_.heading(text("Checks before this calibration"));
  HistoryPlot plot;
  dress(plot);
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
  return std::vector<ReportFile>{{kReportPage, std::move(html)},
                                 {kReportPaper, std::move(pdf).value()}};
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
