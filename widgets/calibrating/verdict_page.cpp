#include "widgets/calibrating/verdict_page.h"

#include "calibration/checks/check_history.h"
#include "calibration/report/press_resolution.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/mapping_page.h"
#include "widgets/language.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/document.h"
#include "widgets/theme.h"
#include "widgets/verdict_text.h"

#include <QClipboard>
#include <QDateTime>
#include <QDesktopServices>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLocale>
#include <QPrintDialog>
#include <QPrinter>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kVerdictSymbol = 40;
constexpr int kMinPlotHeight = 110;
constexpr int kTextSpacing = 1;
constexpr std::size_t kShownFindings = 4;  // the others come first in the remarks

}  // namespace

VerdictPage::VerdictPage(CalibrationRun& run, QWidget* parent)
    : StepPage(parent),
      run_(run),
      symbol_(new QLabel),
      grade_(new QLabel),
      findings_(wrapped_text()),
      sentence_(wrapped_text()),
      zones_(wrapped_text()),
      task_(new QPushButton),
      running_(new QProgressBar),
      next_(wrapped_text()),
      face_(new FaceMapPlot),
      remarks_(new QListWidget),
      print_(new QPushButton),
      report_(new QPushButton),
      copy_(new QPushButton),
      figures_(new QWidget),
      errors_(new PressErrorPlot),
      mapping_(new MappingPlot),
      fold_(new QToolButton),
      fold_more_(new QToolButton),
      folded_(new QWidget),
      more_(new MoreDataBox),
      report_state_(wrapped_text()),
      command_(wrapped_text()) {
  auto* column = without_margins(new QVBoxLayout(this));
  column->setSpacing(2);
  make_head(*column);
  for (Plot* plot : std::initializer_list<Plot*>{face_, errors_, mapping_})
    plot->setMinimumHeight(kMinPlotHeight);
  column->addWidget(face_, 1);
  auto* figures = without_margins(new QHBoxLayout(figures_));
  figures->addWidget(errors_, 1);
  figures->addWidget(mapping_, 1);
  column->addWidget(figures_, 1);
  make_foot(*column);
  connect(print_, &QPushButton::clicked, this, &VerdictPage::print);
  connect(task_, &QPushButton::clicked, this, &VerdictPage::do_task);
  connect(report_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(run_.report().string())));
  });
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(run_.command_line()); });
  for (const auto& [one, other] : {std::pair(fold_, fold_more_), std::pair(fold_more_, fold_)})
    connect(one, &QToolButton::toggled, this, [this, other = other](bool is_open) {
      if (is_open) other->setChecked(false);
      show_folds();
    });
  connect(&run_, &CalibrationRun::changed, this, &VerdictPage::show_status);
  say([this] {
    remarks_->setAccessibleName(tr("Remarks"));
    running_->setAccessibleName(tr("Progress of the calibration"));
    print_->setText(tr("&Print…"));
    print_->setShortcut(QKeySequence::Print);  // setText() removes the shortcut
    print_->setToolTip(tr("One sheet to store with the finger, on paper or as PDF"));
    report_->setText(tr("&Open the report"));
    report_->setToolTip(tr("Opens the report of the calibration for the lab book (PDF)"));
    copy_->setText(tr("Copy as command &line"));
    copy_->setToolTip(tr("Copies the command that repeats this calibration in a terminal"));
    command_->setAccessibleName(tr("The same as a command line"));
    mapping_->setAccessibleName(tr("Depth over brightness difference"));
    errors_->setAccessibleName(tr("Error of every press, worst first"));
    shown_.reset();
    show_status();
  });
}

void VerdictPage::make_head(QVBoxLayout& column) {
  auto* head = new QHBoxLayout;
  head->addWidget(symbol_, 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  words->setSpacing(kTextSpacing);
  QFont large = grade_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  large.setBold(true);
  grade_->setFont(large);
  grade_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  add_widgets(*words, {grade_, findings_, sentence_, zones_, next_});
  head->addLayout(words, 1);
  auto* side = new QVBoxLayout;
  side->addWidget(task_);
  side->addWidget(running_);
  side->addStretch();
  head->addLayout(side);
  column.addLayout(head);
}

void VerdictPage::make_foot(QVBoxLayout& column) {
  auto* buttons = new QHBoxLayout;
  for (QToolButton* fold : {fold_, fold_more_}) {
    fold->setCheckable(true);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  add_widgets(*buttons, {print_, report_, copy_, fold_, fold_more_});
  buttons->addWidget(report_state_, 1);
  column.addLayout(buttons);
  auto* inside = without_margins(new QVBoxLayout(folded_));
  remarks_->setWordWrap(true);
  remarks_->setMaximumHeight(110);
  inside->addWidget(remarks_);
  QFont mono(QStringLiteral("monospace"));
  mono.setStyleHint(QFont::Monospace);
  command_->setFont(mono);
  command_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  inside->addWidget(command_);
  column.addWidget(folded_);
  column.addWidget(more_);
}

void VerdictPage::show_folds() {
  const int count = shown_ ? remarks_->count() : 0;
  const bool has_more = more_->finger() != nullptr;
  fold_->setText(tr("Remarks (%1)").arg(count));
  fold_->setToolTip(tr("Shows the remarks instead of the figures"));
  fold_more_->setText(MoreDataBox::tr("Benefit of more data"));
  fold_more_->setToolTip(tr("Shows what more presses would bring instead of the figures"));
  fold_more_->setVisible(has_more);
  for (QToolButton* fold : {fold_, fold_more_})
    fold->setArrowType(fold->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  folded_->setVisible(fold_->isChecked());
  more_->setVisible(fold_more_->isChecked() && has_more);
  figures_->setVisible(!fold_->isChecked() && !more_->isVisibleTo(this));
  remarks_->setVisible(shown_ != nullptr);
}

void VerdictPage::print() {
  if (shown_) print_sheet(verdict_sheet(*shown_, run_.command_line(), run_.worth()), *this);
}

StepState VerdictPage::state() const {
  if (run_.state() == CalibrationState::kNone) return StepState::kToDo;
  const auto known = verdict_of(run_);
  const bool is_proven = known && (known->grade == Grade::kGood || known->grade == Grade::kUsable);
  return run_.state() == CalibrationState::kCurrent && is_proven ? StepState::kDone
                                                                 : StepState::kOutdated;
}

VerdictPage::Task VerdictPage::task() const {
  if (run_.state() == CalibrationState::kNone) return Task::kNone;
  if (run_.is_running() || run_.state() == CalibrationState::kStale || !known_) return Task::kAgain;
  if (known_->missing_names.empty()) return Task::kNone;
  const std::string_view worst = known_->missing_names.front();
  if (worst == "basis_stored" || worst == "complete") return Task::kAgain;
  if (worst == "fresh") return Task::kCheck;
  // Scattered light, and an error between good and usable, are measured: no evidence is missing.
  return known_->grade == Grade::kUsable ? Task::kNone : Task::kPresses;
}

const QPushButton* VerdictPage::action_button() const {
  return task() != Task::kNone && task_->isEnabled() ? task_ : nullptr;
}

void VerdictPage::do_task() {
  switch (task()) {
    case Task::kAgain:
      return run_.start();
    case Task::kPresses:
      Q_EMIT presses_requested();
      return;
    case Task::kCheck:
      Q_EMIT check_requested();
      return;
    case Task::kNone:
      return;
  }
}

void VerdictPage::show_task() {
  const Task now = task();
  task_->setVisible(now != Task::kNone);
  task_->setToolTip(tr("What improves this finger's depth most now"));
  task_->setEnabled(now != Task::kAgain || run_.can_start());
  task_->setText(now == Task::kPresses ? tr("Go to the presses")
                 : now == Task::kCheck ? tr("Go to the check")
                                       : tr("&Calibrate again"));
  running_->setVisible(run_.is_running());
  running_->setValue(static_cast<int>(100 * run_.work().fraction()));
}

QString VerdictPage::missing() const {
  return run_.state() == CalibrationState::kNone ? tr("Calibrate first.") : QString();
}

/// Grade, contradictions or missing evidence, and the basis of the verdict; always visible.
void VerdictPage::show_head() {
  known_ = verdict_of(run_);
  const auto& worth = run_.worth();
  const Headline headline =
      !known_ ? Headline{run_.state() == CalibrationState::kNone
                             ? tr("Not calibrated yet")
                             : tr("Calibrated; accuracy not stored"),
                         Meaning::kDoubtful}
              : headline_of(known_->grade, expected_error_mm(*known_).value_or(0.0),
                            worth->must_repeat, worth->reference);
  symbol_->setPixmap(symbol(meaning_symbol(headline.meaning),
                            meaning_colour(headline.meaning, palette()), kVerdictSymbol,
                            devicePixelRatioF()));
  grade_->setText(headline.text);
  QStringList findings;
  if (known_) {
    const auto all = findings_of(*known_, worth->evidence->contradictions);
    for (std::size_t i = 0; i < std::min(all.size(), kShownFindings); ++i)
      findings << tr("• %1", "an item of a list").arg(window_sentence(all[i]));
    if (all.size() > kShownFindings)
      findings << tr("• %n more at the top of the remarks.", nullptr,
                     static_cast<int>(all.size() - kShownFindings));
  }
  if (run_.state() == CalibrationState::kStale && !(worth && worth->must_repeat))
    findings.prepend(tr("• The presses have changed since: calibrate again."));
  findings_->setText(findings.join(QLatin1Char('\n')));
  findings_->setVisible(!findings.isEmpty());
  QStringList words;
  if (known_) {
    const bool is_vouched = expected_error_mm(*known_).has_value();
    if (!is_vouched && std::isfinite(known_->error_mm) && !worth->must_repeat)
      words << tr("Expected error so far: ±%1 mm.").arg(local_mm(known_->error_mm, 3));
    if (!known_->cause.empty() && !worth->must_repeat) words << window_sentence(known_->cause);
    if (!known_->rests_on.empty())
      words << tr("Based on: %1.").arg(in_window_language(known_->rests_on));
  }
  sentence_->setText(words.join(QLatin1Char(' ')));
  sentence_->setVisible(!words.isEmpty());
}

void VerdictPage::show_status() {
  show_head();
  show_task();
  more_->set_finger(run_.state() == CalibrationState::kCurrent ? run_.finger() : nullptr);
  report_->setEnabled(!run_.report().empty());
  print_->setEnabled(run_.result() != nullptr);
  copy_->setEnabled(run_.state() != CalibrationState::kNone);
  command_->setVisible(run_.state() != CalibrationState::kNone);
  command_->setText(run_.command_line());
  report_state_->setText(run_.is_writing_report() ? tr("The report is being written.")
                         : run_.report_problem() ? window_sentence(run_.report_problem()->message())
                                                 : QString());
  const QString findings = findings_->text();
  if (run_.result() != shown_ || !shown_ || findings != shown_findings_) {
    shown_ = run_.result();
    shown_findings_ = findings;
    // A finger that an earlier version calibrated has no figures in its folder.
    zones_->setVisible(shown_ != nullptr || run_.state() != CalibrationState::kNone);
    zones_->setText(
        shown_
            ? zones_text()
            : MappingPage::tr("This finger is calibrated. Calibrate again to show the figures."));
    show_next_press();
    show_remarks();
  }
  show_folds();
  Q_EMIT changed();
}

QString VerdictPage::zones_text() const {
  QString words =
      tr("By zone of the face: %1.").arg(in_window_language(zone_sentence(shown_->zones)));
  const Message resolution = resolution_sentence(shown_->residuals, shown_->halo);
  if (!resolution.empty())
    words += QLatin1Char(' ') + tr("Resolution: %1.").arg(in_window_language(resolution));
  return words;
}

void VerdictPage::show_next_press() {
  next_->setVisible(shown_ != nullptr);
  if (!shown_) return;
  errors_->set_data(press_errors(shown_->calibration));
  mapping_->set_data(mapping_figure(shown_->calibration, shown_->residuals));
  const Calibration& calibration = shown_->calibration;
  FaceMapData data = face_figure(FaceQuantity::kCoverage, calibration, shown_->residuals,
                                 shown_->finger.face.kind);
  const auto& advice = calibration.next_press;
  if (!advice) {
    next_->setText(tr("These presses give no information on this."));
  } else {
    next_->setText(window_sentence(advice->sentence));
    if (!advice->enough) {
      const double r = shown_->inputs.press_set.ball_radius_mm, d = std::min(advice->depth_mm, r);
      data.contacts.push_back({advice->along_mm, advice->across_mm, std::sqrt(d * (2 * r - d)),
                               tr("press here next").toStdString(), true});
    }
  }
  face_->set_data(std::move(data));
}

void VerdictPage::show_remarks() {
  remarks_->clear();
  if (!shown_) return;
  if (known_ && run_.worth()) {
    const auto findings = findings_of(*known_, run_.worth()->evidence->contradictions);
    for (std::size_t i = kShownFindings; i < findings.size(); ++i)
      remarks_->addItem(window_sentence(findings[i]));
  }
  const Calibration& calibration = shown_->calibration;
  const auto add = [this](const Message& text) { remarks_->addItem(window_sentence(text)); };
  for (const Message& sign : shown_->fault_signs) add(sign);
  for (const Message& warning : shown_->about_settings) add(warning);
  for (const Message& warning : shown_->warnings) add(warning);
  for (const Message& reason : calibration.left_out) add(reason);
  for (const Message& remark : calibration.remarks)
    if (!calibration.next_press || remark != calibration.next_press->sentence) add(remark);
}

void VerdictPage::changeEvent(QEvent* event) {
  StepPage::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_status();
}

namespace {

constexpr int kSheetWidth = 600;         // px at 96 per inch: the width of a printed page
constexpr double kSheetSharpness = 3.0;  // pixels per sheet pixel: 288 per inch
constexpr std::size_t kMaxPresses = 12;

/// Builds one sheet from top to bottom.
class Sheet {
 public:
  Sheet(const FingerCalibration& done, const std::optional<FingerWorth>& now)
      : done_(done),
        now_(now),
        light_(theme_palette(Theme::kLight)),
        document_(VerdictPage::tr("Finger %1: verdict on its calibration")
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
    const Headline headline = headline_of(worth.grade, expected_error_mm(worth).value_or(0.0),
                                          is_known && now_->must_repeat,
                                          is_known ? now_->reference : ReferenceState::kIntact);
    QStringList lines;
    for (const Message& finding :
         findings_of(worth, is_known ? now_->evidence->contradictions : done_.contradictions))
      lines << window_sentence(finding);
    for (const Message& line : {worth.cause, worth.rests_on})
      if (!line.empty()) lines << window_sentence(line);
    document_.box(headline.text, lines.join(QLatin1Char('\n')),
                  meaning_colour(headline.meaning, light_));
    const auto seconds = unix_seconds(done_.inputs.date);
    const QString date =
        seconds ? moment_text(QDateTime::fromSecsSinceEpoch(static_cast<qint64>(*seconds)))
                : as_text(done_.inputs.date);
    const QString person = as_text(done_.inputs.press_set.operator_name);
    document_.paragraph(
        joined({VerdictPage::tr("%1, ball of radius %2 mm, %n press(es), AllTact %3", nullptr,
                                static_cast<int>(done_.calibration.balls.size()))
                    .arg(date, local_mm(done_.inputs.press_set.ball_radius_mm, 3),
                         as_text(done_.inputs.program_version)),
                person}));
    if (!done_.zones.empty())
      document_.paragraph(VerdictPage::tr("By zone of the face: %1.")
                              .arg(in_window_language(zone_sentence(done_.zones))));
    QStringList signs;
    for (const Message& sign : done_.fault_signs) signs << window_sentence(sign);
    if (!signs.isEmpty())
      document_.box(VerdictPage::tr("The presses show a fault"), signs.join(QLatin1Char('\n')),
                    meaning_colour(Meaning::kDoubtful, light_));
  }

  void add_figures() {
    MappingPlot mapping;
    mapping.set_data(mapping_figure(done_.calibration, done_.residuals));
    add(mapping, 220,
        VerdictPage::tr("From brightness to depth: each point is a block of pixels under a ball."));
    FaceMapPlot map;
    map.set_data(face_figure(FaceQuantity::kResidual, done_.calibration, done_.residuals,
                             done_.finger.face.kind));
    add(map, 180, VerdictPage::tr("Position on the face, and the mapping's error there."));
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
      rows.push_back({{as_text(ball.press)},
                      {local_mm(ball.depth_mm, 2)},
                      {error ? local_mm(*error, 3) : VerdictPage::tr("unknown")},
                      {error ? error_word(meaning_of_error(*error)) : QString()}});
    }
    document_.table({VerdictPage::tr("Press"), VerdictPage::tr("Depth (mm)"),
                     VerdictPage::tr("Error (mm)"), QString()},
                    rows, {false, true, true, false});
    const auto more = done_.calibration.balls.size() - rows.size();
    if (more > 0)
      document_.paragraph(
          VerdictPage::tr("%n more press(es) in the report.", nullptr, static_cast<int>(more)));
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

Document verdict_sheet(const FingerCalibration& done, const QString& command,
                       const std::optional<FingerWorth>& now) {
  return Sheet(done, now).written(command);
}

void print_sheet(const Document& sheet, QWidget& parent) {
  auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
  printer->setPageLayout(
      QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
  auto* dialog = new QPrintDialog(printer.get(), &parent);
  dialog->setWindowTitle(VerdictPage::tr("Print the verdict"));
  QObject::connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), dialog,
                   [sheet, printer](QPrinter* chosen) { sheet.print(*chosen); });
  // The dialog uses the printer as long as it lives.
  QObject::connect(dialog, &QObject::destroyed, [printer] {});
  show_dialog(*dialog);
}

namespace {

std::vector<PressesPoint> points_of(const CalibratingStudy& study) {
  const CalibratingChoice& now = study.rows.front().choice;
  std::vector<PressesPoint> points;
  for (const CalibratingRow& row : study.rows) {
    CalibratingChoice same = row.choice;
    same.presses = now.presses;
    if (!row.painted || !(same == now)) continue;
    PressesPoint point;
    point.presses = row.choice.presses;
    point.median_mm = row.painted->median_mm;
    point.p95_mm = row.painted->p95_mm;
    if (row.real) point.real_median_mm = row.real->depth.median_mm;
    point.is_current = row.choice == now;
    points.push_back(point);
  }
  std::sort(points.begin(), points.end(),
            [](const PressesPoint& a, const PressesPoint& b) { return a.presses < b.presses; });
  return points;
}

/// The painted presses depend on the calibration.
bool is_same_calibration(const FingerPtr& a, const FingerPtr& b) {
  if (!a || !b) return a == b;
  const MappingParameters &m = a->mapping->parameters(), &n = b->mapping->parameters();
  return a->folder == b->folder && m.x_max == n.x_max && m.chebyshev == n.chebyshev &&
         m.a_mm == n.a_mm && m.b == n.b;
}

}  // namespace

MoreDataBox::MoreDataBox(QWidget* parent)
    : Translated(parent),
      words_(wrapped_text()),
      plot_(new PressesPlot),
      start_(new QPushButton),
      bar_(new QProgressBar) {
  plot_->setMinimumHeight(150);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(plot_, 1);
  auto* line = new QHBoxLayout;
  line->addWidget(start_);
  line->addWidget(bar_, 1);
  line->addStretch();
  column->addLayout(line);
  connect(start_, &QPushButton::clicked, this, [this] {
    if (work_.is_running())
      work_.stop();
    else
      start();
  });
  connect(&work_, &BackgroundWork::progressed, this, &MoreDataBox::show_state);
  connect(&work_, &BackgroundWork::finished, this, &MoreDataBox::show_state);
  say([this] {
    setTitle(tr("Benefit of more data"));
    bar_->setAccessibleName(tr("Progress of the computation"));
    show_state();
  });
}

void MoreDataBox::set_finger(const FingerPtr& finger) {
  const FingerPtr calibrated = finger && finger->mapping ? finger : nullptr;
  if (!is_same_calibration(calibrated, finger_)) {
    work_.stop();
    study_.reset();
    problem_.reset();
    plot_->set_points({});
  }
  finger_ = calibrated;
  show_state();
}

void MoreDataBox::start() {
  if (!finger_) return;
  problem_.reset();
  work_.start([this, finger = finger_](const Job& job) -> std::function<void()> {
    CalibratingOptions how;
    how.quick = true;
    auto made = study_calibrating(finger, how, job);
    std::shared_ptr<const CalibratingStudy> study;
    std::optional<Error> problem;
    if (made)
      study = std::make_shared<const CalibratingStudy>(std::move(made).value());
    else if (!job.stop_requested())
      problem = made.error();
    return [this, finger, study, problem] {
      if (!is_same_calibration(finger, finger_)) return;
      study_ = study;
      problem_ = problem;
      plot_->set_points(study ? points_of(*study) : std::vector<PressesPoint>());
      show_state();
    };
  });
  show_state();
}

void MoreDataBox::show_state() {
  const bool is_running = work_.is_running();
  start_->setText(is_running ? tr("Sto&p") : tr("Compute no&w"));
  start_->setVisible(!study_);
  start_->setToolTip(tr("Calibrates with fewer and with painted presses; takes a minute"));
  bar_->setVisible(is_running);
  bar_->setValue(static_cast<int>(100 * work_.fraction()));
  plot_->setVisible(study_ != nullptr);
  if (problem_) {
    words_->setText(window_sentence(problem_->message()));
    return;
  }
  if (!study_) {
    words_->setText(
        tr("Benefit of one more press, more images of each, one more minute. The program paints "
           "balls into this finger's images and calibrates it with them."));
    return;
  }
  QStringList lines;
  for (const Message& sentence : benefit_of_more_data(*study_, study_->rows.front().choice))
    lines << window_sentence(sentence);
  if (lines.isEmpty()) lines << tr("No tested option improves the result.");
  words_->setText(lines.join(QLatin1Char('\n')));
}

PressesPlot::PressesPlot(QWidget* parent) : Plot(parent) {
  setAccessibleName(PressesPlot::title());
}

void PressesPlot::set_points(std::vector<PressesPoint> points) {
  points_ = std::move(points);
  QStringList words;
  for (const PressesPoint& point : points_)
    words << tr("%n press(es): %1 mm", nullptr, point.presses)
                 .arg(QLocale().toString(point.median_mm, 'f', 4));
  setAccessibleDescription(joined_clauses(words));
  rebuild();
}

QString PressesPlot::title() const { return tr("Depth error by number of presses"); }

QString PressesPlot::empty_text() const { return tr("Nothing is computed yet"); }

bool PressesPlot::draw() {
  if (points_.empty()) return false;
  const QColor painted = role_colour(ColourRole::kExpected, palette()),
               real = role_colour(ColourRole::kMeasured, palette());
  auto* line = chart().addGraph();
  auto* now = chart().addGraph();
  auto* pressed = chart().addGraph();
  auto* whiskers = new QCPErrorBars(chart().xAxis, chart().yAxis);
  whiskers->setDataPlottable(line);
  whiskers->setPen(QPen(painted));
  whiskers->removeFromLegend();
  double highest = 0, tallest = 0;
  for (const PressesPoint& point : points_) {
    const double presses = point.presses;
    line->addData(presses, point.median_mm);
    whiskers->addData(0, point.p95_mm - point.median_mm);
    if (point.is_current) now->addData(presses, point.median_mm);
    if (point.real_median_mm) pressed->addData(presses, *point.real_median_mm);
    // A single press may be far off and would squash the others.
    if (point.presses > 2 || points_.size() < 3) tallest = std::max(tallest, point.p95_mm);
    highest = std::max(highest, point.p95_mm);
  }
  line->setName(tr("painted balls, whisker to 95 %"));
  line->setPen(QPen(painted, 2));
  line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, painted, 7));
  now->setName(tr("current presses"));
  now->setLineStyle(QCPGraph::lsNone);
  now->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(palette().text().color(), 2),
                                       Qt::NoBrush, 13));
  pressed->setName(tr("real presses left out"));
  pressed->setLineStyle(QCPGraph::lsNone);
  pressed->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(real, 2), Qt::NoBrush, 8));
  if (pressed->data()->isEmpty()) pressed->removeFromLegend();
  chart().xAxis->setRange(points_.front().presses - 0.5, points_.back().presses + 0.5);
  auto integer_ticks = QSharedPointer<QCPAxisTickerFixed>::create();
  integer_ticks->setTickStep(1);
  integer_ticks->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  chart().xAxis->setTicker(integer_ticks);
  chart().xAxis->setLabel(tr("Presses"));
  chart().yAxis->setRange(0, 1.1 * std::max(tallest > 0 ? tallest : highest, 1e-6));
  chart().yAxis->setLabel(tr("Depth error (mm)"));
  show_legend();
  return true;
}

}  // namespace alltact
