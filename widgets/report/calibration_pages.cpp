#include "widgets/report/calibration_pages.h"

#include "calibration/checks/check_history.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/report/press_resolution.h"
#include "core/base/atomic_file.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geometry/ball.h"
#include "widgets/image/image_view.h"
#include "widgets/language.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/plot.h"
#include "widgets/plots/press_plots.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/document.h"
#include "widgets/theme.h"
#include "widgets/verdict_text.h"

#include <QFont>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// An image of a calibration with one fault, and what it shows.
struct TypicalFault {
  const char* image;
  QString name, text;
};

std::vector<TypicalFault> typical_faults() {
  return {
      {"none", text("No fault"),
       text("One narrow cloud from zero to the deepest press, on the line.")},
      {"brighter_light", text("Other light than when the reference was taken"),
       text("Here 5 % more: all bars alike and beyond the dashed lines. The program corrects it "
            "and says so. Left uncorrected, every press would seem less deep.")},
      {"automatic_exposure", text("Automatic exposure"),
       text("Here another gain in every press, within 6 %: bars up and down. The program says so: "
            "lock exposure and gain, shade the finger, press again.")},
      {"moved_camera", text("Finger or camera moved after the reference"),
       text("Here by 0.45 mm. On a flat sensor in even light it does not show. Of a bending finger "
            "the program says when the reference does not hold the pose of most presses.")},
      {"loose_skin", text("Skin that leaves the ball, light at its edge"),
       text("Crosses away from the line near zero: towards the rim the skin no longer follows the "
            "ball, and swells brightly beside it. Common, and no fault as long as the dots lie on "
            "the line: only the inner part is used.")},
      {"wrong_radius", text("Wrong radius of the ball"),
       text("Here given 10 % too large: it looks as good as no fault, and every depth is 9 % too "
            "small. No residual shows a wrong radius. Measure the ball with callipers; a check "
            "with a ball of another size shows it (alltact check --presses --ball-radius-mm).")},
  };
}

/// Writes one report from top to bottom.
class ReportPages {
 public:
  ReportPages(std::shared_ptr<const FingerCalibration> done, std::filesystem::path folder)
      : shared_(std::move(done)),
        folder_(std::move(folder)),
        light_(theme_palette(Theme::kLight)),
        document_(text("Calibration of finger %1").arg(as_text(shared_->finger.name))) {}

  /// Writes the next part, in a fraction of a second. False: there is none left.
  bool write_next() {
    constexpr std::array kParts{
        &ReportPages::add_verdict,    &ReportPages::add_facts,         &ReportPages::add_presses,
        &ReportPages::add_mapping,    &ReportPages::add_errors,        &ReportPages::add_maps,
        &ReportPages::add_spread,     &ReportPages::add_resolution,    &ReportPages::add_methods,
        &ReportPages::add_light,      &ReportPages::add_remarks,       &ReportPages::add_history,
        &ReportPages::add_repetition, &ReportPages::add_typical_faults};
    if (next_ == kParts.size()) return false;
    (this->*kParts[next_++])();
    return true;
  }
  [[nodiscard]] const Document& document() const { return document_; }

 private:
  static constexpr int kFigureWidth = 600;   // px at 96 to the inch: the width of a printed page
  static constexpr double kSharpness = 2.0;  // pixels to each of these, for paper and dense screens

  void add_verdict();
  void add_causes();
  void add_zones();
  void add_facts();
  [[nodiscard]] QString press_words(const BallFit& ball) const;
  static QString punch_words(const StepFit& step);
  static QString body_words(const BodyFit& body);
  void add_presses();
  void add_left_out();
  void add_mapping();
  void add_errors();
  void add_maps();
  void add_map(FaceQuantity quantity, const QString& caption);
  void add_spread();
  void add_resolution();
  static QString method_words(CalibrationMethod method);
  void add_methods();
  void add_light();
  void add_remarks();
  void add_history();
  void add_repetition();
  void add_typical_faults();

  void add_plot(Plot& plot, int height, const QString& caption) {
    document_.figure(plot.image({kFigureWidth, height}, kSharpness), kFigureWidth, caption);
  }
  static QFont plot_font() {
    QFont font("DejaVu Sans");
    font.setPixelSize(12);
    return font;
  }
  void apply_style(Plot& plot) const {
    plot.setFont(plot_font());
    plot.setPalette(light_);
  }
  [[nodiscard]] std::vector<Eigen::Vector2d> contact_pixels_of(const BallFit& ball) const {
    std::vector<Eigen::Vector2d> pixels;
    for (const PressResiduals& press : calibration_.residuals)
      if (press.press == ball.press)
        for (const ResidualSample& sample : press.samples) pixels.push_back(sample.pixel);
    return pixels;
  }
  [[nodiscard]] QString provenance_text(const char* key) const {
    const auto found = calibration_.finger.provenance.find(key);
    return found == calibration_.finger.provenance.end() ? QString() : as_text(found->second);
  }

  const std::shared_ptr<const FingerCalibration> shared_;
  const FingerCalibration& calibration_ = *shared_;
  const std::filesystem::path folder_;
  std::size_t next_ = 0;
  const QPalette light_;
  Document document_;
};

Error stopped() { return {en::say("stopped before the report was written"), "", ""}; }

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
  if (!worth.rests_on.empty()) lines << text("Based on: %1.").arg(as_text(worth.rests_on));
  const QString grade = phrase(word_of(worth.grade));
  document_.box(error ? text("%1, ±%2 mm").arg(grade, mm(*error)) : grade, lines.join('\n'),
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
    document_.box(text("The presses show a fault"), signs.join('\n'),
                  meaning_colour(Meaning::kDoubtful, light_));
  }
  add_zones();
}

void ReportPages::add_causes() {
  std::vector<Document::Row> rows;
  for (const ErrorPart& part : calibration_.verdict.parts)
    rows.push_back({{cause_words(part.cause)}, {mm(part.error_mm)}});
  if (rows.empty()) return;
  if (std::isfinite(calibration_.verdict.error_mm))
    rows.push_back({{text("all together")}, {mm(calibration_.verdict.error_mm)}});
  document_.table({text("Cause of error"), text("Mean depth error (mm)")}, rows, {false, true});
}

void ReportPages::add_zones() {
  std::vector<Document::Row> rows;
  QStringList unknown;
  for (const ZoneError& zone : calibration_.zones) {
    const QString name = as_text(zone.zone);
    if (!zone.error_mm) unknown << name;
    rows.push_back({{name},
                    {QString::number(zone.presses)},
                    {zone.error_mm ? mm(*zone.error_mm) : text("unknown: no press there")}});
  }
  document_.heading(text("How good it is, by zone of the face"));
  document_.table({text("Zone"), text("Presses"), text("Mean depth error (mm)")}, rows,
                  {false, true, true});
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
    if (!value.isEmpty()) rows.push_back({{name}, {value}});
  };
  add(text("Date"), when(as_text(inputs.date)));
  add(text("Operator"), inputs.press_set.operator_name.empty()
                            ? text("not told")
                            : as_text(inputs.press_set.operator_name));
  add(text("Ball"),
      text("radius %1 mm").arg(inputs.press_set.ball_radius_mm) +
          (inputs.press_set.has_other_balls() ? text("; other balls stand beside their presses")
                                              : ""));
  add(text("Presses"),
      text("%1 used of %2 given")
          .arg(calibration_.calibration.balls.size() + calibration_.calibration.steps.size() +
               calibration_.calibration.bodies.size())
          .arg(calibration_.presses.size()));
  add(text("Camera"), text("%1, %2 x %3 px")
                          .arg(QString::fromUtf8(to_string(finger.camera.model).data()))
                          .arg(finger.camera.width_px)
                          .arg(finger.camera.height_px));
  const QString taken_with = provenance_text("press_settings");
  add(text("Camera and light"), taken_with.isEmpty()
                                    ? text("the pictures do not tell what they were taken with")
                                    : taken_with);
  add(text("Reference"), provenance_text("reference_date").isEmpty()
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
    rows.push_back({{name},
                    {QString::number(row.presses)},
                    {mm(row.press_depth_mm)},
                    {mm(row.residual_mm)},
                    {mm(row.at_depth_mm)},
                    {mm(row.joint_depth_mm)}});
  }
  document_.heading(text("Other methods on the same presses"));
  document_.table(
      {text("Method"), text("Presses"), text("Mean depth (mm)"),
       text("With them in the mapping (mm)"), text("Reads (mm)"), text("Joint reads (mm)")},
      rows, {false, true, true, true, true, true});
  document_.paragraph(
      text("The joint method was used. The others find every ball from its dark border alone and "
           "are here to compare with. Presses: in how many a ball was found, and how deep these "
           "went on average. Reads: the depth for the darkest contact, beside what the joint "
           "method reads there. A border that fades where the skin leaves the ball is neither the "
           "ball's outline nor where it would leave a hard face, so the depths differ."));
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
  add_plot(plot, 250,
           text("What alltact check --presses found over time. The bands are those of the last "
                "check. A line that climbs: lamps that age, or a layer that wears."));
}

void ReportPages::add_repetition() {
  document_.heading(text("To make this calibration again"));
  document_.paragraph(text(
      "Everything it was made from is kept with the finger. In the folder above the finger's:"));
  document_.command(as_text(repeat_command(folder_)));
  document_.paragraph(
      text("Add --exclude NAME to leave a press out, --include NAME to take it back."));
}

void ReportPages::add_typical_faults() {
  document_.new_page();
  document_.heading(text("Typical faults, and what they look like"));
  document_.paragraph(text(
      "Each picture is a calibration with four presses on a small flat sensor, simulated with this "
      "fault and nothing else. Compare them with your own."));
  std::vector<Document::Row> rows;
  for (const TypicalFault& fault : typical_faults()) {
    const QImage image(QStringLiteral(":/alltact/pictures/faults/%1.png").arg(fault.image));
    assert(!image.isNull());
    const int width = static_cast<int>(image.width() / kSharpness);
    rows.push_back({{QString(), image, width}, {fault.name + ".\n" + fault.text}});
  }
  document_.table({}, rows, {});
}

Result<std::vector<ReportFile>> files_of(const Document& report, const std::string& date,
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
  const std::shared_ptr<const FingerCalibration> lent(std::shared_ptr<void>(), &done);
  ReportPages pages(lent, folder);
  while (pages.write_next())
    if (job.stop_requested()) return stopped();
  return files_of(pages.document(), done.inputs.date, job);
}

namespace {

constexpr double kRoom = 1.45;  // shown region, in sizes of the outline

/// The hull of all pixels.
QPolygonF border_of(const std::vector<Eigen::Vector2d>& pixels) {
  std::vector<cv::Point2f> points, hull;
  for (const Eigen::Vector2d& pixel : pixels)
    points.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  QPolygonF border;
  if (points.size() < 3) return border;
  cv::convexHull(points, hull);
  for (const cv::Point2f& point : hull)
    border << QPointF(static_cast<double>(point.x), static_cast<double>(point.y));
  return border;
}

/// Visible on any background: a dark line below a light one.
void draw_line(QPainter& painter, const QPainterPath& path, Qt::PenStyle style) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4));
  painter.drawPath(path);
  painter.setPen(QPen(QColor(style == Qt::SolidLine ? "#ffb000" : "#ffffff"), 2, style));
  painter.drawPath(path);
}

}  // namespace

QImage press_image(const cv::Mat& grey, const Camera& camera, const BallFit& ball,
                   const std::vector<Eigen::Vector2d>& contact_pixels, const QSize& size) {
  const auto outline = ball_outline_px(camera, ball.centre_mm, ball.radius_mm, 180);
  if (outline.size() < 3) return full_image(grey, size);
  QPolygonF polygon;
  for (const Eigen::Vector2d& point : outline) polygon << QPointF(point.x(), point.y());
  const QRectF ball_box = polygon.boundingRect();
  // The largest scale at which the region fits into `size` with its proportions.
  const double scale = std::min(size.width() / (kRoom * ball_box.width()),
                                size.height() / (kRoom * ball_box.height()));
  QImage image(size, QImage::Format_RGB32);
  image.fill(QColor("#808080"));
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  // The centre of the top-left pixel is (0, 0); the image's corner is half a pixel before it.
  QTransform to_image;
  to_image.translate(0.5 * size.width(), 0.5 * size.height());
  to_image.scale(scale, scale);
  to_image.translate(-ball_box.center().x(), -ball_box.center().y());
  painter.setTransform(to_image);
  painter.drawImage(QPointF(-0.5, -0.5), grey_image(grey));
  painter.resetTransform();
  QPainterPath path;
  path.addPolygon(to_image.map(polygon));
  path.closeSubpath();
  const auto middle = camera.project(ball.centre_mm);
  if (middle) {
    const QPointF at = to_image.map(QPointF(middle->x(), middle->y()));
    path.moveTo(at - QPointF(5, 0));
    path.lineTo(at + QPointF(5, 0));
    path.moveTo(at - QPointF(0, 5));
    path.lineTo(at + QPointF(0, 5));
  }
  draw_line(painter, path, Qt::SolidLine);
  const QPolygonF border = to_image.map(border_of(contact_pixels));
  QPainterPath contact;
  contact.addPolygon(border);
  contact.closeSubpath();
  if (border.size() > 2) draw_line(painter, contact, Qt::DashLine);
  return image;
}

QImage full_image(const cv::Mat& grey, const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(QColor("#808080"));
  const QImage small = grey_image(grey).scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  QPainter painter(&image);
  painter.drawImage((size.width() - small.width()) / 2, (size.height() - small.height()) / 2,
                    small);
  return image;
}

struct ReportWriter::Pages {
  Pages(std::shared_ptr<const FingerCalibration> done, const std::filesystem::path& into)
      : folder(into), date(done->inputs.date), pages(std::move(done), into) {}

  const std::filesystem::path folder;
  const std::string date;
  ReportPages pages;
  std::mutex writing;
  bool is_stopped = false;  ///< nothing may be written any more
};

ReportWriter::ReportWriter(QObject* parent) : QObject(parent) {}
ReportWriter::~ReportWriter() { stop(); }

void ReportWriter::start(std::shared_ptr<const FingerCalibration> done,
                         const std::filesystem::path& folder) {
  stop();
  problem_.reset();
  const EnglishScope as_for_the_lab_book;
  pages_ = std::make_shared<Pages>(std::move(done), folder);
  QTimer::singleShot(0, this, [this, pages = pages_] { draw(pages); });
}

void ReportWriter::stop() {
  if (pages_) {
    const std::lock_guard lock(pages_->writing);
    pages_->is_stopped = true;
  }
  pages_.reset();
  work_.reset();
}

void ReportWriter::draw(const std::shared_ptr<Pages>& pages) {
  if (pages != pages_) return;
  bool is_drawn = false;
  {
    const EnglishScope as_for_the_lab_book;
    is_drawn = !pages->pages.write_next();
  }
  QTimer::singleShot(0, this, [this, pages, is_drawn] { is_drawn ? write(pages) : draw(pages); });
}

void ReportWriter::write(const std::shared_ptr<Pages>& pages) {
  if (pages != pages_) return;
  work_ = std::make_unique<BackgroundWork>();
  work_->start([this, pages](const Job& job) {
    const auto written = std::make_shared<Status>();
    const auto files = files_of(pages->pages.document(), pages->date, job);
    if (!files) *written = files.error();
    const std::lock_guard lock(pages->writing);
    for (std::size_t i = 0; files && i < files->size() && *written && !pages->is_stopped; ++i)
      *written = write_file_atomically(pages->folder / (*files)[i].name, (*files)[i].content);
    return std::function<void()>([this, pages, written] {
      if (pages == pages_) end(*written);
    });
  });
}

void ReportWriter::end(const Status& how) {
  pages_.reset();
  if (!how) problem_ = how.error();
  Q_EMIT finished();
}

// Report pages: image and figures of each press, and its light.

namespace {

constexpr int kImageWidth = 132;  // of a press

}  // namespace

QString ReportPages::press_words(const BallFit& ball) const {
  QString words = as_text(ball.press);
  if (calibration_.inputs.press_set.has_other_balls())
    words += "\n" + text("ball %1 mm").arg(ball.radius_mm);
  if (ball.cut_by_edge) words += "\n" + text("cut by the edge");
  if (ball.given_depth)
    words += "\n" + text("measured %1 ± %2 mm deep, the solution has %3 mm")
                        .arg(mm(ball.given_depth->mm), sd_number(ball.given_depth->sd_mm, 3),
                             mm(ball.indentation_mm));
  return words;
}

QString ReportPages::punch_words(const StepFit& step) {
  return text("a punch with a step of %1 mm, which reads %2 ± %3 mm")
      .arg(mm(step.step_mm), mm(step.estimated_mm), sd_number(step.sd_mm, 3));
}

QString ReportPages::body_words(const BodyFit& body) {
  return text("%1, on which depths read %2 ± %3 % of the true ones")
      .arg(as_text(body.body), plain_number(100 * body.scale, 1), sd_number(100 * body.sd, 1));
}

void ReportPages::add_presses() {
  document_.new_page();
  document_.heading(text("The presses, worst first"));
  std::map<std::string, const MeasuredPress*> taken;
  for (const MeasuredPress& press : calibration_.presses) taken[press.name] = &press;
  std::vector<const BallFit*> balls;
  for (const BallFit& ball : calibration_.calibration.balls) balls.push_back(&ball);
  const auto worst = [](const BallFit* ball) { return press_error_mm(*ball).value_or(0.0); };
  std::stable_sort(balls.begin(), balls.end(),
                   [&](const BallFit* a, const BallFit* b) { return worst(a) > worst(b); });
  const auto camera = Camera::create(calibration_.finger.camera);
  const QSize size = QSize(kImageWidth, kImageWidth * 3 / 4) * kSharpness;
  std::vector<Document::Row> rows;
  for (const BallFit* ball : balls) {
    const auto press = taken.find(ball->press);
    const auto error = press_error_mm(*ball);
    QImage image;
    if (camera && press != taken.end())
      image = press_image(press->second->grey, *camera, *ball, contact_pixels_of(*ball), size);
    rows.push_back(
        {{QString(), image, kImageWidth},
         {press_words(*ball)},
         {mm(ball->depth_mm)},
         {mm(ball->residual_mm)},
         {error ? mm(*error) : text("unknown")},
         {mm(ball->centre_sd_mm.z())},
         {press == taken.end() ? QString() : percent(press->second->sign.light_change)}});
  }
  const auto add_other = [&](const std::string& name, const QString& words) {
    const auto press = taken.find(name);
    if (press == taken.end()) return;
    rows.push_back({{QString(), full_image(press->second->grey, size), kImageWidth},
                    {as_text(name) + "\n" + words},
                    {text("none")},
                    {text("none")},
                    {text("none")},
                    {text("none")},
                    {percent(press->second->sign.light_change)}});
  };
  for (const StepFit& step : calibration_.calibration.steps)
    add_other(step.press, punch_words(step));
  for (const BodyFit& body : calibration_.calibration.bodies)
    add_other(body.press, body_words(body));
  document_.image_table(
      {text("Image"), text("Press"), text("Depth (mm)"), text("With this press (mm)"),
       text("Error (mm)"), text("Ball's distance, sd (mm)"), text("Light (%)")},
      rows, {false, false, true, true, true, true, true});
  document_.paragraph(
      text("Orange: the outline of the ball as it was found, with its middle. Dashed: what the "
           "ball touches; the dark contact must lie in there, or something else was taken for the "
           "ball. Depth: the deepest point. Error: mapping minus ball inside the contact, on "
           "average, with a mapping made without this press; this is the figure that counts. With "
           "this press: the same with the final mapping, which this press helped to make. Ball's "
           "distance, sd: how well the ball's distance from the camera is known. Light: how much "
           "brighter the untouched face is than in the reference; it should be 0 within 1 %."));
  add_left_out();
}

void ReportPages::add_left_out() {
  std::vector<Document::Row> rows;
  for (const MeasuredPress& press : calibration_.presses) {
    if (press.left_out.empty()) continue;
    rows.push_back(
        {{QString(), full_image(press.grey, QSize(kImageWidth, kImageWidth * 9 / 16) * kSharpness),
          kImageWidth},
         {as_text(press.name)},
         {sentence(press.left_out)}});
  }
  QStringList reasons;
  for (const Message& reason : calibration_.calibration.left_out) {
    const bool shown =
        std::any_of(calibration_.presses.begin(), calibration_.presses.end(), [&](const auto& one) {
          return !one.left_out.empty() && reason.english().rfind(one.name + ": ", 0) == 0;
        });
    if (!shown) reasons << sentence(reason);
  }
  if (rows.empty() && reasons.isEmpty()) return;
  document_.new_page();
  document_.heading(text("Presses that were left out"));
  if (!rows.empty()) document_.image_table({text("Image"), text("Press"), text("Why")}, rows, {});
  if (!reasons.isEmpty()) document_.list(reasons);
}

void ReportPages::add_light() {
  std::vector<PressLight> light;
  for (const MeasuredPress& press : calibration_.presses)
    if (press.left_out.empty()) light.push_back({press.name, 100 * press.sign.light_change});
  document_.heading(text("Light"));
  PressLightPlot plot;
  apply_style(plot);
  plot.set_data(std::move(light), 100 * kOtherLight);
  add_plot(plot, 190,
           text("How much brighter the untouched face is than in its reference, in the order in "
                "which the presses were given. Good: all near zero. All alike beyond a dashed "
                "line: other light than when the reference was taken. Up and down: automatic "
                "exposure, or light that gets in."));
}

// Report pages: the mapping, and its errors by press, by position and by size.

void ReportPages::add_mapping() {
  document_.new_page();
  document_.heading(text("From brightness to depth"));
  if (!calibration_.calibration.mapping.variation.is_none())
    document_.paragraph(
        text("The mapping varies over the face; shown is the middle of the face, the points as "
             "they would be there."));
  MappingPlot plot;
  apply_style(plot);
  plot.set_data(mapping_figure(calibration_.calibration, calibration_.residuals));
  add_plot(plot, 340,
           text("Each point is a block of pixels under a ball: how much darker it became, and how "
                "deep the ball is there. The line is the mapping, the band two standard deviations "
                "of it. Good: one narrow cloud around the line, reaching to the deepest presses "
                "you will measure. Two clouds side by side: presses that do not agree. Crosses far "
                "off the line belong to the rim, where skin leaves the ball, and are not used."));
}

void ReportPages::add_errors() {
  constexpr std::size_t kFewPresses = 8;  // their bars fit below the mapping
  if (calibration_.calibration.balls.size() > kFewPresses) document_.new_page();
  document_.heading(text("Errors"));
  PressErrorPlot bars;
  apply_style(bars);
  bars.set_data(press_errors(calibration_.calibration));
  add_plot(bars, bars.comfortable_height(),
           text("Good: all bars alike. One bar much longer than the others: look at that press' "
                "picture above, and leave it out if it shows anything but one clean ball. Much "
                "longer without the press than with it: this press shows something that no other "
                "does; press more like it."));
}

void ReportPages::add_map(FaceQuantity quantity, const QString& caption) {
  FaceMapPlot plot;
  apply_style(plot);
  plot.set_data(face_figure(quantity, calibration_.calibration, calibration_.residuals,
                            calibration_.finger.face.kind));
  const FaceMapData data = face_figure(quantity, calibration_.calibration, calibration_.residuals,
                                       calibration_.finger.face.kind);
  // The face in its proportions, within limits.
  const double ratio = data.length_mm > 0 ? data.width_mm / data.length_mm : 0.4;
  add_plot(plot, 62 + static_cast<int>(470 * std::clamp(ratio, 0.2, 0.45)), caption);
}

void ReportPages::add_maps() {
  document_.new_page();
  document_.heading(text("Where on the face"));
  add_map(FaceQuantity::kResidual,
          text("Mapping minus ball, mean of each square millimetre. Good: no pattern. Errors that "
               "grow towards one end or one side point to light or shape there."));
  if (calibration_.calibration.held_out_mm > 0)
    add_map(FaceQuantity::kHeldOut,
            text("Error of each press when the mapping was made without it. Hatched: nothing was "
                 "pressed there, nothing is known."));
  add_map(FaceQuantity::kCoverage, text("How deep the presses went, and where. Press next where it "
                                        "is hatched, and as deep as you will measure."));
}

void ReportPages::add_spread() {
  document_.new_page();
  document_.heading(text("How errors are spread"));
  HistogramPlot histogram;
  apply_style(histogram);
  histogram.set_data(all_errors(calibration_.residuals), text("Mapping minus ball (mm)"));
  add_plot(histogram, 260,
           text("Errors of all blocks in the inner part of the contacts. Good: one hill around "
                "zero. A second hill or a hill beside zero: something differs between presses."));
}

void ReportPages::add_resolution() {
  const auto worst = worst_resolution(calibration_.residuals);
  if (!worst) return;
  document_.heading(text("How fine it resolves"));
  document_.paragraph(sentence(resolution_sentence(calibration_.residuals, calibration_.halo)));
  std::vector<Document::Row> rows;
  for (const PressResiduals& one : calibration_.residuals)
    if (one.resolution)
      rows.push_back({{as_text(one.press)},
                      {mm(one.along_mm, 1)},
                      {mm(one.resolution->two_points_mm, 2)},
                      {mm(one.resolution->wall_mm, 2)},
                      {mm(one.resolution->pin_mm, 2)},
                      {mm(one.resolution->step_mm, 2)}});
  document_.table({text("Press"), text("Along the face (mm)"), text("Two points (mm)"),
                   text("Wall (mm)"), text("Pin (mm)"), text("Beside a step (mm)")},
                  rows, {false, true, true, true, true, true});
  ContrastPlot plot;
  apply_style(plot);
  plot.set_data(worst->contrasts);
  add_plot(plot, 220,
           text("How much of the depth of a fine wave is measured, where it is worst. Two points "
                "are resolved where the depth between them falls to four fifths. Walls, pins and "
                "the surroundings of a step are right within a tenth from the size in the table "
                "on. Computed from the size of a pixel, the smoothing and the light's spread, for "
                "a lens in focus. Skin that does not follow a sharp edge is blunter."));
}

}  // namespace alltact
